#pragma once
// The contact manifolds of a world after an update: contact points, and the impulses of the last iteration. Reading
// them does not change the world. SI units.

#include "core/math/aabb.h"
#include "core/physics/world/world.h"

#include <array>
#include <optional>
#include <vector>

namespace spacetow {

struct ContactManifold {
    struct Point {
        Vec2 at{0, 0};            // world
        double normalImpulse = 0; // N s, of the last iteration
    };
    BodyId a, b;
    Vec2 normal{0, 1};         // unit, from a to b
    double tangentImpulse = 0; // N s, of the last iteration, on b; positive to the left of `normal`
    bool touching = false;     // false: a speculative contact, within the margin but apart
    int count = 0;             // of points
    std::array<Point, 2> points;
};

/// The contacts with a point in `area`, or all: first those of awake bodies, then those of sleeping ones, each in the
/// order of the pair table. A manifold that the engine keeps is returned as it is; others are computed here.
std::vector<ContactManifold> contactManifolds(const World& world, const std::optional<Aabb>& area = {});

} // namespace spacetow
