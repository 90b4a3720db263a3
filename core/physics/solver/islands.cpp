#include "core/physics/solver/islands.h"

#include <algorithm>

namespace spacetow {

namespace {

/// What a body that nothing can move may push.
void noteDriver(Islands& islands, Slot driver, Slot pushed) {
    const Islands::Driver found{driver, pushed};
    if (islands.drivers.empty() || islands.drivers.back() != found) {
        islands.drivers.push_back(found);
    }
}

/// Of whoever may be joined; all others are their own roots ever since renewSlots().
void beginRoots(const Bodies& bodies, const Contacts& contacts, Islands& islands, const Sleep& sleep) {
    std::vector<Slot>& roots = islands.roots;
    for (const Slot slot : bodies.moving) {
        roots[slot] = slot;
    }
    if (sleep.sleepers.empty()) {
        return;
    }
    for (const PairBound& bound : contacts.table.bounds) {
        roots[slotOf(bound.moverA)] = slotOf(bound.moverA);
        if (bound.moverB != Mover::Static) {
            roots[slotOf(bound.moverB)] = slotOf(bound.moverB);
        }
    }
}

/// All that is asked for is beside the pairs, in fewer bytes.
void joinPairs(const Bodies& bodies, const Contacts& contacts, Islands& islands) {
    std::vector<Slot>& roots = islands.roots;
    auto sensors = contacts.sensors.begin();
    for (std::uint32_t i = 0; i < contacts.table.size(); ++i) {
        const PairBound& bound = contacts.table.bounds[i];
        if (sensors != contacts.sensors.end() && *sensors == i) {
            ++sensors;
            continue;
        }
        const Slot a = slotOf(bound.moverA);
        const Slot b = slotOf(bound.moverB);
        if ((bodies.movable[bound.moverA] & bodies.movable[bound.moverB]) != 0) {
            if (roots[a] != roots[b]) {
                joinSets(roots, a, b);
            }
        } else if (bound.moverB != Mover::Static && bodies.movable[bound.moverA] != 0) {
            noteDriver(islands, b, a);
        } else if (bodies.movable[bound.moverB] != 0) {
            noteDriver(islands, a, b);
        }
    }
}

/// Nothing pushes their islands any more.
void forgetDrivers(const Islands& islands, SolverScratch& solver) {
    std::vector<std::uint8_t>& driven = solver.driven;
    for (const Islands::Driver& driver : islands.drivers) {
        if (driver.pushed < driven.size()) {
            driven[driver.pushed] = 0;
        }
    }
}

/// What it weighs, and nothing of what was there before.
void renewSlot(Bodies& bodies, Constraints& constraints, Islands& islands, Slot slot) {
    const BodyMotion& m = bodies.motions[slot];
    const double mass = m.inverseMass > 0 ? 1 / m.inverseMass : 0;
    islands.inertias[slot] = {mass, mass, m.inverseInertia > 0 ? 1 / m.inverseInertia : 0, 0};
    bodies.movable[slot] = m.isMovable() ? 1 : 0;
    islands.roots[slot] = slot;
    constraints.mergeableContacts[slot] = 0;
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

void findIslands(const SolverStage& stage) {
    if (!stage.flags.islandsStale) {
        return;
    }
    stage.flags.islandsStale = false;
    beginRoots(stage.bodies, stage.contacts, stage.islands, stage.sleep);
    std::vector<Slot>& roots = stage.islands.roots;
    std::vector<Islands::Driver>& drivers = stage.islands.drivers;
    forgetDrivers(stage.islands, stage.solver);
    stage.islands.drivenStale = true;
    drivers.clear();
    joinPairs(stage.bodies, stage.contacts, stage.islands);
    stage.islands.islandRoots.clear();
    for (const Slot slot : stage.bodies.moving) {
        roots[slot] = rootOf(roots, slot);
        if (roots[slot] == slot) {
            stage.islands.islandRoots.push_back(slot);
        }
    }
    for (Islands::Driver& driver : drivers) {
        driver.pushed = roots[driver.pushed];
    }
    drivers.erase(std::unique(drivers.begin(), drivers.end()), drivers.end()); // leaves little to sort
    std::sort(drivers.begin(), drivers.end());
    drivers.erase(std::unique(drivers.begin(), drivers.end()), drivers.end());
}

void findDriven(const Bodies& bodies, Islands& islands, SolverScratch& solver) {
    std::vector<std::uint8_t>& driven = solver.driven;
    beginBySlot(driven, bodies.motions.size() + 1, std::uint8_t{0});
    for (const Slot root : islands.islandRoots) {
        driven[root] = 0;
    }
    forgetDrivers(islands, solver);
    bool any = false;
    for (const Islands::Driver& driver : islands.drivers) {
        if (bodies.motions[driver.slot].isMoving()) {
            driven[driver.pushed] = 1;
            any = true;
        }
    }
    if (any || islands.drivenStale) {
        for (const Slot slot : bodies.moving) {
            driven[slot] = driven[islands.roots[slot]];
        }
    }
    islands.drivenStale = any;
}

void renewSlots(const SolverStage& stage, std::span<const Slot> slots) {
    const std::size_t count = stage.bodies.motions.size();
    stage.islands.roots.resize(count);
    stage.islands.inertias.resize(count);
    stage.bodies.movable.resize(count);
    stage.constraints.mergeableContacts.resize(count);
    for (const Slot slot : slots) {
        renewSlot(stage.bodies, stage.constraints, stage.islands, slot);
    }
    stage.flags.islandsStale = true;
}

} // namespace spacetow
