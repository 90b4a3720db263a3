#include "core/physics/contacts/contact_pool.h"

#include "core/physics/contacts/constraint_list.h"

namespace spacetow {

namespace {

std::uint32_t newManifold(WorldData& data) {
    if (data.freeManifolds.empty()) {
        data.manifolds.emplace_back();
        return static_cast<std::uint32_t>(data.manifolds.size() - 1);
    }
    const std::uint32_t index = data.freeManifolds.back();
    data.freeManifolds.pop_back();
    data.manifolds[index] = KeptManifold{};
    return index;
}

} // namespace

Contact& contactOf(WorldData& data, Pair& pair) {
    if (pair.contact != Pair::none) {
        return data.contacts[pair.contact];
    }
    if (data.freeContacts.empty()) {
        pair.contact = static_cast<std::uint32_t>(data.contacts.size());
        data.contacts.emplace_back();
    } else {
        pair.contact = data.freeContacts.back();
        data.freeContacts.pop_back();
    }
    const BodyRecord& a = data.records[pair.bodyA];
    const BodyRecord& b = data.records[pair.bodyB];
    Contact& contact = data.contacts[pair.contact];
    contact = Contact{};
    if (pair.kind == PairKind::General) {
        contact.manifold = newManifold(data);
    }
    contact.friction = std::sqrt(a.friction * b.friction);
    contact.restitution = std::clamp(0.5 * (a.restitution + b.restitution), 0.0, 1.0);
    return contact;
}

void freeContact(WorldData& data, Pair& pair) {
    if (pair.contact != Pair::none) {
        const std::uint32_t manifold = data.contacts[pair.contact].manifold;
        if (manifold != Pair::none) {
            data.freeManifolds.push_back(manifold);
        }
        if (pair.contact < data.scratch.narrow.wholeImpulses.size()) {
            data.scratch.narrow.wholeImpulses[pair.contact] = {};
        }
        data.freeContacts.push_back(pair.contact);
        pair.contact = Pair::none;
    }
}

void freeContactsOfDropped(WorldData& data) {
    for (const std::uint32_t i : data.scratch.changes.dropped) {
        if (data.flags.constraintsValid && data.table.flags[i].inSolver) {
            removeConstraint(data, i);
        }
        freeContact(data, data.table.pairs[i]);
    }
}

void resetManifolds(WorldData& data) {
    for (KeptManifold& manifold : data.manifolds) {
        manifold.tolerance = -1;
    }
}

void beginPart(WorldData& data, double share) {
    releaseConstraints(data);
    data.scratch.narrow.wholeImpulses.clear();
    for (Contact& contact : data.contacts) {
        data.scratch.narrow.wholeImpulses.push_back(
            {contact.tangentImpulse, contact.points[0].normalImpulse, contact.points[1].normalImpulse});
        contact.tangentImpulse *= share;
        contact.points[0].normalImpulse *= share;
        contact.points[1].normalImpulse *= share;
    }
}

void endPart(WorldData& data, double share) {
    releaseConstraints(data);
    for (std::size_t i = 0; i < data.scratch.narrow.wholeImpulses.size(); ++i) {
        Contact& contact = data.contacts[i];
        const auto& whole = data.scratch.narrow.wholeImpulses[i];
        contact.tangentImpulse += (1 - share) * whole[0];
        contact.points[0].normalImpulse += (1 - share) * whole[1];
        contact.points[1].normalImpulse += (1 - share) * whole[2];
    }
    data.scratch.narrow.wholeImpulses.clear();
}

} // namespace spacetow
