#include "core/physics/connector_forces.h"

namespace spacetow {

namespace {

// Above this k h²/μ an explicit step would distort the oscillation by more than a percent or so; at 4 it explodes.
constexpr double explicitLimit = 0.25;

/// Tension after the sub-step for an extension `x` and its rate `rate`; `inverseMass` is that of the relative motion.
double steppedTension(const ConnectorRecord& c, double x, double rate, double inverseMass, double h) {
    const double spring = truncated(c.truncation, c.stiffness * x);
    const double stiffness = x != 0 ? spring / x : c.stiffness; // the secant: what truncation leaves of the stiffness
    const double implicit = stiffness * h * h * inverseMass > explicitLimit ? h * stiffness : 0;
    const double resistance = c.damping + implicit;
    const double tension = (spring + resistance * rate) / (1 + h * inverseMass * resistance);
    return c.slack ? std::max(tension, 0.0) : tension;
}

} // namespace

void applyConnectorForces(WorldData& data, double h) {
    for (ConnectorRecord& c : data.connectors) {
        if (!c.used) {
            continue;
        }
        c.tension = 0;
        if (!data.records[c.a].active || !data.records[c.b].active) {
            continue;
        }
        BodyMotion& a = data.motions[c.a];
        BodyMotion& b = data.motions[c.b];
        const Vec2 armA = data.trial[c.a].rotation * c.anchorA;
        const Vec2 armB = data.trial[c.b].rotation * c.anchorB;
        const Vec2 span = data.trial[c.b].position + armB - data.trial[c.a].position - armA;
        const double distance = std::sqrt(span.squaredNorm());
        if (distance == 0 || (c.slack && distance <= c.length)) {
            continue;
        }
        const Vec2 u = span / distance;
        const double leverA = cross(armA, u);
        const double leverB = cross(armB, u);
        const double inverseMass = a.inverseMass + b.inverseMass + a.inverseInertia * leverA * leverA +
                                   b.inverseInertia * leverB * leverB;
        if (inverseMass == 0) {
            continue;
        }
        const double rate = (b.velocity - a.velocity).dot(u) + b.angularVelocity * leverB - a.angularVelocity * leverA;
        c.tension = steppedTension(c, distance - c.length, rate, inverseMass, h);
        const double impulse = c.tension * h;
        a.velocity += impulse * a.inverseMass * u;
        a.angularVelocity += impulse * a.inverseInertia * leverA;
        b.velocity -= impulse * b.inverseMass * u;
        b.angularVelocity -= impulse * b.inverseInertia * leverB;
    }
}

} // namespace spacetow
