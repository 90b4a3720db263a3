#pragma once
// What two bodies have against an impulse between them. E. Catto, "Iterative Dynamics with Temporal Coherence" (2005).

#include "core/physics/world_data.h"

namespace spacetow {

/// Of a force on two bodies, m.
struct Levers {
    double a, b;
};

/// What resists an impulse with these levers, kg; 0 when nothing can move. A body that may only turn cannot yield to a
/// push through its centre, nor to one that goes past it by less than a hundredth of its radius: that would make it
/// spin beyond all measure.
inline double massOf(const WorldData& data, Slot slotA, Slot slotB, const Levers& levers) {
    const BodyMotion& a = data.motions[slotA];
    const BodyMotion& b = data.motions[slotB];
    const double turning = a.inverseInertia * levers.a * levers.a + b.inverseInertia * levers.b * levers.b;
    const double radiusA = data.steps[slotA].outerRadius;
    const double radiusB = data.steps[slotB].outerRadius;
    const double least = 1e-4 * (a.inverseInertia * radiusA * radiusA + b.inverseInertia * radiusB * radiusB);
    const double inverse = a.inverseMass + b.inverseMass + turning;
    return inverse > least ? 1 / inverse : 0;
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
    c.tangentMass = massOf(data, c.a, c.b, {c.tangentLeverA, c.tangentLeverB});
}

} // namespace spacetow
