#include "editor/editing/handles.h"

#include "core/level/arrange.h"
#include "core/level/object_geometry.h"
#include "editor/editing/transform_gestures.h"
#include "editor/editing/verbs.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace spacetow {

namespace {

constexpr double outside = 10; // px, of a handle from the bounds
constexpr double reach = 7;    // px, from a handle to a pointer that means it
constexpr double roomy = 42;   // px; a pivot on something that is no longer takes too much of it
constexpr double flat = 1e-9;  // m; what is no longer than this cannot be scaled
constexpr double noSlant = 1e-9;

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

/// The body whose sides the handles follow: one alone that is turned, and not by quarters, which have no other sides.
const BodyObject* turnedBody(const Level& level, const std::vector<Key>& keys) {
    constexpr double quarter = std::numbers::pi / 2;
    const Object* object = keys.size() == 1 ? level.objects.find(keys.front()) : nullptr;
    const auto* body = object != nullptr ? std::get_if<BodyObject>(&object->data) : nullptr;
    const bool slants = body != nullptr && !isBall(*object) && std::abs(std::remainder(body->angle, quarter)) > noSlant;
    return slants ? body : nullptr;
}

Aabb boundsIn(const Rot& axes, BodyObject body) {
    body.angle = 0;
    body.position = axes.inverse() * body.position;
    return ownBounds(body);
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
    if (const BodyObject* body = turnedBody(level, keys)) {
        frame.turn = Rot::fromAngle(body->angle);
        frame.box = boundsIn(frame.turn, *body);
    }
    frame.pivot = turningPoint(context).value_or(pointOf(frame, {}));
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

Vec2 pointOf(const HandleFrame& frame, const HandleSide& side) {
    return frame.turn * pointOf(frame.box, side);
}

Affine scalingIn(const HandleFrame& frame, const Vec2& fixed, const Vec2& factors) {
    const auto scaled = [&](const Vec2& way) {
        return frame.turn * Vec2(factors.cwiseProduct(frame.turn.inverse() * way));
    };
    return Affine::about(fixed, scaled({1, 0}), scaled({0, 1}));
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
                handles.push_back({side, frame.turn * pointOf(around, side)});
            }
        }
    }
    if (mode == HandleMode::Turn ||
        (mode == HandleMode::TurnAtOnce && !around.contains(frame.turn.inverse() * frame.pivot))) {
        handles.push_back({{0, 0}, frame.pivot});
    }
    return handles;
}

bool coversSelection(const HandleFrame& frame, double pixel) {
    return frame.box.size().maxCoeff() < roomy * pixel &&
           frame.box.grown(outside * pixel).contains(frame.turn.inverse() * frame.pivot);
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

CursorShape handleCursor(const HandleSide& side, HandleMode mode, const Rot& turn) {
    if (mode != HandleMode::Scale) {
        return side.isPivot() ? CursorShape::Move : CursorShape::Pointing;
    }
    static constexpr CursorShape arrows[] = {CursorShape::SizeAcross, CursorShape::SizeRising, CursorShape::SizeUpright,
                                             CursorShape::SizeFalling};
    const Vec2 way = turn * Vec2(side.x, side.y);
    const auto eighths = std::lround(std::atan2(way.y(), way.x()) / (std::numbers::pi / 4));
    return arrows[(eighths + 4) % 4];
}

Hint handleHint(const Handle& handle, HandleMode mode) {
    if (mode == HandleMode::Scale) {
        return {"select.scale-handle", {}};
    }
    return {handle.side.isPivot() ? "select.pivot-handle" : "select.turn-handle", {}};
}

} // namespace spacetow
