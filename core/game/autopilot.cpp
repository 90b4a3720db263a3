#include "core/game/autopilot.h"

#include <algorithm>
#include <numbers>

namespace spacetow {
namespace {

Vec2 shortened(const Vec2& v, double longest) {
    const double length = v.norm();
    return length > longest ? Vec2(v * (longest / length)) : v;
}

} // namespace

Autopilot::Autopilot(FlightPlan plan, const PilotHabits& habits) : m_plan(std::move(plan)), m_habits(habits) {}

Controls Autopilot::next(const Session& session) {
    const Phase phase = session.phase();
    if (phase != m_phase) {
        m_phase = phase;
        m_leg = 0;
        m_thrustDebt = m_turnDebt = 0;
        m_legStart = session.ship() ? session.ship()->massCenter : Vec2(0, 0);
    }
    Controls controls;
    if (phase == Phase::AwaitingInput) {
        controls.thrust = !m_last.thrust;
    } else if (phase == Phase::Flying) {
        controls = fly(session, m_plan.toPayload);
        const bool there = m_plan.toPayload.empty() ||
                           (session.ship()->massCenter - m_plan.toPayload.back().position).norm() < m_habits.arrival;
        controls.tow = there && session.payloadInRange() && !m_last.tow;
    } else if (phase == Phase::Towing) {
        controls = fly(session, m_plan.toFinish);
    }
    m_last = controls;
    return controls;
}

Vec2 Autopilot::wantedVelocity(const std::vector<Waypoint>& route, const Vec2& position) {
    if (route.empty()) {
        return shortened(m_legStart - position, 0.3);
    }
    // Follow a point that runs ahead on the route, and go on to the next leg when it comes to the end of this one.
    for (;;) {
        const Vec2 end = route[m_leg].position;
        const Vec2 leg = end - m_legStart;
        const double length = leg.norm();
        const Vec2 along = length > 0 ? Vec2(leg / length) : Vec2(0, 1);
        const double carrot = (position - m_legStart).dot(along) + m_habits.lookAhead;
        const bool last = m_leg + 1 == route.size();
        if (carrot < length || last) {
            const Vec2 aim = m_legStart + along * std::clamp(carrot, 0.0, length);
            const Vec2 way = aim - position;
            const double distance = way.norm();
            double speed = route[m_leg].speed;
            if (last) {
                speed = std::min(speed, 0.8 * (end - position).norm());
            }
            return distance > 1e-9 ? Vec2(way * (std::min(speed, 3 * distance) / distance)) : Vec2(0, 0);
        }
        m_legStart = end;
        ++m_leg;
    }
}

Controls Autopilot::fly(const Session& session, const std::vector<Waypoint>& route) {
    const BodyState ship = *session.ship();
    const Rules& rules = session.level().rules;
    const Vec2 gravity = session.world().parameters().gravity;
    const Vec2 wanted = wantedVelocity(route, ship.massCenter);
    Vec2 acceleration = m_habits.eagerness * (wanted - ship.velocity);
    double mass = ship.mass;
    if (session.phase() == Phase::Towing && session.payload()) {
        // A pendulum on a moving support calms down when the support accelerates after the swing.
        const Vec2 rope = session.payload()->massCenter - ship.massCenter;
        const Vec2 swing = session.payload()->velocity - ship.velocity;
        const Vec2 across = leftOf(rope.normalized());
        acceleration += m_habits.swingDamping * swing.dot(across) * across;
        mass += session.payload()->mass;
    }
    acceleration = shortened(acceleration, m_habits.maxAcceleration);
    const Vec2 force = mass * (acceleration - gravity + rules.shipLinearDamping * ship.velocity);

    Controls controls;
    const Vec2 nose = ship.pose.rotation.up();
    const double ahead = force.dot(nose);
    const double error = arcTangent(cross(nose, force), ahead); // rad, to turn left by
    const double turn =
        (m_habits.attitudeGain * error - m_habits.attitudeDamping * ship.angularVelocity) / rules.steering;
    // Keys are on or off; what a whole update of a key is too much for is saved up.
    m_turnDebt = std::clamp(m_turnDebt + std::clamp(turn, -1.0, 1.0), -1.0, 1.0);
    if (std::abs(m_turnDebt) >= 0.5) {
        controls.left = m_turnDebt > 0;
        controls.right = m_turnDebt < 0;
        m_turnDebt -= m_turnDebt > 0 ? 1 : -1;
    }
    m_thrustDebt = std::clamp(m_thrustDebt + std::clamp(ahead / rules.thrust, 0.0, 1.0), 0.0, 2.0);
    if (m_thrustDebt >= 1) {
        controls.thrust = true;
        m_thrustDebt -= 1;
    }
    return controls;
}

} // namespace spacetow
