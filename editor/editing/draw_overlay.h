#pragma once
// What is seen of a shape while it is drawn: its outline up to the pointer, its points, length and angle of the next
// segment, and for one-way walls the shade of their solid side.

#include "editor/editing/overlay.h"

#include <array>
#include <optional>
#include <vector>

namespace spacetow {

/// Of the walls being drawn, which side is solid: that to the right of the way in which they run.
enum class DraftWalls : std::uint8_t {
    None,
    Along,   // they run from the first point to the last
    Against, // a chain that is drawn on from where it begins
};

struct Draft {
    std::vector<Vec2> points; // placed so far, world
    Vec2 next;                // where the next one will land
    bool closes = false;      // the next click closes the shape
    bool fills = false;       // a polygon: the way back to the first point is shown too
    DraftWalls walls = DraftWalls::None;
    double depth = 0;                               // m, of the walls; may be without end
    double pixel = 0.01;                            // m
    std::optional<Vec2> ring = {};                  // a point of another chain at which the next click closes it
    std::vector<std::array<Vec2, 2>> crossing = {}; // sides that meet others
};

Overlay draftOverlay(const Draft& draft);

/// Length and angle of a segment, beside its end.
OverlayText measureText(const Vec2& from, const Vec2& to);

} // namespace spacetow
