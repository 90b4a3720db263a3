#pragma once
// Which objects lie under a point or in a box.

#include "core/level/level.h"
#include "core/math/aabb.h"

#include <vector>

namespace spacetow {

/// Keys of the objects within `tolerance` metres of the point: outlines count by distance, filled shapes inside too.
/// The best pick comes first: things like ship and payload before walls, small before large, later before earlier.
std::vector<Key> picked(const Level& level, const Vec2& point, double tolerance);
/// Keys of the objects that touch the box, or that lie wholly inside it, in the order of the level.
std::vector<Key> pickedIn(const Level& level, const Aabb& box, bool wholly);

} // namespace spacetow
