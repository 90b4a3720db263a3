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
void disturbBodiesOf(WorldData& data, std::uint32_t field) {
    for (const Slot slot : data.fieldBodies) {
        if (actsOn(data, data.fields[field], slot)) {
            disturb(data, slot);
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
    auto index = static_cast<std::uint32_t>(data.fields.size());
    if (data.freeFields.empty()) {
        data.fields.emplace_back();
    } else {
        index = data.freeFields.back();
        data.freeFields.pop_back();
    }
    data.fields[index].def = std::make_shared<const ForceFieldDef>(std::move(def));
    refreshSubsteps(data);
    disturbBodiesOf(data, index);
    return FieldId{index, data.fields[index].generation};
}

void World::removeField(FieldId field) {
    EXPECTS(contains(field));
    WorldData& data = *m_data;
    disturbBodiesOf(data, field.index);
    data.fields[field.index].def = nullptr;
    ++data.fields[field.index].generation;
    data.freeFields.push_back(field.index);
    refreshSubsteps(data);
}

bool World::contains(FieldId field) const {
    return field.index < m_data->fields.size() && m_data->fields[field.index].def &&
           m_data->fields[field.index].generation == field.generation;
}

} // namespace spacetow
