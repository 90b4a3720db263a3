#include "core/physics/solver/islands.h"

#include <algorithm>

namespace spacetow {

namespace {

/// What a body that nothing can move may push.
void noteDriver(WorldData& data, Slot driver, Slot pushed) {
    const Islands::Driver found{driver, pushed};
    if (data.islands.drivers.empty() || data.islands.drivers.back() != found) {
        data.islands.drivers.push_back(found);
    }
}

/// Of whoever may be joined; all others are their own roots ever since renewSlots().
void beginRoots(WorldData& data) {
    std::vector<Slot>& roots = data.islands.roots;
    for (const Slot slot : data.moving) {
        roots[slot] = slot;
    }
    if (data.sleep.sleepers.empty()) {
        return;
    }
    for (const PairBound& bound : data.table.bounds) {
        roots[slotOf(bound.moverA)] = slotOf(bound.moverA);
        if (bound.moverB != Mover::Static) {
            roots[slotOf(bound.moverB)] = slotOf(bound.moverB);
        }
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

/// Nothing pushes their islands any more.
void forgetDrivers(WorldData& data) {
    std::vector<std::uint8_t>& driven = data.scratch.solver.driven;
    for (const Islands::Driver& driver : data.islands.drivers) {
        if (driver.pushed < driven.size()) {
            driven[driver.pushed] = 0;
        }
    }
}

/// What it weighs, and nothing of what was there before.
void renewSlot(WorldData& data, Slot slot) {
    const BodyMotion& m = data.motions[slot];
    const double mass = m.inverseMass > 0 ? 1 / m.inverseMass : 0;
    data.islands.inertias[slot] = {mass, mass, m.inverseInertia > 0 ? 1 / m.inverseInertia : 0, 0};
    data.movable[slot] = m.isMovable() ? 1 : 0;
    data.islands.roots[slot] = slot;
    data.mergeableContacts[slot] = 0;
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
    beginRoots(data);
    std::vector<Slot>& roots = data.islands.roots;
    std::vector<Islands::Driver>& drivers = data.islands.drivers;
    forgetDrivers(data);
    data.islands.drivenStale = true;
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
    std::vector<std::uint8_t>& driven = data.scratch.solver.driven;
    beginBySlot(driven, data.motions.size() + 1, std::uint8_t{0});
    for (const Slot root : islands.islandRoots) {
        driven[root] = 0;
    }
    forgetDrivers(data);
    bool any = false;
    for (const Islands::Driver& driver : islands.drivers) {
        if (data.motions[driver.slot].isMoving()) {
            driven[driver.pushed] = 1;
            any = true;
        }
    }
    if (any || islands.drivenStale) {
        for (const Slot slot : data.moving) {
            driven[slot] = driven[islands.roots[slot]];
        }
    }
    islands.drivenStale = any;
}

void renewSlots(WorldData& data, std::span<const Slot> slots) {
    const std::size_t bodies = data.motions.size();
    data.islands.roots.resize(bodies);
    data.islands.inertias.resize(bodies);
    data.movable.resize(bodies);
    data.mergeableContacts.resize(bodies);
    for (const Slot slot : slots) {
        renewSlot(data, slot);
    }
    data.flags.islandsStale = true;
}

} // namespace spacetow
