#include "core/physics/solver/impulse_log.h"

namespace spacetow {

namespace {

/// The entry of the contact in this update. A new entry if the pool has reused the contact for other bodies.
LoggedImpulse& logOf(ImpulseLog& log, std::uint32_t contact, Slot a, Slot b) {
    if (contact >= log.places.size()) {
        log.places.resize(contact + 1, 0);
    }
    std::uint32_t& place = log.places[contact];
    if (place != 0 && log.impulses[place - 1].a == a && log.impulses[place - 1].b == b) {
        return log.impulses[place - 1];
    }
    if (place == 0) {
        log.placed.push_back(contact);
    }
    LoggedImpulse& fresh = log.impulses.emplace_back();
    fresh.a = a;
    fresh.b = b;
    place = static_cast<std::uint32_t>(log.impulses.size());
    return fresh;
}

/// The impulses of one lane.
struct Given {
    double normal, friction; // N s
    Vec2 direction;          // unit, of the normal
    double turnA, turnB;     // N m s; on a with opposite sign
};

void addTo(LoggedImpulse& sum, const Given& given) {
    sum.normal += given.normal;
    sum.friction += given.friction;
    sum.normalOnB += given.normal * given.direction;
    sum.frictionOnB += given.friction * leftOf(given.direction);
    sum.turnA -= given.turnA;
    sum.turnB += given.turnB;
}

void logCircles(const Bodies& bodies, const Constraints& constraints, ImpulseLog& impulses) {
    for (const CircleContact& c : constraints.circleContacts) {
        const CircleBatch& batch = constraints.batches.circles[c.lane.batch];
        const std::uint32_t i = c.lane.lane;
        const double normal = batch.normalImpulse[i];
        const double friction = batch.tangentImpulse[i];
        if (normal == 0 && friction == 0) {
            continue;
        }
        const Vec2 direction(batch.normalX[i], batch.normalY[i]);
        LoggedImpulse& sum = logOf(impulses, c.contact, c.a, c.b);
        addTo(sum, {normal, friction, direction, friction * batch.leverA[i], friction * batch.leverB[i]});
        sum.moment += normal * (bodies.motions[c.a].center + batch.leverA[i] * direction);
    }
}

Vec2 pointOnA(const Bodies& bodies, const Constraints& constraints, const GeneralContact& c, bool second) {
    const ContactAnchors& anchors = constraints.batches.general.anchors(c.lane.batch);
    const std::uint32_t i = c.lane.lane;
    return bodies.pose(c.a).toWorld(second ? Vec2(anchors.onA2X[i], anchors.onA2Y[i])
                                           : Vec2(anchors.onA1X[i], anchors.onA1Y[i]));
}

void logGeneral(const Bodies& bodies, const Constraints& constraints, ImpulseLog& impulses) {
    for (const GeneralContact& c : constraints.generalContacts) {
        const ConstraintBatch& batch = constraints.batches.general[c.lane.batch];
        const std::uint32_t i = c.lane.lane;
        const double first = batch.impulse1[i];
        const double second = batch.impulse2[i];
        const double friction = batch.tangentImpulse[i];
        if (first == 0 && second == 0 && friction == 0) {
            continue;
        }
        const double turnA = first * batch.leverA1[i] + second * batch.leverA2[i] + friction * batch.tangentLeverA[i];
        const double turnB = first * batch.leverB1[i] + second * batch.leverB2[i] + friction * batch.tangentLeverB[i];
        LoggedImpulse& sum = logOf(impulses, c.points[0].contact, c.a, c.b);
        addTo(sum, {first + second, friction, {batch.normalX[i], batch.normalY[i]}, turnA, turnB});
        sum.moment += first * pointOnA(bodies, constraints, c, false);
        if (second != 0) {
            sum.moment += second * pointOnA(bodies, constraints, c, true);
        }
    }
}

} // namespace

void beginImpulseLog(ImpulseLog& impulses, double seconds) {
    ImpulseLog& log = impulses;
    log.seconds = seconds;
    for (const std::uint32_t contact : log.placed) {
        log.places[contact] = 0;
    }
    log.placed.clear();
    log.impulses.clear();
}

void logImpulses(const Bodies& bodies, const Constraints& constraints, ImpulseLog& impulses) {
    logCircles(bodies, constraints, impulses);
    logGeneral(bodies, constraints, impulses);
}

} // namespace spacetow
