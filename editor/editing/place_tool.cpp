#include "editor/editing/place_tool.h"

#include "core/game/ship.h"
#include "editor/editing/place_gestures.h"
#include "editor/editing/snap_point.h"
#include "editor/editing/typed_point.h"

#include <utility>

namespace spacetow {

namespace {

/// The outline of what a click would put down.
Overlay ghost(PlaceKind kind, const Level& level, const Vec2& position) {
    Overlay overlay;
    overlay.points.push_back({OverlayStyle::Snap, position});
    if (kind == PlaceKind::Ship) {
        const Transform pose{position, Rot::fromAngle(shipAt(level, position).angle)};
        std::vector<Vec2> hull = shipHull().vertices;
        for (Vec2& corner : hull) {
            corner = pose.toWorld(corner);
        }
        overlay.lines.push_back({OverlayStyle::Draft, std::move(hull), true});
    } else if (kind == PlaceKind::Payload) {
        overlay.circles.push_back({OverlayStyle::Draft, position, payloadAt(level, position).radius});
    }
    return overlay;
}

FinishedEdit finished(LabelCode label, Edit placed) {
    return {{label, 1}, std::move(placed)};
}

} // namespace

std::string PlaceTool::code() const {
    switch (m_kind) {
    case PlaceKind::Ship:
        return "ship";
    case PlaceKind::Payload:
        return "payload";
    case PlaceKind::Finish:
        break;
    }
    return "finish";
}

std::unique_ptr<Gesture> PlaceTool::press(const ToolContext& context, const Pointer& pointer) {
    switch (m_kind) {
    case PlaceKind::Ship:
        return turnShip(context, pointer);
    case PlaceKind::Payload:
        return carryPayload(context);
    case PlaceKind::Finish:
        break;
    }
    return m_finishStart ? nullptr : drawFinish(context, pointer);
}

std::optional<FinishedEdit> PlaceTool::click(const ToolContext& context, const Pointer& pointer) {
    const Vec2 position = snapAt(context, pointer)->point;
    const Level& level = *context.edit.level;
    switch (m_kind) {
    case PlaceKind::Ship:
        return finished("place-ship", withPlaced(context, shipAt(level, position)));
    case PlaceKind::Payload:
        return finished("place-payload", withPlaced(context, payloadAt(level, position)));
    case PlaceKind::Finish:
        break;
    }
    return clickFinish(context, pointer);
}

std::optional<FinishedEdit> PlaceTool::clickFinish(const ToolContext& context, const Pointer& pointer) {
    if (!m_finishStart) {
        m_finishStart = snapAt(context, pointer)->point;
        return {};
    }
    const Vec2 end = pointFrom(context, *m_finishStart, pointer);
    m_tooShort = end == *m_finishStart;
    if (m_tooShort) {
        return {};
    }
    Edit placed = withPlaced(context, FinishObject{*m_finishStart, end});
    cancel();
    return finished("place-finish", std::move(placed));
}

std::optional<FinishedEdit> PlaceTool::key(const ToolContext&, ToolKey key, const Pointer&) {
    if (key == ToolKey::Backspace || key == ToolKey::Delete) {
        cancel();
    }
    return {};
}

std::optional<TypedMeasures> PlaceTool::measures(const ToolContext& context, const Pointer& pointer) const {
    if (!m_finishStart) {
        return {};
    }
    return polarMeasures(TypedKind::LengthAngle, pointFrom(context, *m_finishStart, pointer) - *m_finishStart);
}

void PlaceTool::hover(const ToolContext& context, const Pointer& pointer) {
    m_tooShort = m_tooShort && pointFrom(context, *m_finishStart, pointer) == *m_finishStart;
}

void PlaceTool::cancel() {
    m_finishStart.reset();
    m_tooShort = false;
}

Overlay PlaceTool::overlay(const ToolContext& context, const Pointer& pointer) const {
    if (m_finishStart) {
        return finishOverlay(*m_finishStart, pointFrom(context, *m_finishStart, pointer));
    }
    return ghost(m_kind, *context.edit.level, snapAt(context, pointer)->point);
}

std::optional<SnapAnswer> PlaceTool::snapAt(const ToolContext& context, const Pointer& pointer) const {
    switch (m_kind) {
    case PlaceKind::Ship:
        return placeSnap<ShipObject>(context, pointer);
    case PlaceKind::Payload:
        return placeSnap<PayloadObject>(context, pointer);
    case PlaceKind::Finish:
        break;
    }
    return m_finishStart ? snapFrom(context, pointer, *m_finishStart) : placeSnap<FinishObject>(context, pointer);
}

Hint PlaceTool::hint(const ToolContext& context, const Pointer& pointer) const {
    if (m_tooShort) {
        return {"place-finish.too-short", {}};
    }
    if (m_finishStart) {
        return finishHint(*m_finishStart, pointFrom(context, *m_finishStart, pointer));
    }
    switch (m_kind) {
    case PlaceKind::Ship:
        return {"place-ship.start", {}};
    case PlaceKind::Payload:
        return {"place-payload.start", {}};
    case PlaceKind::Finish:
        break;
    }
    return {"place-finish.start", {}};
}

} // namespace spacetow
