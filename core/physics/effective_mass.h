#pragma once
// What two bodies have against an impulse between them. E. Catto, "Iterative Dynamics with Temporal Coherence" (2005).

#include "core/physics/world_data.h"

namespace spacetow {

/// A body that may only turn cannot yield to a push through its centre.
inline double inverseOrZero(double x) {
    return x > 0 ? 1 / x : 0;
}

/// Of a force on two bodies, m.
struct Levers {
    double a, b;
};

/// What resists an impulse with these levers, kg; 0 when nothing can move.
inline double massOf(const BodyMotion& a, const BodyMotion& b, const Levers& levers) {
    return inverseOrZero(a.inverseMass + b.inverseMass + a.inverseInertia * levers.a * levers.a +
                         b.inverseInertia * levers.b * levers.b);
}

/// The off-diagonal element of the inverse mass matrix of two such impulses along one normal, 1/kg.
inline double couplingOf(const BodyMotion& a, const BodyMotion& b, const Levers& l1, const Levers& l2) {
    return a.inverseMass + b.inverseMass + a.inverseInertia * l1.a * l2.a + b.inverseInertia * l1.b * l2.b;
}

/// Friction acts half way between the points.
inline void setTangent(const WorldData& data, Constraint& c) {
    const ConstraintPoint& p = c.points[0];
    const ConstraintPoint& q = c.points[c.count == 2 ? 1 : 0];
    c.tangentLeverA = 0.5 * (p.tangentLeverA + q.tangentLeverA);
    c.tangentLeverB = 0.5 * (p.tangentLeverB + q.tangentLeverB);
    c.tangentMass = massOf(data.motions[c.a], data.motions[c.b], {c.tangentLeverA, c.tangentLeverB});
}

} // namespace spacetow
