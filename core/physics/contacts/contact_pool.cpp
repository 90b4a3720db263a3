#include "core/physics/contacts/contact_pool.h"

#include "core/physics/contacts/constraint_list.h"

namespace spacetow {

namespace {

void mixMaterials(const BodyRecord& a, const BodyRecord& b, Contact& contact) {
    contact.friction = std::sqrt(a.friction * b.friction);
    contact.restitution = std::clamp(0.5 * (a.restitution + b.restitution), 0.0, 1.0);
}

/// Mixes the materials of all contacts of the body in the table again, and outdates the manifolds of those that now
/// have restitution. Returns whether any of the contacts has points.
bool remixMaterials(const Bodies& bodies, std::vector<Contact>& pool, const PairTable& table, Slot slot) {
    bool any = false;
    for (const Pair& pair : table.pairs) {
        if (pair.contact == Pair::none || (pair.bodyA != slot && pair.bodyB != slot)) {
            continue;
        }
        Contact& contact = pool[pair.contact];
        mixMaterials(bodies.records[pair.bodyA], bodies.records[pair.bodyB], contact);
        if (contact.count > 0) {
            any = true;
            contact.manifold.tolerance = contact.restitution > 0 ? -1 : contact.manifold.tolerance;
        }
    }
    return any;
}

} // namespace

Contact& contactOf(const Bodies& bodies, Contacts& contacts, Pair& pair) {
    if (pair.contact != Pair::none) {
        return contacts.pool[pair.contact];
    }
    if (contacts.freeInPool.empty()) {
        pair.contact = static_cast<std::uint32_t>(contacts.pool.size());
        contacts.pool.emplace_back();
    } else {
        pair.contact = contacts.freeInPool.back();
        contacts.freeInPool.pop_back();
    }
    Contact& contact = contacts.pool[pair.contact];
    contact = Contact{};
    mixMaterials(bodies.records[pair.bodyA], bodies.records[pair.bodyB], contact);
    return contact;
}

void freeContact(Contacts& contacts, NarrowPhase& narrow, Pair& pair) {
    if (pair.contact != Pair::none) {
        if (pair.contact < narrow.wholeImpulses.size()) {
            narrow.wholeImpulses[pair.contact] = {};
        }
        contacts.freeInPool.push_back(pair.contact);
        pair.contact = Pair::none;
    }
}

void freeContactsOfDropped(const ContactStage& stage) {
    for (const std::uint32_t i : stage.changes.dropped) {
        if (stage.flags.constraintsValid && stage.contacts.table.flags[i].inSolver) {
            removeConstraint(stage.contacts, stage.constraints, i);
        }
        freeContact(stage.contacts, stage.narrow, stage.contacts.table.pairs[i]);
    }
}

void resetManifolds(Contacts& contacts) {
    for (Contact& contact : contacts.pool) {
        contact.manifold.tolerance = -1;
    }
}

bool refreshMaterials(const ContactStage& stage, const PairTable& sleepers, Slot slot) {
    const bool awake = remixMaterials(stage.bodies, stage.contacts.pool, stage.contacts.table, slot);
    const bool asleep = remixMaterials(stage.bodies, stage.contacts.pool, sleepers, slot);
    if (awake || asleep) {
        releaseConstraints(stage.contacts, stage.constraints, stage.flags);
    }
    return awake || asleep;
}

void beginPart(const ContactStage& stage, double share) {
    releaseConstraints(stage.contacts, stage.constraints, stage.flags);
    stage.narrow.wholeImpulses.clear();
    for (Contact& contact : stage.contacts.pool) {
        stage.narrow.wholeImpulses.push_back(
            {contact.tangentImpulse, contact.points[0].normalImpulse, contact.points[1].normalImpulse});
        contact.tangentImpulse *= share;
        contact.points[0].normalImpulse *= share;
        contact.points[1].normalImpulse *= share;
    }
}

void endPart(const ContactStage& stage, double share) {
    releaseConstraints(stage.contacts, stage.constraints, stage.flags);
    for (std::size_t i = 0; i < stage.narrow.wholeImpulses.size(); ++i) {
        Contact& contact = stage.contacts.pool[i];
        const auto& whole = stage.narrow.wholeImpulses[i];
        contact.tangentImpulse += (1 - share) * whole[0];
        contact.points[0].normalImpulse += (1 - share) * whole[1];
        contact.points[1].normalImpulse += (1 - share) * whole[2];
    }
    stage.narrow.wholeImpulses.clear();
}

} // namespace spacetow
