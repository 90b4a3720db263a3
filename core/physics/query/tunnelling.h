#pragma once
// How near bodies come to passing through a wall in one iteration. The engine stops what is fast where it first meets
// something; the band behind a wall is what is left when that cannot be, as when a body is put somewhere or pushed by
// another. A wall is the safer the deeper it is against the way that a body goes in an iteration:
//
//     risk = greatest approach speed · seconds / iterations / depth
//
// The approach speed of a body is the part of its velocity that points at the solid side, −n·v. Counted are the bodies
// that may touch the wall by their tags and that come near it: whose box, carried along for a second, meets the wall's.
// From 1 on one iteration may carry a body through the whole band. Walls without end behind them, and lines, have none.

#include "core/math/aabb.h"
#include "core/physics/world/world.h"

#include <optional>
#include <vector>

namespace spacetow {

struct WallRisk {
    BodyId body;      // of which the wall is a part
    Vec2 a, b;        // world
    double speed = 0; // m/s, > 0: with which something approaches it
    double risk = 0;
};

/// Of all walls in `area` that something approaches.
std::vector<WallRisk> wallRisks(const World& world, const std::optional<Aabb>& area = {});

} // namespace spacetow
