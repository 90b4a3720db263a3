#include "core/physics/solver/field_forces.h"

#include "core/physics/solver/force_rules.h"

#include <algorithm>

namespace spacetow {

namespace {

bool anyActsOn(const WorldData& data, Slot slot) {
    return std::any_of(data.fields.begin(), data.fields.end(),
                       [&](const FieldRecord& field) { return actsOn(data, field, slot); });
}

bool isSound(const FieldForce& f) {
    return isFinite(f.force) && std::isfinite(f.torque);
}

/// One event an update for each field, naming the first body.
void refuse(WorldData& data, std::uint32_t index, Slot slot, int iteration) {
    const FieldId field{index, data.fields[index].generation};
    std::vector<FieldFaultEvent>& faults = data.events.fieldFaults;
    if (std::none_of(faults.begin(), faults.end(), [field](const auto& fault) { return fault.field == field; })) {
        faults.push_back({iteration, field, data.idOf(slot)});
    }
}

FieldSample sampleOf(const WorldData& data, Slot slot) {
    const BodyRecord& record = data.records[slot];
    const Transform& trial = data.scratch.substeps.trial[slot];
    return {.body = data.idOf(slot),
            .pose = {trial.position - trial.rotation * record.localCenter, trial.rotation},
            .massCenter = trial.position,
            .velocity = data.motions[slot].velocity,
            .angularVelocity = data.motions[slot].angularVelocity,
            .mass = record.mass,
            .inertia = record.inertia};
}

/// For how long, and when, fields act.
struct FieldTime {
    double seconds;
    int iteration;
};

struct FieldGain {
    Vec2 velocity{0, 0};
    double angularVelocity = 0;
};

FieldGain gainOf(WorldData& data, Slot slot, const FieldSample& sample, const FieldTime& time) {
    FieldForce sum;
    for (std::uint32_t i = 0; i < data.fields.size(); ++i) {
        if (actsOn(data, data.fields[i], slot)) {
            const FieldForce f = data.fields[i].def->force(sample);
            if (isSound(f)) {
                sum.force += f.force;
                sum.torque += f.torque;
            } else {
                refuse(data, i, slot, time.iteration);
            }
        }
    }
    const BodyRecord& record = data.records[slot];
    FieldGain gain;
    if (!record.positionFrozen) {
        gain.velocity = time.seconds * sum.force / record.mass;
    }
    if (!record.rotationFrozen && record.inertia > 0) {
        gain.angularVelocity = time.seconds * sum.torque / record.inertia;
    }
    return gain;
}

} // namespace

bool actsOn(const WorldData& data, const FieldRecord& field, Slot slot) {
    if (!field.def || !accepts(data.records[slot], field.def->source)) {
        return false;
    }
    return field.def->body ? *field.def->body == data.idOf(slot)
                           : field.def->tags.intersects(data.records[slot].filter.tags);
}

void noteSubstepped(WorldData& data, Slot slot) {
    if (!data.records[slot].substepped) {
        data.records[slot].substepped = true;
        data.substepped.push_back(slot);
    }
}

void refreshFields(WorldData& data) {
    data.fieldBodies.clear();
    if (data.fields.size() == data.freeFields.size()) {
        return;
    }
    for (Slot slot = 0; slot < data.records.size(); ++slot) {
        if (data.records[slot].used && anyActsOn(data, slot)) {
            noteSubstepped(data, slot);
            data.fieldBodies.push_back(slot);
        }
    }
}

void refreshFieldsOf(WorldData& data, Slot slot) {
    const auto at = std::lower_bound(data.fieldBodies.begin(), data.fieldBodies.end(), slot);
    if (anyActsOn(data, slot)) {
        noteSubstepped(data, slot);
        data.fieldBodies.insert(at, slot);
    }
}

void applyFields(WorldData& data, double seconds, int iteration) {
    if (seconds == 0) {
        return;
    }
    for (const Slot slot : data.fieldBodies) {
        if (data.records[slot].asleep) {
            continue;
        }
        // The midpoint rule: second order for what depends on the velocity, too.
        FieldSample sample = sampleOf(data, slot);
        const FieldGain first = gainOf(data, slot, sample, {seconds, iteration});
        sample.velocity += 0.5 * first.velocity;
        sample.angularVelocity += 0.5 * first.angularVelocity;
        const FieldGain gain = gainOf(data, slot, sample, {seconds, iteration});
        data.motions[slot].velocity += gain.velocity;
        data.motions[slot].angularVelocity += gain.angularVelocity;
    }
}

void removeFieldsOf(WorldData& data, Slot slot) {
    for (std::uint32_t i = 0; i < data.fields.size(); ++i) {
        FieldRecord& field = data.fields[i];
        if (field.def && field.def->body == data.idOf(slot)) {
            field.def = nullptr;
            ++field.generation;
            data.freeFields.push_back(i);
        }
    }
}

} // namespace spacetow
