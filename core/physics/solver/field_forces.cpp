#include "core/physics/solver/field_forces.h"

#include "core/physics/solver/force_rules.h"

#include <algorithm>

namespace spacetow {

namespace {

bool anyActsOn(const Bodies& bodies, const Forces& forces, Slot slot) {
    return std::any_of(forces.fields.begin(), forces.fields.end(),
                       [&](const FieldRecord& field) { return actsOn(bodies, field, slot); });
}

bool isSound(const FieldForce& f) {
    return isFinite(f.force) && std::isfinite(f.torque);
}

/// One event an update for each field, naming the first body.
void refuse(const ForceStage& stage, std::uint32_t index, Slot slot, int iteration) {
    const FieldId field{index, stage.forces.fields[index].generation};
    std::vector<FieldFaultEvent>& faults = stage.events.fieldFaults;
    if (std::none_of(faults.begin(), faults.end(), [field](const auto& fault) { return fault.field == field; })) {
        faults.push_back({iteration, field, stage.bodies.idOf(slot)});
    }
}

FieldSample sampleOf(const Bodies& bodies, const Substeps& substeps, Slot slot) {
    const BodyRecord& record = bodies.records[slot];
    const Transform& trial = substeps.trial[slot];
    return {.body = bodies.idOf(slot),
            .pose = {trial.position - trial.rotation * record.localCenter, trial.rotation},
            .massCenter = trial.position,
            .velocity = bodies.motions[slot].velocity,
            .angularVelocity = bodies.motions[slot].angularVelocity,
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

FieldGain gainOf(const ForceStage& stage, Slot slot, const FieldSample& sample, const FieldTime& time) {
    FieldForce sum;
    for (std::uint32_t i = 0; i < stage.forces.fields.size(); ++i) {
        if (actsOn(stage.bodies, stage.forces.fields[i], slot)) {
            const FieldForce f = stage.forces.fields[i].def->force(sample);
            if (isSound(f)) {
                sum.force += f.force;
                sum.torque += f.torque;
            } else {
                refuse(stage, i, slot, time.iteration);
            }
        }
    }
    const BodyRecord& record = stage.bodies.records[slot];
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

bool actsOn(const Bodies& bodies, const FieldRecord& field, Slot slot) {
    if (!field.def || !accepts(bodies.records[slot], field.def->source)) {
        return false;
    }
    return field.def->body ? *field.def->body == bodies.idOf(slot)
                           : field.def->tags.intersects(bodies.records[slot].filter.tags);
}

void noteSubstepped(Bodies& bodies, Forces& forces, Slot slot) {
    if (!bodies.records[slot].substepped) {
        bodies.records[slot].substepped = true;
        forces.substepped.push_back(slot);
    }
}

void refreshFields(Bodies& bodies, Forces& forces) {
    forces.fieldBodies.clear();
    if (forces.fields.size() == forces.freeFields.size()) {
        return;
    }
    for (Slot slot = 0; slot < bodies.records.size(); ++slot) {
        if (bodies.records[slot].used && anyActsOn(bodies, forces, slot)) {
            noteSubstepped(bodies, forces, slot);
            forces.fieldBodies.push_back(slot);
        }
    }
}

void refreshFieldsOf(Bodies& bodies, Forces& forces, Slot slot) {
    const auto at = std::lower_bound(forces.fieldBodies.begin(), forces.fieldBodies.end(), slot);
    if (anyActsOn(bodies, forces, slot)) {
        noteSubstepped(bodies, forces, slot);
        forces.fieldBodies.insert(at, slot);
    }
}

void applyFields(const ForceStage& stage, double seconds, int iteration) {
    if (seconds == 0) {
        return;
    }
    for (const Slot slot : stage.forces.fieldBodies) {
        if (stage.bodies.records[slot].asleep) {
            continue;
        }
        // The midpoint rule: second order for what depends on the velocity, too.
        FieldSample sample = sampleOf(stage.bodies, stage.substeps, slot);
        const FieldGain first = gainOf(stage, slot, sample, {seconds, iteration});
        sample.velocity += 0.5 * first.velocity;
        sample.angularVelocity += 0.5 * first.angularVelocity;
        const FieldGain gain = gainOf(stage, slot, sample, {seconds, iteration});
        stage.bodies.motions[slot].velocity += gain.velocity;
        stage.bodies.motions[slot].angularVelocity += gain.angularVelocity;
    }
}

void removeFieldsOf(const Bodies& bodies, Forces& forces, Slot slot) {
    for (std::uint32_t i = 0; i < forces.fields.size(); ++i) {
        FieldRecord& field = forces.fields[i];
        if (field.def && field.def->body == bodies.idOf(slot)) {
            field.def = nullptr;
            ++field.generation;
            forces.freeFields.push_back(i);
        }
    }
}

} // namespace spacetow
