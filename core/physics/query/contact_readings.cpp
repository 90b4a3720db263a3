// explain.h: contacts.

#include "core/base/contract.h"
#include "core/geometry/closest.h"
#include "core/physics/query/explain.h"
#include "core/physics/query/present_manifold.h"
#include "core/physics/state/world_data.h"

#include <algorithm>
#include <utility>

namespace spacetow {

namespace {

/// A reading in the order of the pair: a is not static, or has the lower slot.
struct PairReading {
    Slot a, b;
    ContactReading contact;
};

double secondsOf(const WorldData& data) {
    return data.impulses.on && data.impulses.seconds > 0 ? data.impulses.seconds : data.parameters.seconds;
}

/// Sets point and normal: of the manifold, or of the closest points if the parts are apart.
void locate(const Bodies& bodies, const PairTable& table, std::size_t index, ContactReading& contact) {
    const Pair& pair = table.pairs[index];
    const Manifold manifold = presentManifold(bodies, table, index, linearSlop);
    if (manifold.count > 0) {
        contact.normal = manifold.normal;
        contact.point = manifold.points[0].point;
        if (manifold.count == 2) {
            contact.point = 0.5 * (contact.point + manifold.points[1].point);
        }
        return;
    }
    const ClosestPoints closest =
        closestPoints(*pair.shapeA, bodies.pose(pair.bodyA), *pair.shapeB, bodies.poseOfB(pair));
    contact.normal = closest.normal;
    contact.point = closest.distance > 0 ? Vec2(0.5 * (closest.onA + closest.onB)) : bodies.motions[pair.bodyA].center;
}

/// Adds the kept impulses, which are those of the last iteration, times the number of iterations.
void addKept(const WorldData& data, const Pair& pair, ContactReading& contact) {
    if (pair.contact == Pair::none || pair.sweep) {
        return;
    }
    const Contact& kept = data.contacts.pool[pair.contact];
    const double times = data.parameters.iterations * secondsOf(data) / data.parameters.seconds;
    for (std::size_t i = 0; i < static_cast<std::size_t>(kept.count); ++i) {
        contact.normalImpulse += times * kept.points[i].normalImpulse;
    }
    contact.friction = times * kept.tangentImpulse;
    contact.impulse = contact.normalImpulse * contact.normal + contact.friction * leftOf(contact.normal);
    contact.turnA = -cross(contact.point - data.bodies.motions[pair.bodyA].center, contact.impulse);
    contact.turnB = cross(contact.point - data.bodies.motions[pair.bodyB].center, contact.impulse);
}

/// Appends a reading for each touching pair of the body in the table.
void listTouching(const WorldData& data, const PairTable& table, Slot body, std::vector<PairReading>& out) {
    for (std::size_t i = 0; i < table.size(); ++i) {
        const PairFlags& flags = table.flags[i];
        const Pair& pair = table.pairs[i];
        if ((!flags.touching && !flags.passed) || (pair.bodyA != body && pair.bodyB != body)) {
            continue;
        }
        PairReading reading{pair.bodyA, pair.bodyB, {}};
        reading.contact.solid = pair.kind != PairKind::Sensor;
        reading.contact.touching = flags.touching;
        locate(data.bodies, table, i, reading.contact);
        // The log has no impulses of sleeping pairs, which keep those of their last iteration.
        if (!data.impulses.on || (data.bodies.records[pair.bodyA].asleep && &table == &data.sleep.table)) {
            addKept(data, pair, reading.contact);
        }
        out.push_back(reading);
    }
}

ContactReading readingOf(const LoggedImpulse& logged) {
    ContactReading contact;
    contact.touching = false; // placeLogged() sets it
    contact.normalImpulse = logged.normal;
    contact.friction = logged.friction;
    contact.impulse = logged.normalOnB + logged.frictionOnB;
    contact.turnA = logged.turnA;
    contact.turnB = logged.turnB;
    const double length = logged.normalOnB.norm();
    contact.normal = length > 0 ? Vec2(logged.normalOnB / length) : Vec2(0, 1);
    if (logged.normal > 0) {
        contact.point = logged.moment / logged.normal;
    }
    return contact;
}

/// Adds a logged impulse to the nearest touching pair of the same bodies that has none. Without one the bodies touched
/// during the update only.
void placeLogged(const LoggedImpulse& logged, std::vector<PairReading>& out) {
    const ContactReading given = readingOf(logged);
    PairReading* nearest = nullptr;
    for (PairReading& one : out) {
        const bool open = one.a == logged.a && one.b == logged.b && one.contact.impulse == Vec2(0, 0);
        if (open && (nearest == nullptr ||
                     (one.contact.point - given.point).norm() < (nearest->contact.point - given.point).norm())) {
            nearest = &one;
        }
    }
    if (nearest == nullptr) {
        out.push_back({logged.a, logged.b, given});
        return;
    }
    const Vec2 point = nearest->contact.point;
    nearest->contact = given;
    nearest->contact.touching = true;
    nearest->contact.point = given.normalImpulse > 0 ? given.point : point;
}

/// The body that was added first comes first.
ContactReading inOrder(const Bodies& bodies, const PairReading& reading) {
    ContactReading contact = reading.contact;
    contact.a = bodies.idOf(reading.a);
    contact.b = bodies.idOf(reading.b);
    if (bodies.records[reading.b].serial < bodies.records[reading.a].serial) {
        std::swap(contact.a, contact.b);
        std::swap(contact.turnA, contact.turnB);
        contact.normal = -contact.normal;
        contact.impulse = -contact.impulse;
    }
    return contact;
}

} // namespace

double impulseSeconds(const World& world) {
    return secondsOf(world.data());
}

std::vector<ContactReading> contactsOf(const World& world, BodyId body) {
    EXPECTS(world.contains(body));
    const WorldData& data = world.data();
    std::vector<PairReading> found;
    listTouching(data, data.contacts.table, body.index, found);
    listTouching(data, data.sleep.table, body.index, found);
    for (const LoggedImpulse& logged : data.impulses.impulses) {
        const bool isItsOwn = logged.a == body.index || logged.b == body.index;
        if (isItsOwn && data.bodies.records[logged.a].used && data.bodies.records[logged.b].used) {
            placeLogged(logged, found);
        }
    }
    std::vector<ContactReading> contacts;
    contacts.reserve(found.size());
    for (const PairReading& one : found) {
        contacts.push_back(inOrder(data.bodies, one));
    }
    return contacts;
}

} // namespace spacetow
