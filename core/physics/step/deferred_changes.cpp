#include "core/physics/step/deferred_changes.h"

#include "core/physics/sleep/sleep.h"
#include "core/physics/sleep/touches.h"
#include "core/physics/solver/field_forces.h"

#include <algorithm>

namespace spacetow {

namespace {

void removeNow(WorldData& data, Slot slot, int iteration) {
    endTouches(data, slot, iteration);
    for (std::uint32_t i = 0; i < data.connectors.size(); ++i) {
        ConnectorRecord& c = data.connectors[i];
        if (c.used && (c.a == slot || c.b == slot)) {
            c.used = false;
            ++c.generation;
            data.freeConnectors.push_back(i);
        }
    }
    removeFieldsOf(data, slot);
    BodyRecord& record = data.records[slot];
    if (record.kind == BodyKind::Static) {
        data.noteStaticChange(slot);
    }
    data.events.removed.push_back({iteration, data.idOf(slot), record.user});
    const std::uint32_t generation = record.generation + 1;
    record = BodyRecord{};
    record.generation = generation;
    data.motions[slot] = BodyMotion{};
    data.steps[slot] = BodyStep{};
    data.freeSlots.push_back(slot);
}

void setFrozenNow(WorldData& data, Slot slot, bool position, bool rotation) {
    BodyRecord& record = data.records[slot];
    record.positionFrozen = position;
    record.rotationFrozen = rotation;
    if (position) {
        data.motions[slot].velocity.setZero();
    }
    if (rotation) {
        data.motions[slot].angularVelocity = 0;
    }
    refreshInverseMass(data, slot);
}

void setActiveNow(WorldData& data, Slot slot, bool active, int iteration) {
    BodyRecord& record = data.records[slot];
    if (record.active && !active) {
        endTouches(data, slot, iteration);
    }
    if (record.kind == BodyKind::Static && record.active != active) {
        data.noteStaticChange(slot);
    }
    record.active = active;
}

} // namespace

bool applyPending(WorldData& data, int iteration) {
    if (data.pending.empty()) {
        return false;
    }
    for (const PendingChange& change : data.pending) {
        if (data.contains(change.body)) {
            disturb(data, change.body.index);
        }
    }
    wakeDisturbed(data, iteration);
    for (const PendingChange& change : data.pending) {
        const Slot slot = change.body.index;
        if (!data.contains(change.body)) {
            continue;
        }
        data.changedBodies.push_back(slot);
        switch (change.kind) {
        case PendingChange::Kind::Remove:
            removeNow(data, slot, iteration);
            break;
        case PendingChange::Kind::Active:
            setActiveNow(data, slot, change.first, iteration);
            break;
        case PendingChange::Kind::Tangible:
            data.records[slot].tangible = change.first;
            break;
        case PendingChange::Kind::Frozen:
            setFrozenNow(data, slot, change.first, change.second);
            break;
        }
    }
    data.pending.clear();
    refreshConnections(data);
    return true;
}

void refreshInverseMass(WorldData& data, Slot slot) {
    const BodyRecord& record = data.records[slot];
    BodyMotion& m = data.motions[slot];
    const bool dynamic = record.kind == BodyKind::Dynamic;
    m.inverseMass = dynamic && !record.positionFrozen ? 1 / record.mass : 0;
    m.inverseInertia = dynamic && !record.rotationFrozen && record.inertia > 0 ? 1 / record.inertia : 0;
}

void refreshConnections(WorldData& data) {
    data.flags.pairsStale = true;
    data.flags.connectionsStale = false;
    data.notColliding.clear();
    for (const ConnectorRecord& c : data.connectors) {
        if (c.used && !c.bodiesCollide) {
            data.notColliding.emplace_back(std::minmax(c.a, c.b));
        }
    }
    std::sort(data.notColliding.begin(), data.notColliding.end());
    refreshSubsteps(data);
}

void refreshSubsteps(WorldData& data) {
    for (const Slot slot : data.substepped) {
        data.records[slot].substepped = false;
    }
    data.substepped.clear();
    for (const ConnectorRecord& c : data.connectors) {
        if (c.used && data.records[c.a].active && data.records[c.b].active) {
            noteSubstepped(data, c.a);
            noteSubstepped(data, c.b);
        }
    }
    refreshFields(data);
}

} // namespace spacetow
