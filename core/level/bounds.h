#pragma once
// How much room the objects of a level take, in world coordinates (m).

#include "core/level/level.h"
#include "core/math/aabb.h"

namespace spacetow {

/// Bounds of one object (walls without their depth, the ship by its outline, connectors by their anchors; empty when
/// an end is missing).
Aabb boundsOf(const Level& level, const Object& object);
/// Of everything in the level; empty for an empty level.
Aabb boundsOf(const Level& level);

} // namespace spacetow
