#include "core/physics/solver/islands.h"

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

/// All that is asked for is beside the pairs, in fewer bytes.
void joinPairs(WorldData& data) {
    std::vector<Slot>& roots = data.islands.roots;
    auto sensors = data.sensors.begin();
    for (std::uint32_t i = 0; i < data.table.size(); ++i) {
        const PairBound& bound = data.table.bounds[i];
        if (sensors != data.sensors.end() && *sensors == i) {
            ++sensors;
            continue;
        }
        const Slot a = slotOf(bound.moverA);
        const Slot b = slotOf(bound.moverB);
        if ((data.movable[bound.moverA] & data.movable[bound.moverB]) != 0) {
            if (roots[a] != roots[b]) {
                joinSets(roots, a, b);
            }
        } else if (bound.moverB != Mover::Static && data.movable[bound.moverA] != 0) {
            noteDriver(data, b, a);
        } else if (data.movable[bound.moverB] != 0) {
            noteDriver(data, a, b);
        }
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
    const Slot root = std::min(rootA, rootB);
    parents[std::max(rootA, rootB)] = root;
    parents[a] = parents[b] = root; // so that most of the others that join them see it at once
}

void findIslands(WorldData& data) {
    if (!data.flags.islandsStale) {
        return;
    }
    data.flags.islandsStale = false;
    std::vector<Slot>& roots = data.islands.roots;
    roots.resize(data.motions.size());
    std::iota(roots.begin(), roots.end(), Slot{0});
    std::vector<Islands::Driver>& drivers = data.islands.drivers;
    drivers.clear();
    joinPairs(data);
    data.islands.islandRoots.clear();
    for (const Slot slot : data.moving) {
        roots[slot] = rootOf(roots, slot);
        if (roots[slot] == slot) {
            data.islands.islandRoots.push_back(slot);
        }
    }
    for (Islands::Driver& driver : drivers) {
        driver.pushed = roots[driver.pushed];
    }
    drivers.erase(std::unique(drivers.begin(), drivers.end()), drivers.end()); // leaves little to sort
    std::sort(drivers.begin(), drivers.end());
    drivers.erase(std::unique(drivers.begin(), drivers.end()), drivers.end());
}

void findDriven(WorldData& data) {
    Islands& islands = data.islands;
    data.scratch.solver.driven.assign(data.motions.size() + 1, 0);
    bool any = false;
    for (const Islands::Driver& driver : islands.drivers) {
        if (data.motions[driver.slot].isMoving()) {
            data.scratch.solver.driven[driver.pushed] = 1;
            any = true;
        }
    }
    if (any) { // a root is the lowest of its island, so that it comes first
        for (Slot slot = 0; slot < data.motions.size(); ++slot) {
            data.scratch.solver.driven[slot] = data.scratch.solver.driven[data.islands.roots[slot]];
        }
    }
}

void measureInertias(WorldData& data) {
    data.islands.inertias.resize(data.motions.size());
    data.movable.assign(data.motions.size(), 0);
    for (Slot slot = 0; slot < data.motions.size(); ++slot) {
        const BodyMotion& m = data.motions[slot];
        const double mass = m.inverseMass > 0 ? 1 / m.inverseMass : 0;
        data.islands.inertias[slot] = {mass, mass, m.inverseInertia > 0 ? 1 / m.inverseInertia : 0, 0};
        data.movable[slot] = m.isMovable() ? 1 : 0;
    }
}

} // namespace spacetow
