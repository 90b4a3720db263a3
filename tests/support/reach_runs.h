#pragma once
// Flights with random keys, and whether they end where the reach says that they can.

#include "core/base/random.h"
#include "core/game/session.h"

#include <cstdint>
#include <vector>

namespace spacetow::test {

/// Gravity, and payload and finish where nobody comes to them.
Level reachSpace(const Vec2& payload = Vec2(500, 0));
Session onTheRope();
/// With all keys but the rope's.
void steerAtRandom(Session& session, Random& random, int updates);
/// Of a convex outline, anticlockwise; to a billionth of a metre.
bool isWithin(const std::vector<Vec2>& outline, const Vec2& point);
/// Of a ship that waits, flies or tows, steered at random for a while: what is on the rope counts as well.
bool endsWithinItsReach(std::uint64_t seed);

} // namespace spacetow::test
