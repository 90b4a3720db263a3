#include "core/physics/query/contact_manifolds.h"

#include "core/physics/query/present_manifold.h"
#include "core/physics/state/world_data.h"

#include <algorithm>

namespace spacetow {

namespace {

// The margin of a manifold that is made for the reading, m: larger than any speculative margin.
constexpr double farthest = 1000;

/// Reads the kept manifold at the present poses.
void readKept(const Bodies& bodies, const Contacts& contacts, const Pair& pair, ContactManifold& reading) {
    const Contact& contact = contacts.pool[pair.contact];
    const KeptManifold& kept = contact.manifold;
    const Transform a = bodies.pose(pair.bodyA);
    const Transform b = bodies.poseOfB(pair);
    reading.normal = (kept.normalOnA ? a : b).rotation * kept.normal;
    reading.count = contact.count;
    for (std::size_t i = 0; i < static_cast<std::size_t>(contact.count); ++i) {
        reading.points[i] = {0.5 * (a.toWorld(kept.points[i].onA) + b.toWorld(kept.points[i].onB)),
                             contact.points[i].normalImpulse};
    }
}

/// Makes a new manifold: circles keep none, and a kept one may be out of date.
void readAnew(const Contact& contact, const Manifold& manifold, ContactManifold& reading) {
    reading.normal = manifold.normal;
    reading.count = std::min(contact.count, manifold.count);
    for (std::size_t i = 0; i < static_cast<std::size_t>(reading.count); ++i) {
        reading.points[i] = {manifold.points[i].point, contact.points[i].normalImpulse};
    }
}

bool isIn(const std::optional<Aabb>& area, const ContactManifold& reading) {
    const auto points = std::span(reading.points).first(static_cast<std::size_t>(reading.count));
    return !area || std::ranges::any_of(points, [&](const auto& point) { return area->contains(point.at); });
}

void readTable(const WorldData& data, const PairTable& table, const std::optional<Aabb>& area,
               std::vector<ContactManifold>& readings) {
    for (std::size_t i = 0; i < table.size(); ++i) {
        const Pair& pair = table.pairs[i];
        if (pair.kind == PairKind::Sensor || pair.contact == Pair::none ||
            data.contacts.pool[pair.contact].count == 0) {
            continue;
        }
        const Contact& contact = data.contacts.pool[pair.contact];
        ContactManifold reading;
        reading.a = data.bodies.idOf(pair.bodyA);
        reading.b = data.bodies.idOf(pair.bodyB);
        reading.touching = table.flags[i].touching;
        reading.tangentImpulse = contact.tangentImpulse;
        contact.manifold.tolerance >= 0 ? readKept(data.bodies, data.contacts, pair, reading)
                                        : readAnew(contact, presentManifold(data.bodies, table, i, farthest), reading);
        const auto pushes = [](const ContactManifold::Point& point) { return point.normalImpulse > 0; };
        reading.touching = reading.touching || std::ranges::any_of(reading.points, pushes);
        if (reading.count > 0 && isIn(area, reading)) {
            readings.push_back(reading);
        }
    }
}

} // namespace

std::vector<ContactManifold> contactManifolds(const World& world, const std::optional<Aabb>& area) {
    const WorldData& data = world.data();
    std::vector<ContactManifold> readings;
    readTable(data, data.contacts.table, area, readings);
    readTable(data, data.sleep.table, area, readings);
    return readings;
}

} // namespace spacetow
