#include "core/physics/step/deferred_changes.h"

#include "core/physics/contacts/constraint_list.h"
#include "core/physics/sleep/sleep.h"
#include "core/physics/sleep/touches.h"

#include <algorithm>

namespace spacetow {

namespace {

void endTouchesOf(WorldData& data, Slot slot, int iteration) {
    releaseConstraints(data.contacts, data.constraints, data.flags);
    endTouches(data, data.scratch.narrow, slot, iteration);
}

void removeNow(WorldData& data, Slot slot, int iteration) {
    endTouchesOf(data, slot, iteration);
    for (std::uint32_t i = 0; i < data.forces.connectors.size(); ++i) {
        const ConnectorRecord& c = data.forces.connectors[i];
        if (c.used && (c.a == slot || c.b == slot)) {
            data.forces.release(i);
        }
    }
    BodyRecord& record = data.bodies.records[slot];
    if (record.kind == BodyKind::Static) {
        data.noteStaticChange(slot);
    }
    data.events.removed.push_back({iteration, data.bodies.idOf(slot), record.user});
    const std::uint32_t generation = record.generation + 1;
    record = BodyRecord{};
    record.generation = generation;
    data.bodies.motions[slot] = BodyMotion{};
    data.bodies.steps[slot] = BodyStep{};
    data.bodies.freeSlots.push_back(slot);
}

void setFrozenNow(Bodies& bodies, Slot slot, bool position, bool rotation) {
    BodyRecord& record = bodies.records[slot];
    record.positionFrozen = position;
    record.rotationFrozen = rotation;
    if (position) {
        bodies.motions[slot].velocity.setZero();
    }
    if (rotation) {
        bodies.motions[slot].angularVelocity = 0;
    }
    refreshInverseMass(bodies, slot);
}

void setActiveNow(WorldData& data, Slot slot, bool active, int iteration) {
    BodyRecord& record = data.bodies.records[slot];
    if (record.active && !active) {
        endTouchesOf(data, slot, iteration);
    }
    if (record.kind == BodyKind::Static && record.active != active) {
        data.noteStaticChange(slot);
    }
    record.active = active;
}

void noteSubstepped(Bodies& bodies, Forces& forces, Slot slot) {
    if (!bodies.records[slot].substepped) {
        bodies.records[slot].substepped = true;
        forces.substepped.push_back(slot);
    }
}

/// Lists the bodies that are integrated in sub-steps.
void refreshSubsteps(Bodies& bodies, Forces& forces) {
    for (const Slot slot : forces.substepped) {
        bodies.records[slot].substepped = false;
    }
    forces.substepped.clear();
    for (const ConnectorRecord& c : forces.connectors) {
        if (c.used && bodies.records[c.a].active && bodies.records[c.b].active) {
            noteSubstepped(bodies, forces, c.a);
            noteSubstepped(bodies, forces, c.b);
        }
    }
}

} // namespace

bool applyPending(WorldData& data, int iteration) {
    if (data.bodies.pending.empty()) {
        return false;
    }
    for (const PendingChange& change : data.bodies.pending) {
        if (data.bodies.contains(change.body)) {
            requestWake(data.bodies, data.sleep, change.body.index);
        }
    }
    wakeRequested(data, iteration);
    for (const PendingChange& change : data.bodies.pending) {
        const Slot slot = change.body.index;
        if (!data.bodies.contains(change.body)) {
            continue;
        }
        data.bodies.changedBodies.push_back(slot);
        switch (change.kind) {
        case PendingChange::Kind::Remove:
            removeNow(data, slot, iteration);
            break;
        case PendingChange::Kind::Active:
            setActiveNow(data, slot, change.first, iteration);
            break;
        case PendingChange::Kind::Tangible:
            data.bodies.records[slot].tangible = change.first;
            break;
        case PendingChange::Kind::Frozen:
            setFrozenNow(data.bodies, slot, change.first, change.second);
            break;
        }
    }
    data.bodies.pending.clear();
    refreshConnections(data.bodies, data.forces, data.flags);
    return true;
}

void refreshInverseMass(Bodies& bodies, Slot slot) {
    const BodyRecord& record = bodies.records[slot];
    BodyMotion& m = bodies.motions[slot];
    const bool dynamic = record.kind == BodyKind::Dynamic;
    m.inverseMass = dynamic && !record.positionFrozen ? 1 / record.mass : 0;
    m.inverseInertia = dynamic && !record.rotationFrozen && record.inertia > 0 ? 1 / record.inertia : 0;
}

void refreshConnections(Bodies& bodies, Forces& forces, StepFlags& flags) {
    flags.pairsStale = true;
    flags.connectionsStale = false;
    forces.notColliding.clear();
    for (const ConnectorRecord& c : forces.connectors) {
        if (c.used && !c.bodiesCollide) {
            forces.notColliding.emplace_back(std::minmax(c.a, c.b));
        }
    }
    std::sort(forces.notColliding.begin(), forces.notColliding.end());
    refreshSubsteps(bodies, forces);
}

} // namespace spacetow
