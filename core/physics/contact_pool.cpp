#include "core/physics/contact_pool.h"

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

void forgetContact(WorldData& data, Pair& pair) {
    if (pair.contact != Pair::none) {
        const std::uint32_t manifold = data.contacts[pair.contact].manifold;
        if (manifold != Pair::none) {
            data.freeManifolds.push_back(manifold);
        }
        data.freeContacts.push_back(pair.contact);
        pair.contact = Pair::none;
    }
}

} // namespace spacetow
