#pragma once
// Levels made at random, with every kind of object and every field somewhere away from its default.

#include "core/base/random.h"
#include "core/level/level.h"

namespace spacetow::test {

/// About `objects` objects. Every level can be written and read; lint may find plenty.
Level randomLevel(std::uint64_t seed, int objects = 12);

/// Likewise with coordinates as people draw them, and without what could only be written by hand: connectors that hold
/// no bodies, or two ships. Two boxes that overlap, both called "box", come last. The same seed gives the same level
/// again, sharing nothing with the first.
Level soundLevel(std::uint64_t seed, int objects = 16);

/// One object of every type and one shape of every kind, every field away from its default.
Level populatedLevel();

} // namespace spacetow::test
