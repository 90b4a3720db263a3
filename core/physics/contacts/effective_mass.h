#pragma once
// What two bodies have against an impulse between them. E. Catto, "Iterative Dynamics with Temporal Coherence" (2005).

#include "core/physics/lanes/contact_formulas.h"
#include "core/physics/state/world_data.h"

namespace spacetow {

/// Of a force on two bodies, m.
struct Levers {
    double a, b;
};

/// What moves no more than this under an impulse does not yield to it, 1/kg; see effectiveMass.
inline double leastInverseMass(const Bodies& bodies, Slot slotA, Slot slotB) {
    const double radiusA = bodies.extents[slotA].outerRadius;
    const double radiusB = bodies.extents[slotB].outerRadius;
    return 1e-4 * (bodies.motions[slotA].inverseInertia * radiusA * radiusA +
                   bodies.motions[slotB].inverseInertia * radiusB * radiusB);
}

/// What resists an impulse with these levers, kg; 0 when nothing can move. A body that may only turn cannot yield to a
/// push through its centre, nor to one that goes past it by less than a hundredth of its radius: that would make it
/// spin beyond all measure.
inline double effectiveMass(const Bodies& bodies, Slot slotA, Slot slotB, const Levers& levers) {
    const BodyMotion& a = bodies.motions[slotA];
    const BodyMotion& b = bodies.motions[slotB];
    // formulas::inverseMass but for the order of the sum, which is in the last bit of every recorded run.
    const double turning = a.inverseInertia * levers.a * levers.a + b.inverseInertia * levers.b * levers.b;
    const double inverse = a.inverseMass + b.inverseMass + turning;
    return formulas::effectiveMass(inverse, leastInverseMass(bodies, slotA, slotB));
}

/// Inverse ones, see contact_formulas.h.
struct InverseMasses {
    double massA, massB, inertiaA, inertiaB;
};
inline InverseMasses massesOf(const BodyMotion& a, const BodyMotion& b) {
    return {a.inverseMass, b.inverseMass, a.inverseInertia, b.inverseInertia};
}

/// The off-diagonal element of the inverse mass matrix of two such impulses along one normal, 1/kg.
inline double couplingOf(const BodyMotion& a, const BodyMotion& b, const Levers& l1, const Levers& l2) {
    return formulas::inverseMass(massesOf(a, b), l1, l2);
}

/// From the point's arm.
inline void setLevers(const Bodies& bodies, const Constraint& c, ConstraintPoint& p) {
    const Vec2 armB = p.armA + bodies.motions[c.a].center - bodies.motions[c.b].center;
    const Vec2 tangent = leftOf(c.normal);
    p.leverA = cross(p.armA, c.normal);
    p.leverB = cross(armB, c.normal);
    p.tangentLeverA = cross(p.armA, tangent);
    p.tangentLeverB = cross(armB, tangent);
    p.normalMass = effectiveMass(bodies, c.a, c.b, {p.leverA, p.leverB});
}

/// What the points have to do with each other, from their levers. Friction acts half way between them.
inline void setCouplingAndFriction(const Bodies& bodies, Constraint& c) {
    const ConstraintPoint& p = c.points[0];
    const ConstraintPoint& q = c.points[c.count == 2 ? 1 : 0];
    c.coupling = couplingOf(bodies.motions[c.a], bodies.motions[c.b], {p.leverA, p.leverB}, {q.leverA, q.leverB});
    c.tangentLeverA = 0.5 * (p.tangentLeverA + q.tangentLeverA);
    c.tangentLeverB = 0.5 * (p.tangentLeverB + q.tangentLeverB);
    c.tangentMass = effectiveMass(bodies, c.a, c.b, {c.tangentLeverA, c.tangentLeverB});
}

} // namespace spacetow
