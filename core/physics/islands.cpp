#include "core/physics/islands.h"

#include <algorithm>
#include <numeric>

namespace spacetow {

namespace {

/// What a body that nothing can move may push.
void noteDriver(WorldData& data, Slot driver, Slot pushed) {
    const Islands::Driver found{driver, pushed};
    if (data.islands.drivers.empty() || data.islands.drivers.back() != found) {
        data.islands.drivers.push_back(found);
    }
}

} // namespace

Slot rootOf(std::vector<Slot>& parents, Slot slot) {
    while (parents[slot] != slot) {
        parents[slot] = parents[parents[slot]];
        slot = parents[slot];
    }
    return slot;
}

void joinSets(std::vector<Slot>& parents, Slot a, Slot b) {
    const Slot rootA = rootOf(parents, a);
    const Slot rootB = rootOf(parents, b);
    parents[std::max(rootA, rootB)] = std::min(rootA, rootB);
}

void findIslands(WorldData& data) {
    std::vector<Slot>& roots = data.islands.roots;
    roots.resize(data.motions.size());
    std::iota(roots.begin(), roots.end(), Slot{0});
    data.islands.drivers.clear();
    for (const Pair& pair : data.table.pairs) {
        if (pair.staticB || pair.kind == PairKind::Felt) {
            continue;
        }
        const bool movableA = data.motions[pair.bodyA].yields();
        const bool movableB = data.motions[pair.bodyB].yields();
        if (movableA && movableB) {
            joinSets(roots, pair.bodyA, pair.bodyB);
        } else if (movableA) {
            noteDriver(data, pair.bodyB, pair.bodyA);
        } else if (movableB) {
            noteDriver(data, pair.bodyA, pair.bodyB);
        }
    }
    data.islands.all.clear();
    data.islands.inertias.resize(data.motions.size());
    for (const Slot slot : data.moving) {
        roots[slot] = rootOf(roots, slot);
        if (roots[slot] == slot) {
            data.islands.all.push_back(slot);
        }
        const BodyMotion& m = data.motions[slot];
        const double mass = m.inverseMass > 0 ? 1 / m.inverseMass : 0;
        data.islands.inertias[slot] = {mass, mass, m.inverseInertia > 0 ? 1 / m.inverseInertia : 0, 0};
    }
    std::vector<Islands::Driver>& drivers = data.islands.drivers;
    for (Islands::Driver& driver : drivers) {
        driver.pushed = roots[driver.pushed];
    }
    std::sort(drivers.begin(), drivers.end());
    drivers.erase(std::unique(drivers.begin(), drivers.end()), drivers.end());
}

} // namespace spacetow
