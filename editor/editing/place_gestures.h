#pragma once
// Placing the ship, the payload and the finish: the drags, and the level with the thing in its place.

#include "editor/editing/snap_point.h"

namespace spacetow {

/// The ship as it is to start; one that is in the level keeps its angle.
ShipObject shipAt(const Level& level, const Vec2& position);
/// The payload; one that is in the level keeps its size and mass.
PayloadObject payloadAt(const Level& level, const Vec2& position);
/// The level with `data` placed, and it selected. `data` is a ship, a payload or a finish.
Edit withPlaced(const ToolContext& context, ObjectData data);

/// Where that would land. It may stand in the level already and does not snap to itself.
template <class T>
SnapAnswer placeSnap(const ToolContext& context, const Pointer& pointer) {
    const Object* old = firstOf<T>(*context.edit.level);
    const SnapSubject subject{.keys = old == nullptr ? std::vector<Key>() : std::vector{old->key}};
    return DraggedSnap(context, subject, pointer.world).to(pointer.world, pointer);
}

std::unique_ptr<Gesture> turnShip(const ToolContext& context, const Pointer& start);
std::unique_ptr<Gesture> carryPayload(const ToolContext& context);
std::unique_ptr<Gesture> drawFinish(const ToolContext& context, const Pointer& start);

/// What a finish from `start` looks like and says while its other end follows the pointer.
Overlay finishOverlay(const Vec2& start, const Vec2& end);
Hint finishHint(const Vec2& start, const Vec2& end);

} // namespace spacetow
