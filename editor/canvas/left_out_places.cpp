#include "editor/canvas/left_out_places.h"

#include <algorithm>

namespace spacetow {

void LeftOutPlaces::forget(const Frame2D& frame, const QRegion& region) {
    constexpr double most = 1e6; // px; what is further away is as far
    const QRect all = frame.all();
    std::erase_if(m_dots, [&](const Vec2& dot) {
        const Vec2 device = frame.view.toScreen(dot) * frame.pixelRatio;
        const QPoint pixel(static_cast<int>(std::clamp(device.x(), -most, most)),
                           static_cast<int>(std::clamp(device.y(), -most, most)));
        return !all.contains(pixel) || region.contains(pixel);
    });
    m_names = m_names && region.isEmpty();
}

void LeftOutPlaces::add(const OverlayGaps& gaps) {
    m_dots.insert(m_dots.end(), gaps.dots.begin(), gaps.dots.end());
    m_names = m_names || gaps.names;
}

LeftOut LeftOutPlaces::in(const Viewport& view) const {
    const Aabb visible = view.visible();
    const auto isSeen = [&](const Vec2& dot) { return visible.contains(dot); };
    return {.dots = std::ranges::any_of(m_dots, isSeen), .names = m_names};
}

} // namespace spacetow
