#pragma once
// Worlds in which bodies may fall asleep.

#include "core/physics/world/world.h"
#include "tests/support/bodies.h"

#include <algorithm>
#include <vector>

namespace spacetow::test {

inline World sleepyWorld(int iterations = 20) {
    World world({.iterations = iterations});
    world.setSleeping(true);
    return world;
}

inline void runUpdates(World& world, int updates) {
    for (int i = 0; i < updates; ++i) {
        world.update();
    }
}

inline int sleepers(const World& world) {
    const std::vector<BodyId> ids = world.bodies();
    return static_cast<int>(std::count_if(ids.begin(), ids.end(), [&](BodyId id) { return world.body(id).asleep; }));
}

/// Until nobody falls asleep any more, at most so many seconds.
inline bool runUntilAsleep(World& world, int bodies, double seconds = 20) {
    for (int i = 0; i < seconds * 50; ++i) {
        if (sleepers(world) == bodies) {
            return true;
        }
        world.update();
    }
    return sleepers(world) == bodies;
}

} // namespace spacetow::test
