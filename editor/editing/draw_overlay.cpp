#include "editor/editing/draw_overlay.h"

#include "editor/editing/measure.h"

#include <algorithm>
#include <utility>

namespace spacetow {

OverlayText measureText(const Vec2& from, const Vec2& to) {
    const Vec2 way = to - from;
    return {to, lengthText(way.norm()) + " m  " + degreesText(directionOf(way)) + "°"};
}

Overlay draftOverlay(const Draft& draft) {
    Overlay overlay;
    if (draft.points.empty()) {
        overlay.points.push_back({OverlayStyle::Snap, draft.next});
        return overlay;
    }
    std::vector<Vec2> outline = draft.points;
    if (!draft.closes) {
        outline.push_back(draft.next);
    }
    const bool closed = draft.closes || (draft.fills && outline.size() > 2);
    if (draft.walls != DraftWalls::None) {
        // A wall is solid for what comes from its left: its material lies to the right of the way it was drawn.
        std::vector<Vec2> walls = outline;
        if (draft.walls == DraftWalls::Against) {
            std::ranges::reverse(walls);
        }
        overlay.lines.push_back({OverlayStyle::SolidSide, std::move(walls), closed, draft.depth});
    }
    overlay.lines.push_back({OverlayStyle::Draft, std::move(outline), closed});
    for (const auto& [a, b] : draft.crossing) {
        overlay.lines.push_back({OverlayStyle::Fault, {a, b}});
    }
    for (std::size_t i = 0; i < draft.points.size(); ++i) {
        const bool hot = i == 0 && draft.closes;
        overlay.points.push_back({hot ? OverlayStyle::HotHandle : OverlayStyle::Handle, draft.points[i]});
    }
    if (draft.ring) {
        overlay.points.push_back({OverlayStyle::HotHandle, *draft.ring});
    } else if (!draft.closes) {
        overlay.points.push_back({OverlayStyle::Snap, draft.next});
    }
    if (draft.next != draft.points.back()) {
        overlay.texts.push_back(measureText(draft.points.back(), draft.next));
    }
    return overlay;
}

} // namespace spacetow
