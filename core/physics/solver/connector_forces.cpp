#include "core/physics/solver/connector_forces.h"

#include <algorithm>
#include <cmath>

namespace spacetow {

namespace {

// Above this k h²/μ an explicit step would distort the oscillation by more than a percent or so; at 4 it explodes.
constexpr double explicitLimit = 0.25;

struct Run {
    double length;      // beyond the natural length, m
    double rate;        // m/s
    double inverseMass; // of the relative motion, 1/kg
};

/// For how long the tension acts, s: nothing is left for the end of the iteration where the whole sub-step was
/// anticipated.
double duration(double h, Kick kick, bool anticipated) {
    if (anticipated) {
        return kick == Kick::Last ? 0 : h;
    }
    return kickTime(h, kick);
}

/// Sets the connector's tension and returns its impulse, N s.
double pull(ConnectorRecord& c, const Run& s, double h, Kick kick) {
    const double spring = truncated(c.truncation, c.stiffness * s.length);
    // The secant: what truncation leaves of the stiffness.
    const double stiffness = s.length != 0 ? spring / s.length : c.stiffness;
    const bool stiff = stiffness * h * h * s.inverseMass > explicitLimit;
    const double time = duration(h, kick, stiff);
    const double resistance = c.damping + (stiff ? time * stiffness : 0);
    const double tension = (spring + resistance * s.rate) / (1 + time * s.inverseMass * resistance);
    c.tension = c.slack ? std::max(tension, 0.0) : tension;
    return time * c.tension;
}

/// Neither end moves, and the tension is that of before.
bool sleeps(const WorldData& data, const ConnectorRecord& c) {
    const BodyRecord& a = data.records[c.a];
    const BodyRecord& b = data.records[c.b];
    return (a.asleep || b.asleep) && (a.asleep || a.kind == BodyKind::Static) &&
           (b.asleep || b.kind == BodyKind::Static);
}

} // namespace

void applyConnectorForces(WorldData& data, double h, Kick kick) {
    for (ConnectorRecord& c : data.connectors) {
        if (!c.used || sleeps(data, c)) {
            continue;
        }
        c.tension = 0;
        if (!data.records[c.a].active || !data.records[c.b].active) {
            continue;
        }
        BodyMotion& a = data.motions[c.a];
        BodyMotion& b = data.motions[c.b];
        const Vec2 armA = data.scratch.substeps.trial[c.a].rotation * c.anchorA;
        const Vec2 armB = data.scratch.substeps.trial[c.b].rotation * c.anchorB;
        const Vec2 span =
            data.scratch.substeps.trial[c.b].position + armB - data.scratch.substeps.trial[c.a].position - armA;
        const double distance = std::sqrt(span.squaredNorm());
        if (distance == 0 || (c.slack && distance <= c.length)) {
            continue;
        }
        const Vec2 u = span / distance;
        const double leverA = cross(armA, u);
        const double leverB = cross(armB, u);
        const double inverseMass =
            a.inverseMass + b.inverseMass + a.inverseInertia * leverA * leverA + b.inverseInertia * leverB * leverB;
        if (inverseMass == 0) {
            continue;
        }
        const double rate = (b.velocity - a.velocity).dot(u) + b.angularVelocity * leverB - a.angularVelocity * leverA;
        if (!std::isfinite(distance + rate)) { // an end whose state has overflowed is not to spoil the other
            continue;
        }
        const double impulse = pull(c, {distance - c.length, rate, inverseMass}, h, kick);
        a.velocity += impulse * a.inverseMass * u;
        a.angularVelocity += impulse * a.inverseInertia * leverA;
        b.velocity -= impulse * b.inverseMass * u;
        b.angularVelocity -= impulse * b.inverseInertia * leverB;
    }
}

} // namespace spacetow
