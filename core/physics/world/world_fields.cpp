// World: adding and removing force fields.

#include "core/base/contract.h"
#include "core/physics/sleep/sleep.h"
#include "core/physics/solver/field_forces.h"
#include "core/physics/state/world_data.h"
#include "core/physics/step/deferred_changes.h"
#include "core/physics/world/world.h"

namespace spacetow {

namespace {

/// The field is new or about to go.
void requestWakeOfBodies(Bodies& bodies, const Forces& forces, Sleep& sleep, std::uint32_t field) {
    for (const Slot slot : forces.fieldBodies) {
        if (actsOn(bodies, forces.fields[field], slot)) {
            requestWake(bodies, sleep, slot);
        }
    }
}

} // namespace

Result<FieldId> World::addField(ForceFieldDef def) {
    if (!def.force) {
        return Error{"no-force", {}};
    }
    if (def.body && !contains(*def.body)) {
        return Error{"no-such-body", {"body"}};
    }
    WorldData& data = *m_data;
    auto index = static_cast<std::uint32_t>(data.forces.fields.size());
    if (data.forces.freeFields.empty()) {
        data.forces.fields.emplace_back();
    } else {
        index = data.forces.freeFields.back();
        data.forces.freeFields.pop_back();
    }
    data.forces.fields[index].def = std::make_shared<const ForceFieldDef>(std::move(def));
    refreshSubsteps(data.bodies, data.forces);
    requestWakeOfBodies(data.bodies, data.forces, data.sleep, index);
    return FieldId{index, data.forces.fields[index].generation};
}

void World::removeField(FieldId field) {
    EXPECTS(contains(field));
    WorldData& data = *m_data;
    requestWakeOfBodies(data.bodies, data.forces, data.sleep, field.index);
    data.forces.fields[field.index].def = nullptr;
    ++data.forces.fields[field.index].generation;
    data.forces.freeFields.push_back(field.index);
    refreshSubsteps(data.bodies, data.forces);
}

bool World::contains(FieldId field) const {
    return field.index < m_data->forces.fields.size() && m_data->forces.fields[field.index].def &&
           m_data->forces.fields[field.index].generation == field.generation;
}

} // namespace spacetow
