#include "core/physics/solver/integrate.h"

#include "core/math/trig.h"
#include "core/physics/solver/connector_forces.h"

#include <algorithm>
#include <cmath>

namespace spacetow {

namespace {

/// See FreeMotion; `damping` in 1/s, `h` in s. For weak damping the series avoids cancellation.
FreeMotion freeMotion(double damping, double h) {
    if (damping == 0) { // the usual case
        return {1, h, 0.5 * h * h};
    }
    const double x = damping * h;
    if (x < 1e-4) { // the terms left out are below the last bit
        return {1 - x * (1 - x / 2 * (1 - x / 3)), h * (1 - x / 2 * (1 - x / 3)), h * h * (0.5 - x / 6 * (1 - x / 4))};
    }
    const double decay = expExact(-x);
    const double gain = (1 - decay) / damping;
    return {decay, gain, (h - gain) / damping};
}

struct Displacement {
    Vec2 deltaPosition;
    double deltaAngle;
};

/// Applies one integration step to the velocity, and returns the displacement. Inlined: the result would else be stored
/// in parts and loaded as a whole, which stalls.
[[gnu::always_inline]] inline Displacement integrated(BodyMotion& m, const BodyStep& s) {
    Displacement moved{s.linear.gain * m.velocity + s.linear.lag * s.acceleration,
                       s.angular.gain * m.angularVelocity + s.angular.lag * s.angularAcceleration};
    m.velocity = s.linear.decay * m.velocity + s.linear.gain * s.acceleration;
    m.angularVelocity = s.angular.decay * m.angularVelocity + s.angular.gain * s.angularAcceleration;
    return moved;
}

/// The same between two kicks, which apply the acceleration.
[[gnu::always_inline]] inline Displacement drifted(BodyMotion& m, const BodyStep& s) {
    Displacement moved{s.linear.gain * m.velocity, s.angular.gain * m.angularVelocity};
    m.velocity = s.linear.decay * m.velocity;
    m.angularVelocity = s.angular.decay * m.angularVelocity;
    return moved;
}

/// A body that was stopped at a time of impact loses the velocity that forces would have added after it. So a fall from
/// rest arrives with the speed of its height. A body that contacts have pushed is slowed down by the same energy.
void removeUnusedAcceleration(BodyMotion& m, const BodyStep& s, double dt) {
    const double lost = s.acceleratedFraction - s.fraction;
    if (!s.pushed) {
        m.velocity -= lost * dt * s.acceleration;
        m.angularVelocity -= lost * dt * s.angularAcceleration;
        return;
    }
    const double excess = lost * s.acceleration.dot(s.deltaPosition); // J/kg
    if (excess > 0 && m.inverseMass > 0) {
        const double gyration = m.inverseInertia > 0 ? m.inverseMass / m.inverseInertia : 0; // m², about the centre
        const double kinetic = 0.5 * (m.velocity.squaredNorm() + gyration * m.angularVelocity * m.angularVelocity);
        const double scale = kinetic > excess ? std::sqrt(1 - excess / kinetic) : 0;
        m.velocity *= scale;
        m.angularVelocity *= scale;
    }
}

/// Applies the acceleration, which is constant in the iteration, for `time` seconds. It acts as long as the kick of the
/// connectors and before it, so that implicit connectors hold the weight of a body at rest whatever their stiffness.
void accelerate(Bodies& bodies, Slot slot, double time) {
    bodies.motions[slot].velocity += time * bodies.steps[slot].acceleration;
    bodies.motions[slot].angularVelocity += time * bodies.steps[slot].angularAcceleration;
}

bool anyConnector(const Forces& forces) {
    return forces.connectors.size() != forces.freeConnectors.size();
}

void integrateInSubsteps(const ForceStage& stage, const IterationStep& step) {
    if (!anyConnector(stage.forces)) {
        return;
    }
    Bodies& bodies = stage.bodies;
    Substeps& substeps = stage.substeps;
    const auto substepped = [&](Slot slot) { return bodies.records[slot].substepped; };
    if (!stage.sleep.sleepers.empty() && std::none_of(bodies.moving.begin(), bodies.moving.end(), substepped)) {
        return;
    }
    substeps.trial.resize(bodies.motions.size());
    for (const Slot slot : stage.forces.substepped) {
        substeps.trial[slot] = bodies.pose(slot);
    }
    findImplicit(bodies, stage.forces, substeps, step.substep);
    const auto timeOf = [&](Kick kick, Slot slot) {
        return kickTime(step.substep, kick, substeps.implicit[slot] != 0);
    };
    for (const Slot slot : bodies.moving) {
        if (bodies.records[slot].substepped) {
            accelerate(bodies, slot, timeOf(Kick::First, slot));
        }
    }
    for (int i = 0; i < step.substeps; ++i) {
        const Kick next = i + 1 < step.substeps ? Kick::Between : Kick::Last;
        applyConnectorForces(stage, step.substep, i == 0 ? Kick::First : Kick::Between);
        for (const Slot slot : bodies.moving) {
            if (!bodies.records[slot].substepped) {
                continue;
            }
            const Displacement moved = drifted(bodies.motions[slot], bodies.steps[slot]);
            bodies.steps[slot].deltaPosition += moved.deltaPosition;
            bodies.steps[slot].deltaAngle += moved.deltaAngle;
            substeps.trial[slot].position += moved.deltaPosition;
            substeps.trial[slot].rotation = turned(substeps.trial[slot].rotation, moved.deltaAngle);
            accelerate(bodies, slot, timeOf(next, slot));
        }
    }
    applyConnectorForces(stage, step.substep, Kick::Last);
}

} // namespace

void prepareMotion(Bodies& bodies, const IterationStep& step, const Vec2& gravity) {
    for (const Slot slot : bodies.moving) {
        BodyRecord& record = bodies.records[slot];
        BodyStep& s = bodies.steps[slot];
        s.acceleration = record.force / record.mass;
        s.angularAcceleration = record.inertia > 0 ? record.torque / record.inertia : 0;
        if (record.kind == BodyKind::Dynamic) {
            s.acceleration += gravity;
        }
        if (record.positionFrozen) {
            s.acceleration.setZero();
        }
        if (record.rotationFrozen) {
            s.angularAcceleration = 0;
        }
        record.force.setZero();
        record.torque = 0;
    }
    prepareSteps(bodies, step);
}

void prepareSteps(Bodies& bodies, const IterationStep& step) {
    for (const Slot slot : bodies.moving) {
        const BodyRecord& record = bodies.records[slot];
        const double h = record.substepped ? step.substep : step.dt;
        BodyStep& s = bodies.steps[slot];
        s.linear = record.positionFrozen ? FreeMotion{0, 0, 0} : freeMotion(record.linearDamping, h);
        s.angular = record.rotationFrozen ? FreeMotion{0, 0, 0} : freeMotion(record.angularDamping, h);
    }
}

void integrateVelocities(const ForceStage& stage, const IterationStep& step) {
    Bodies& bodies = stage.bodies;
    const bool substeps = anyConnector(stage.forces); // else there is no need to look at the records
    for (const Slot slot : bodies.moving) {
        BodyMotion& m = bodies.motions[slot];
        BodyStep& s = bodies.steps[slot];
        s.startVelocity = m.velocity;
        s.startAngularVelocity = m.angularVelocity;
        s.deltaPosition.setZero();
        s.deltaAngle = 0;
        s.fraction = s.acceleratedFraction = 1;
        s.platform = noSlot;
        s.correction.setZero();
        s.angleCorrection = 0;
        s.pushed = s.bounced = s.bouncing = s.deflected = false;
        if (!substeps || !bodies.records[slot].substepped) {
            const Displacement moved = integrated(m, s);
            s.deltaPosition = moved.deltaPosition;
            s.deltaAngle = moved.deltaAngle;
        }
    }
    integrateInSubsteps(stage, step);
}

void restoreVelocities(Bodies& bodies) {
    for (const Slot slot : bodies.moving) {
        bodies.motions[slot].velocity = bodies.steps[slot].startVelocity;
        bodies.motions[slot].angularVelocity = bodies.steps[slot].startAngularVelocity;
    }
}

void advance(Bodies& bodies, double dt) {
    for (const Slot slot : bodies.moving) {
        BodyMotion& m = bodies.motions[slot];
        BodyStep& s = bodies.steps[slot];
        if (s.fraction < s.acceleratedFraction) {
            removeUnusedAcceleration(m, s, dt);
        }
        s.deltaPosition = s.fraction * s.deltaPosition + s.correction;
        s.deltaAngle = s.fraction * s.deltaAngle + s.angleCorrection;
        m.center += s.deltaPosition;
        if (s.deltaAngle != 0) {
            m.rotation = turned(m.rotation, s.deltaAngle);
            s.fat.angleLeft -= std::abs(s.deltaAngle);
        }
        s.motionBound += s.maxMotion();
    }
}

void isolateFaults(Bodies& bodies, Events& events, int iteration) {
    for (const Slot slot : bodies.moving) {
        BodyMotion& m = bodies.motions[slot];
        BodyStep& s = bodies.steps[slot];
        if (isSound(m, s)) {
            continue;
        }
        m.velocity.setZero();
        m.angularVelocity = 0;
        s.deltaPosition.setZero();
        s.deltaAngle = 0;
        const auto same = [&](const FaultEvent& fault) { return fault.body == bodies.idOf(slot); };
        const bool known = std::any_of(events.faults.begin(), events.faults.end(), same);
        if (bodies.records[slot].active && !known) {
            events.faults.push_back({iteration, bodies.idOf(slot)});
            bodies.pending.push_back({PendingChange::Kind::Active, bodies.idOf(slot), false, false});
        }
    }
}

} // namespace spacetow
