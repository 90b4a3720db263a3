#pragma once
// Whether so many bodies lie in the same place that the pairs of them would not fit into memory: n bodies at one point
// are n²/2 pairs, of almost a kilobyte each.

#include "core/physics/world/world.h"

#include <cstdint>

namespace spacetow {

constexpr std::int64_t mostCrowdedPairs = 1'500'000; // somewhat more than a gigabyte

/// Whether more pairs of bodies than this have boxes that overlap, one of them being moved by the physics. Bodies of
/// many parts count for little of what they may meet, so they are left out. Cost: n log n, and the pairs up to `most`.
bool isCrowded(const World& world, std::int64_t most = mostCrowdedPairs);
/// Before each of many updates: looked for before every 50th, so before the first one.
bool isCrowdedAt(std::int64_t update, const World& world);

} // namespace spacetow
