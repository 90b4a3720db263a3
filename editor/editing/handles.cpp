#include "editor/editing/handles.h"

#include "core/level/arrange.h"
#include "editor/editing/transform_gestures.h"
#include "editor/editing/verbs.h"

#include <algorithm>

namespace spacetow {

namespace {

constexpr double outside = 10; // px, of a handle from the bounds
constexpr double reach = 7;    // px, from a handle to a pointer that means it
constexpr double roomy = 42;   // px; a pivot on something that is no longer takes too much of it
constexpr double flat = 1e-9;  // m; what is no longer than this cannot be scaled

bool hasSize(const Object& object) {
    return std::holds_alternative<BodyObject>(object.data) || std::holds_alternative<PayloadObject>(object.data) ||
           std::holds_alternative<FinishObject>(object.data);
}

bool isBall(const Object& object) {
    const auto* body = std::get_if<BodyObject>(&object.data);
    return std::holds_alternative<PayloadObject>(object.data) ||
           (body != nullptr && body->shapes.size() == 1 && std::holds_alternative<Circle>(body->shapes.front()));
}

bool isPlaced(const Object& object) {
    return !std::holds_alternative<ConnectorObject>(object.data) && !std::holds_alternative<GroupObject>(object.data);
}

} // namespace

HandleFrame handleFrame(const ToolContext& context) {
    const Level& level = *context.edit.level;
    const std::vector<Key> keys = unlockedKeys(level, context.edit.selection.keys());
    HandleFrame frame;
    frame.box = placedBounds(level, keys);
    if (frame.box.isEmpty()) {
        return frame;
    }
    frame.pivot = turningPoint(context).value_or(frame.box.center());
    int placed = 0;
    bool balls = true;
    for (const Key key : keys) {
        const Object& object = *level.objects.find(key);
        frame.scales = frame.scales || hasSize(object);
        placed += isPlaced(object) ? 1 : 0;
        balls = balls && (isBall(object) || !isPlaced(object));
    }
    frame.keepsShape = balls && placed == 1;
    return frame;
}

Vec2 pointOf(const Aabb& box, const HandleSide& side) {
    const auto along = [&](int axis, int where) {
        return where < 0 ? box.min[axis] : where > 0 ? box.max[axis] : box.center()[axis];
    };
    return {along(0, side.x), along(1, side.y)};
}

std::vector<Handle> handlesOf(const HandleFrame& frame, HandleMode mode, double pixel) {
    std::vector<Handle> handles;
    if (frame.box.isEmpty() || (mode == HandleMode::Scale && !frame.scales)) {
        return handles;
    }
    const Aabb around = frame.box.grown(outside * pixel);
    for (int y = -1; y <= 1; ++y) {
        for (int x = -1; x <= 1; ++x) {
            const HandleSide side{x, y};
            const bool stretches = (x == 0 || frame.box.size().x() > flat) && (y == 0 || frame.box.size().y() > flat);
            if (!side.isPivot() && (mode == HandleMode::Scale ? stretches : side.isCorner())) {
                handles.push_back({side, pointOf(around, side)});
            }
        }
    }
    if (mode == HandleMode::Turn || (mode == HandleMode::TurnAtOnce && !around.contains(frame.pivot))) {
        handles.push_back({{0, 0}, frame.pivot});
    }
    return handles;
}

bool coversSelection(const HandleFrame& frame, double pixel) {
    return frame.box.size().maxCoeff() < roomy * pixel && frame.box.grown(outside * pixel).contains(frame.pivot);
}

std::optional<Handle> handleAt(const HandleFrame& frame, HandleMode mode, const Pointer& pointer) {
    std::optional<Handle> nearest;
    const bool takesPivot = pointer.modifiers.shift || !coversSelection(frame, pointer.pixel);
    double distance = reach * pointer.pixel;
    for (const Handle& handle : handlesOf(frame, mode, pointer.pixel)) {
        const double away = (handle.at - pointer.world).norm();
        if (away <= distance && (takesPivot || !handle.side.isPivot())) {
            nearest = handle;
            distance = away;
        }
    }
    return nearest;
}

std::unique_ptr<Gesture> dragOf(const Handle& handle, HandleMode mode, const ToolContext& context,
                                const Pointer& start) {
    const HandleDrag drag{context, handleFrame(context), handle.side, start.world};
    if (mode == HandleMode::Scale) {
        return std::make_unique<ScaleGesture>(drag);
    }
    if (handle.side.isPivot()) {
        return std::make_unique<PivotGesture>(drag);
    }
    return std::make_unique<TurnGesture>(drag);
}

Overlay handleOverlay(const HandleFrame& frame, HandleMode mode, double pixel, const std::optional<Handle>& hot) {
    Overlay overlay;
    for (const Handle& handle : handlesOf(frame, mode, pixel)) {
        const bool isHot = hot && hot->side == handle.side;
        const OverlayStyle style = handle.side.isPivot()       ? OverlayStyle::Pivot
                                   : mode == HandleMode::Scale ? OverlayStyle::Handle
                                                               : OverlayStyle::TurnHandle;
        overlay.points.push_back({isHot && !handle.side.isPivot() ? OverlayStyle::HotHandle : style, handle.at});
    }
    return overlay;
}

CursorShape handleCursor(const Handle& handle, HandleMode mode) {
    if (mode != HandleMode::Scale) {
        return handle.side.isPivot() ? CursorShape::Move : CursorShape::Pointing;
    }
    if (handle.side.isCorner()) {
        return handle.side.x == handle.side.y ? CursorShape::SizeRising : CursorShape::SizeFalling;
    }
    return handle.side.x != 0 ? CursorShape::SizeAcross : CursorShape::SizeUpright;
}

Hint handleHint(const Handle& handle, HandleMode mode) {
    if (mode == HandleMode::Scale) {
        return {"select.scale-handle", {}};
    }
    return {handle.side.isPivot() ? "select.pivot-handle" : "select.turn-handle", {}};
}

} // namespace spacetow
