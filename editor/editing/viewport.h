#pragma once
// The part of the world that is in view, and how the user moves and zooms it.

#include "core/math/aabb.h"
#include "core/math/view_transform.h"

namespace spacetow {

class Viewport {
  public:
    static constexpr double minScale = 1e-4; // pixels a metre: all of the largest level fits into the smallest view
    static constexpr double maxScale = 20000;

    Vec2 center{0, 0};   // world point in the middle of the view
    double scale = 66;   // logical pixels a metre, the same on both axes
    Vec2 size{880, 660}; // of the view, logical pixels

    ViewTransform transform() const { return {center, scale, size}; }
    Vec2 toScreen(const Vec2& world) const;
    Vec2 toWorld(const Vec2& screen) const;
    Aabb visible() const;
    double pixel() const { return 1 / scale; } // m

    /// Zoomed by `factor` with the world point under `screen` staying there; the scale stays within its limits.
    Viewport zoomedAt(const Vec2& screen, double factor) const;
    /// Shifted so that the world follows a drag by `pixels`.
    Viewport panned(const Vec2& pixels) const;
    /// The box in the middle, as large as fits with a margin; an empty box gives the default view.
    Viewport showing(const Aabb& box) const;
};

} // namespace spacetow
