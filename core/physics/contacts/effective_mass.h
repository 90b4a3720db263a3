#pragma once
// Effective masses and levers of contacts. E. Catto, "Iterative Dynamics with Temporal Coherence" (2005). SI units.

#include "core/physics/lanes/contact_formulas.h"
#include "core/physics/state/world_data.h"

namespace spacetow {

/// The levers of a force about the centres of mass of two bodies, m.
struct Levers {
    double a, b;
};

/// Inverse mass, 1/kg, up to which an impulse counts as moving neither body; see effectiveMass.
inline double leastInverseMass(const Bodies& bodies, Slot slotA, Slot slotB) {
    const double radiusA = bodies.extents[slotA].outerRadius;
    const double radiusB = bodies.extents[slotB].outerRadius;
    return 1e-4 * (bodies.motions[slotA].inverseInertia * radiusA * radiusA +
                   bodies.motions[slotB].inverseInertia * radiusB * radiusB);
}

/// The effective mass of an impulse with these levers, kg; 0 if the impulse moves neither body. A body that can only
/// turn has an effective mass of 0 for levers below a hundredth of its radius: it would get an unbounded spin.
inline double effectiveMass(const Bodies& bodies, Slot slotA, Slot slotB, const Levers& levers) {
    const BodyMotion& a = bodies.motions[slotA];
    const BodyMotion& b = bodies.motions[slotB];
    // formulas::inverseMass with another order of the sum: the last bit of every recorded run depends on the order.
    const double turning = a.inverseInertia * levers.a * levers.a + b.inverseInertia * levers.b * levers.b;
    const double inverse = a.inverseMass + b.inverseMass + turning;
    return formulas::effectiveMass(inverse, leastInverseMass(bodies, slotA, slotB));
}

/// Inverse masses, 1/kg, and inverse inertias, 1/(kg m²), as contact_formulas.h reads them.
struct InverseMasses {
    double massA, massB, inertiaA, inertiaB;
};
inline InverseMasses massesOf(const BodyMotion& a, const BodyMotion& b) {
    return {a.inverseMass, b.inverseMass, a.inverseInertia, b.inverseInertia};
}

/// The off-diagonal element of the inverse mass matrix of two impulses along one normal, 1/kg.
inline double couplingOf(const BodyMotion& a, const BodyMotion& b, const Levers& l1, const Levers& l2) {
    return formulas::inverseMass(massesOf(a, b), l1, l2);
}

/// Sets the levers and the effective mass of a point from its arm.
inline void setLevers(const Bodies& bodies, const Constraint& c, ConstraintPoint& p) {
    const Vec2 armB = p.armA + bodies.motions[c.a].center - bodies.motions[c.b].center;
    const Vec2 tangent = leftOf(c.normal);
    p.leverA = cross(p.armA, c.normal);
    p.leverB = cross(armB, c.normal);
    p.tangentLeverA = cross(p.armA, tangent);
    p.tangentLeverB = cross(armB, tangent);
    p.normalMass = effectiveMass(bodies, c.a, c.b, {p.leverA, p.leverB});
}

/// Sets the coupling of the two points from their levers, and the row of friction, which acts half way between them.
inline void setCouplingAndFriction(const Bodies& bodies, Constraint& c) {
    const ConstraintPoint& p = c.points[0];
    const ConstraintPoint& q = c.points[c.count == 2 ? 1 : 0];
    c.coupling = couplingOf(bodies.motions[c.a], bodies.motions[c.b], {p.leverA, p.leverB}, {q.leverA, q.leverB});
    c.tangentLeverA = 0.5 * (p.tangentLeverA + q.tangentLeverA);
    c.tangentLeverB = 0.5 * (p.tangentLeverB + q.tangentLeverB);
    c.tangentMass = effectiveMass(bodies, c.a, c.b, {c.tangentLeverA, c.tangentLeverB});
}

} // namespace spacetow
