#pragma once
// Which objects of a level would collide, by what they are and touch; wherever they are.

#include "core/level/level.h"

#include <optional>
#include <span>
#include <vector>

namespace spacetow {

/// What the object is and touches in a game. Connectors and groups have none.
std::optional<Filter> filterOf(const Object& object);

/// The objects that have the tag, ascending.
std::vector<Key> keysTagged(const Level& level, int tag);

/// The objects that would collide with, or be felt by, one of those named by `keys`; ascending. As in the game two
/// bodies of walls pass through each other, and so do bodies that never move, and bodies joined by a connector that
/// keeps them from colliding. Linear in the objects, for a handful of different filters.
std::vector<Key> collidingWith(const Level& level, std::span<const Key> keys);

} // namespace spacetow
