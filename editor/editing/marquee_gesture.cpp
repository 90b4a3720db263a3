#include "editor/editing/marquee_gesture.h"

namespace spacetow {

void MarqueeGesture::follow(const Pointer& pointer) {
    constexpr double apart = 3; // px
    if (isLasso() && (pointer.world - m_way.back()).norm() > apart * pointer.pixel) {
        m_way.push_back(pointer.world);
    }
}

std::vector<Vec2> MarqueeGesture::lineAt(const Pointer& pointer) const {
    const Vec2& to = pointer.world;
    if (isLasso()) {
        std::vector<Vec2> line = m_way;
        line.push_back(to);
        return line;
    }
    const Vec2& from = m_way.front();
    return {from, {to.x(), from.y()}, to, {from.x(), to.y()}};
}

Aabb MarqueeGesture::boxAt(const Pointer& pointer) const {
    Aabb box;
    for (const Vec2& point : lineAt(pointer)) {
        box.include(point);
    }
    return box;
}

Overlay MarqueeGesture::overlay(const Pointer& pointer) const {
    Overlay overlay;
    overlay.lines.push_back({OverlayStyle::Band, lineAt(pointer), true});
    return overlay;
}

} // namespace spacetow
