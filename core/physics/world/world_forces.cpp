// World: forces and impulses from outside.

#include "core/base/contract.h"
#include "core/physics/sleep/sleep.h"
#include "core/physics/solver/force_rules.h"
#include "core/physics/world/world.h"

namespace spacetow {

namespace {

/// A force or impulse of zero wakes no body.
void requestWakeBy(Bodies& bodies, Sleep& sleep, BodyId body, bool anything) {
    if (anything) {
        requestWake(bodies, sleep, body.index);
    }
}

} // namespace

bool World::applyForce(BodyId body, const Vec2& force, ForceSource source) {
    EXPECTS(contains(body));
    return applyForceAt(body, force, m_data->bodies.motions[body.index].center, source);
}

bool World::applyForceAt(BodyId body, const Vec2& force, const Vec2& worldPoint, ForceSource source) {
    EXPECTS(contains(body));
    if (!isFinite(force) || !isFinite(worldPoint)) {
        return false;
    }
    BodyRecord& record = m_data->bodies.records[body.index];
    if (accepts(record, source)) {
        record.force += force;
        record.torque += cross(worldPoint - m_data->bodies.motions[body.index].center, force);
        requestWakeBy(m_data->bodies, m_data->sleep, body, force.squaredNorm() > 0);
    }
    return true;
}

bool World::applyTorque(BodyId body, double torque, ForceSource source) {
    EXPECTS(contains(body));
    if (!std::isfinite(torque)) {
        return false;
    }
    BodyRecord& record = m_data->bodies.records[body.index];
    if (accepts(record, source)) {
        record.torque += torque;
        requestWakeBy(m_data->bodies, m_data->sleep, body, torque != 0);
    }
    return true;
}

bool World::applyImpulseAt(BodyId body, const Vec2& impulse, const Vec2& worldPoint, ForceSource source) {
    EXPECTS(contains(body));
    const double turn = cross(worldPoint - m_data->bodies.motions[body.index].center, impulse);
    if (!isFinite(impulse) || !isFinite(worldPoint) || !std::isfinite(turn)) {
        return false;
    }
    const BodyRecord& record = m_data->bodies.records[body.index];
    if (accepts(record, source) && !record.positionFrozen) {
        m_data->bodies.motions[body.index].velocity += impulse / record.mass;
        requestWakeBy(m_data->bodies, m_data->sleep, body, impulse.squaredNorm() > 0);
    }
    return applyAngularImpulse(body, turn, source);
}

bool World::applyAngularImpulse(BodyId body, double impulse, ForceSource source) {
    EXPECTS(contains(body));
    if (!std::isfinite(impulse)) {
        return false;
    }
    const BodyRecord& record = m_data->bodies.records[body.index];
    if (accepts(record, source) && !record.rotationFrozen && record.inertia > 0) {
        m_data->bodies.motions[body.index].angularVelocity += impulse / record.inertia;
        requestWakeBy(m_data->bodies, m_data->sleep, body, impulse != 0);
    }
    return true;
}

} // namespace spacetow
