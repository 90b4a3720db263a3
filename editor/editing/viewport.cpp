#include "editor/editing/viewport.h"

#include <algorithm>

namespace spacetow {

namespace {

constexpr double margin = 0.9; // share of the view that a box to be shown may fill

} // namespace

Vec2 Viewport::toScreen(const Vec2& world) const {
    return transform().toView(world);
}

Vec2 Viewport::toWorld(const Vec2& screen) const {
    return transform().toWorld(screen);
}

Aabb Viewport::visible() const {
    const Vec2 half = size / (2 * scale);
    return {center - half, center + half};
}

Viewport Viewport::zoomedAt(const Vec2& screen, double factor) const {
    Viewport zoomed = *this;
    // Also keeps a factor that is no number from becoming a scale.
    if (factor > 0) {
        zoomed.scale = std::clamp(scale * factor, minScale, maxScale);
    }
    zoomed.center += toWorld(screen) - zoomed.toWorld(screen);
    return zoomed;
}

Viewport Viewport::panned(const Vec2& pixels) const {
    Viewport shifted = *this;
    shifted.center += Vec2(-pixels.x(), pixels.y()) / scale;
    return shifted;
}

Viewport Viewport::showing(const Aabb& box) const {
    Viewport view;
    view.size = size;
    if (box.isEmpty() || !isFinite(box.min) || !isFinite(box.max)) {
        return view;
    }
    view.center = box.center();
    const Vec2 extent = box.size();
    if (extent.x() > 0 || extent.y() > 0) {
        const double across = extent.x() > 0 ? size.x() / extent.x() : maxScale;
        const double up = extent.y() > 0 ? size.y() / extent.y() : maxScale;
        view.scale = std::clamp(margin * std::min(across, up), minScale, maxScale);
    }
    return view;
}

} // namespace spacetow
