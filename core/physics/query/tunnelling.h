#pragma once
// The risk that a body tunnels through a wall. The engine stops fast bodies at their time of impact. Where that cannot
// help, as when a body is placed by a call or pushed by another body, the solid band behind the wall still pushes the
// body out. The band must be deep compared with the motion of the body in one iteration:
//
//     risk = greatest approach speed · seconds / iterations / depth
//
// The approach speed is −n·v, with n the wall's normal and v the velocity of the body. Bodies count if their filter
// admits the wall and their AABB, swept along the velocity for one second, overlaps the wall's. From a risk of 1 on
// one iteration can carry a body through the whole band. Lines, walls of infinite depth, sensors and inactive bodies
// have no risk.

#include "core/math/aabb.h"
#include "core/physics/world/world.h"

#include <optional>
#include <vector>

namespace spacetow {

struct WallRisk {
    BodyId body;      // of which the wall is a part
    Vec2 a, b;        // world
    double speed = 0; // m/s, > 0: greatest approach speed
    double risk = 0;
};

/// The risk of every wall in `area`, or in the world, that a body approaches.
std::vector<WallRisk> wallRisks(const World& world, const std::optional<Aabb>& area = {});

} // namespace spacetow
