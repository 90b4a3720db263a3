#pragma once
// The contacts of a world as they are now: where bodies touch or are about to, and with which impulses the last
// iteration kept them apart. Nothing of the world is changed.

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
    double tangentImpulse = 0; // N s, likewise; to the left of the normal it pushes b
    bool touching = false;     // else the surfaces are merely so near that the solver watches them
    int count = 0;             // of points
    std::array<Point, 2> points;
};

/// All contacts whose points are in `area`, in the order of their pairs, then those of bodies that sleep. From the
/// manifolds that the solver keeps, where it keeps one.
std::vector<ContactManifold> contactManifolds(const World& world, const std::optional<Aabb>& area = {});

} // namespace spacetow
