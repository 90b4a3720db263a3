// World: hash of the whole state.

#include "core/base/hash.h"
#include "core/physics/state/world_data.h"
#include "core/physics/world/world.h"

namespace spacetow {

namespace {

void add(StateHash& hash, const Vec2& v) {
    hash.add(v.x());
    hash.add(v.y());
}

void addBodyState(StateHash& hash, const BodyMotion& m, const BodyRecord& r) {
    add(hash, m.center);
    hash.add(m.rotation.c);
    hash.add(m.rotation.s);
    add(hash, m.velocity);
    hash.add(m.angularVelocity);
    for (const double x : {r.mass, r.inertia, r.restitution, r.friction, r.linearDamping, r.angularDamping}) {
        hash.add(x);
    }
    add(hash, r.force);
    hash.add(r.torque);
    const std::uint64_t flags = std::uint64_t{r.used} | std::uint64_t{r.active} << 1 | std::uint64_t{r.tangible} << 2 |
                                std::uint64_t{r.positionFrozen} << 3 | std::uint64_t{r.rotationFrozen} << 4 |
                                std::uint64_t{r.asleep} << 5;
    hash.add(flags | std::uint64_t{r.generation} << 32);
    hash.add(r.filter.tags.bits | std::uint64_t{r.filter.touches.bits} << 32);
}

void addConnectorState(StateHash& hash, const ConnectorRecord& c) {
    hash.add(std::uint64_t{c.a} << 32 | c.b);
    add(hash, c.anchorA);
    add(hash, c.anchorB);
    for (const double x : {c.length, c.stiffness, c.damping, c.truncation.limit, c.truncation.proportion}) {
        hash.add(x);
    }
    hash.add(std::uint64_t{c.used} | std::uint64_t{c.slack} << 1 | std::uint64_t{c.bodiesCollide} << 2 |
             static_cast<std::uint64_t>(c.truncation.rule) << 3);
}

/// Hashes a pair if it touches or has a contact: bodies, parts, impulses and kept manifold.
void addPairState(StateHash& hash, const WorldData& data, const PairTable& table, std::size_t index) {
    const Pair& pair = table.pairs[index];
    if (table.flags[index].reported) {
        hash.add(pair.key().bodies());
    }
    if (pair.contact == Pair::none) {
        return;
    }
    const Contact& contact = data.contacts.pool[pair.contact];
    hash.add(pair.key().bodies());
    hash.add(pair.key().parts());
    hash.add(contact.tangentImpulse);
    for (int i = 0; i < contact.count; ++i) {
        const ContactPoint& point = contact.points[static_cast<std::size_t>(i)];
        hash.add(std::uint64_t{point.feature});
        hash.add(point.normalImpulse);
    }
    if (pair.kind == PairKind::General) {
        const KeptManifold& kept = contact.manifold;
        hash.add(kept.tolerance);
        add(hash, kept.relative.position);
        hash.add(kept.relative.rotation.s);
    }
}

void addSleepState(StateHash& hash, const WorldData& data) {
    hash.add(std::uint64_t{data.sleep.allowed});
    add(hash, data.sleep.gravity);
    for (const BodyRecord& record : data.bodies.records) {
        hash.add(record.stillTime);
    }
    for (const Slot slot : data.sleep.sleepers) {
        hash.add(std::uint64_t{slot} << 32 | data.bodies.records[slot].island);
    }
    for (const Slot slot : data.sleep.wakeRequests) {
        hash.add(std::uint64_t{slot});
    }
    for (std::size_t i = 0; i < data.sleep.table.size(); ++i) {
        addPairState(hash, data, data.sleep.table, i);
    }
}

void addParameters(StateHash& hash, const UpdateParameters& p) {
    add(hash, p.gravity);
    hash.add(p.seconds);
    hash.add(static_cast<std::uint64_t>(p.iterations) << 32 | static_cast<std::uint64_t>(p.substeps));
}

} // namespace

std::uint64_t World::hash() const {
    const WorldData& data = *m_data;
    StateHash hash;
    addParameters(hash, data.parameters);
    for (Slot slot = 0; slot < data.bodies.records.size(); ++slot) {
        addBodyState(hash, data.bodies.motions[slot], data.bodies.records[slot]);
    }
    for (const ConnectorRecord& c : data.forces.connectors) {
        addConnectorState(hash, c);
    }
    for (const PendingChange& change : data.bodies.pending) {
        hash.add(std::uint64_t{change.body.index} << 32 | change.body.generation);
        hash.add(static_cast<std::uint64_t>(change.kind) | std::uint64_t{change.first} << 8 |
                 std::uint64_t{change.second} << 9);
    }
    for (std::size_t i = 0; i < data.contacts.table.size(); ++i) {
        addPairState(hash, data, data.contacts.table, i);
    }
    for (const BodyId body : data.crushed) {
        hash.add(std::uint64_t{body.index} << 32 | body.generation);
    }
    if (data.sleep.allowed || !data.sleep.sleepers.empty()) {
        addSleepState(hash, data);
    }
    return hash.value();
}

} // namespace spacetow
