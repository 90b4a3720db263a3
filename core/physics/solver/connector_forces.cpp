#include "core/physics/solver/connector_forces.h"

#include "core/physics/contacts/effective_mass.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace spacetow {

namespace {

// Limit of k h²/μ for explicit integration. At 0.25 the frequency is off by about 1 %; from 4 on it is unstable.
constexpr double explicitLimit = 0.25;

struct Stretch {
    double length;      // m, beyond the natural length
    double rate;        // m/s, of `length`
    double inverseMass; // 1/kg, of an impulse along the connector
};

struct Spring {
    double tension;   // N, without damping
    double stiffness; // N/m, secant: truncated tension divided by the stretch
};

Spring springOf(const ConnectorRecord& c, double length) {
    const double tension = truncated(c.truncation, c.stiffness * length);
    return {tension, length != 0 ? tension / length : c.stiffness};
}

bool isStiff(const Spring& spring, double inverseMass, double h) {
    return spring.stiffness * h * h * inverseMass > explicitLimit;
}

/// Sets the connector's tension and returns its impulse, N s.
double pull(ConnectorRecord& c, const Stretch& stretch, double h, Kick kick) {
    const Spring spring = springOf(c, stretch.length);
    const bool stiff = isStiff(spring, stretch.inverseMass, h);
    const double time = kickTime(h, kick, stiff);
    const double resistance = c.damping + (stiff ? time * spring.stiffness : 0);
    const double tension = (spring.tension + resistance * stretch.rate) / (1 + time * stretch.inverseMass * resistance);
    c.tension = c.slack ? std::max(tension, 0.0) : tension;
    return time * c.tension;
}

/// Whether neither end moves, because both are asleep or static. The connector keeps its tension.
bool sleeps(const Bodies& bodies, const ConnectorRecord& c) {
    const BodyRecord& a = bodies.records[c.a];
    const BodyRecord& b = bodies.records[c.b];
    return (a.asleep || b.asleep) && (a.asleep || a.kind == BodyKind::Static) &&
           (b.asleep || b.kind == BodyKind::Static);
}

/// The geometry of a connector under tension at the trial poses of its bodies.
struct Pull {
    Vec2 u{0, 1}; // unit, from anchor a to anchor b
    double leverA = 0, leverB = 0;
    Stretch stretch{};
};

/// Empty if the connector pulls nothing. Inlined: the result would else go through memory.
[[gnu::always_inline]] inline std::optional<Pull> pullOf(const Bodies& bodies, const Substeps& substeps,
                                                         const ConnectorRecord& c) {
    const BodyMotion& a = bodies.motions[c.a];
    const BodyMotion& b = bodies.motions[c.b];
    const Vec2 armA = substeps.trial[c.a].rotation * c.anchorA;
    const Vec2 armB = substeps.trial[c.b].rotation * c.anchorB;
    const Vec2 span = substeps.trial[c.b].position + armB - substeps.trial[c.a].position - armA;
    const double distance = std::sqrt(span.squaredNorm());
    if (distance == 0 || (c.slack && distance <= c.length)) {
        return std::nullopt;
    }
    Pull p;
    p.u = span / distance;
    p.leverA = cross(armA, p.u);
    p.leverB = cross(armB, p.u);
    const double inverseMass = formulas::inverseMass(massesOf(a, b), Levers{p.leverA, p.leverB});
    const double rate =
        (b.velocity - a.velocity).dot(p.u) + b.angularVelocity * p.leverB - a.angularVelocity * p.leverA;
    // The state of one body may be infinite: the other body stays finite.
    if (inverseMass == 0 || !std::isfinite(distance + rate)) {
        return std::nullopt;
    }
    p.stretch = {distance - c.length, rate, inverseMass};
    return p;
}

/// Whether the connector may be too stiff for explicit sub-steps; an upper bound that reads no poses.
bool mayBeStiff(const Bodies& bodies, const ConnectorRecord& c, double h) {
    const BodyMotion& a = bodies.motions[c.a];
    const BodyMotion& b = bodies.motions[c.b];
    const double most = a.inverseMass + b.inverseMass + a.inverseInertia * c.anchorA.squaredNorm() +
                        b.inverseInertia * c.anchorB.squaredNorm();
    return c.truncation.rule == TruncationRule::Custom || c.stiffness * h * h * most > explicitLimit;
}

bool isActive(const Bodies& bodies, const ConnectorRecord& c) {
    return bodies.records[c.a].active && bodies.records[c.b].active;
}

/// Whether the connector exists, its bodies are active, and an end can move.
bool acts(const Bodies& bodies, const ConnectorRecord& c) {
    return c.used && !sleeps(bodies, c) && isActive(bodies, c);
}

} // namespace

void findImplicit(const Bodies& bodies, const Forces& forces, Substeps& substeps, double h) {
    std::vector<std::uint8_t>& implicit = substeps.implicit;
    implicit.resize(bodies.motions.size());
    for (const Slot slot : forces.substepped) {
        implicit[slot] = 0;
    }
    for (const ConnectorRecord& c : forces.connectors) {
        const std::optional<Pull> p =
            mayBeStiff(bodies, c, h) && acts(bodies, c) ? pullOf(bodies, substeps, c) : std::nullopt;
        if (p && isStiff(springOf(c, p->stretch.length), p->stretch.inverseMass, h)) {
            implicit[c.a] = implicit[c.b] = 1;
        }
    }
}

void applyConnectorForces(const ForceStage& stage, double h, Kick kick) {
    for (ConnectorRecord& c : stage.forces.connectors) {
        if (!c.used || sleeps(stage.bodies, c)) {
            continue;
        }
        c.tension = 0;
        const std::optional<Pull> p =
            isActive(stage.bodies, c) ? pullOf(stage.bodies, stage.substeps, c) : std::nullopt;
        if (!p) {
            continue;
        }
        const double impulse = pull(c, p->stretch, h, kick);
        BodyMotion& a = stage.bodies.motions[c.a];
        BodyMotion& b = stage.bodies.motions[c.b];
        a.velocity += impulse * a.inverseMass * p->u;
        a.angularVelocity += impulse * a.inverseInertia * p->leverA;
        b.velocity -= impulse * b.inverseMass * p->u;
        b.angularVelocity -= impulse * b.inverseInertia * p->leverB;
    }
}

} // namespace spacetow
