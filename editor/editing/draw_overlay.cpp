#include "editor/editing/draw_overlay.h"

#include "editor/editing/measure.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace spacetow {

namespace {

constexpr double strokePixels = 7;  // length of a stroke on the solid side
constexpr double strokeEvery = 14;  // pixels between strokes
constexpr double mostStrokes = 400; // a segment, however far out it reaches

/// A wall is solid for what comes from its left: its material lies to the right of the way it was drawn.
void addSolidSide(Overlay& overlay, const Vec2& a, const Vec2& b, double pixel) {
    const Vec2 way = b - a;
    const double length = way.norm();
    if (length == 0) {
        return;
    }
    const Vec2 along = way / length;
    const Vec2 stroke = (-leftOf(along) - along) * (strokePixels * pixel / std::sqrt(2.0));
    const double step = std::max(strokeEvery * pixel, length / mostStrokes);
    for (double at = step / 2; at < length; at += step) {
        const Vec2 foot = a + along * at;
        overlay.lines.push_back({OverlayStyle::SolidSide, {foot, foot + stroke}});
    }
}

} // namespace

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
        for (std::size_t i = 0; i + 1 < outline.size() || (closed && i < outline.size()); ++i) {
            const Vec2& a = outline[i];
            const Vec2& b = outline[(i + 1) % outline.size()];
            const bool along = draft.walls == DraftWalls::Along;
            addSolidSide(overlay, along ? a : b, along ? b : a, draft.pixel);
        }
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
