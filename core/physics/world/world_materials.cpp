// World: another mass or material for a body that is there.

#include "core/base/contract.h"
#include "core/physics/contacts/contact_pool.h"
#include "core/physics/sleep/sleep.h"
#include "core/physics/solver/contact_graph.h"
#include "core/physics/state/world_data.h"
#include "core/physics/step/deferred_changes.h"
#include "core/physics/world/make_body.h"
#include "core/physics/world/world.h"

#include <tuple>

namespace spacetow {

namespace {

/// The properties that contacts depend on.
auto massAndSurface(const BodyRecord& r) {
    return std::tuple(r.mass, r.inertia, r.restitution, r.friction);
}

auto dampings(const BodyRecord& r) {
    return std::tuple(r.linearDamping, r.angularDamping);
}

} // namespace

Result<bool> World::setMaterial(BodyId body, const BodyMaterial& material) {
    EXPECTS(contains(body));
    if (std::optional<Error> error = checkMaterial(material)) {
        return *std::move(error);
    }
    WorldData& data = *m_data;
    const Slot slot = body.index;
    BodyRecord& record = data.bodies.records[slot];
    BodyRecord next = record;
    setSurface(next, material);
    if (record.kind != BodyKind::Static) {
        const std::optional<MassProperties> total = usableMass(*record.shapes, material.density, material.mass);
        if (!total) {
            return badMass(material);
        }
        next.mass = total->mass;
        next.inertia = total->inertia;
    }
    const bool affectsContacts = massAndSurface(next) != massAndSurface(record);
    if (!affectsContacts && dampings(next) == dampings(record)) {
        return false;
    }
    requestWake(data.bodies, data.sleep, slot);
    next.stillTime = record.stillTime;
    record = std::move(next);
    refreshInverseMass(data.bodies, slot);
    const bool bears =
        affectsContacts && refreshMaterials(data, data.sleep.table, slot);       // then the solver is to see the change
    if (affectsContacts && !bears && slot < data.contactGraph.inertias.size()) { // else the next update weighs it
        refreshInertia(data.bodies.motions[slot], data.contactGraph, slot);
    }
    return true;
}

} // namespace spacetow
