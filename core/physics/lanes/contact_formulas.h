#pragma once
// The formulas of contacts, for one contact (T is double) and for four (T is Wide). Both give the same bits. SI units.

#include "core/physics/def/tolerances.h"
#include "core/physics/lanes/wide.h"

#define SPACETOW_INLINE inline __attribute__((always_inline))

namespace spacetow::formulas {

template <class T>
SPACETOW_INLINE T lesser(T a, T b) {
    return a < b ? a : b;
}

template <class T>
SPACETOW_INLINE T greater(T a, T b) {
    return a > b ? a : b;
}

/// Speculative margin, m: surfaces nearer than this have a contact. It is the motion of both bodies in the iteration
/// plus the slop, at most half of both inner radii plus the slop. Larger gaps are left to the time of impact, whose
/// normal is that of the moment of impact.
template <class T>
SPACETOW_INLINE T speculativeMargin(T motion, T innerRadii) {
    return linearSlop + lesser(motion, 0.5 * innerRadii);
}

/// Least normal velocity without restitution, m/s: the surfaces may close their separation (m) in this iteration, and
/// no more. `perSecond` is iterations per second, here and below.
template <class T>
SPACETOW_INLINE T targetVelocity(T separation, double perSecond) {
    return separation > T{} ? -separation * perSecond : T{};
}

/// Motion along the normal, m, that is tolerated where the solver has not converged: up to a penetration of the slop.
template <class T>
SPACETOW_INLINE T penetrationAllowance(T separation) {
    return greater(separation + linearSlop, T{} + 0.1 * linearSlop);
}

/// The normal velocity of penetrationAllowance, m/s.
template <class T>
SPACETOW_INLINE T closingLimit(T separation, double perSecond) {
    return -perSecond * penetrationAllowance(separation);
}

/// An element of the inverse mass matrix of a contact, 1/kg: the velocity at the levers `along` per impulse at
/// `levers`. Levers are about the centres of mass, m. `m` has inverse masses and inverse inertias.
template <class Masses, class Levers>
SPACETOW_INLINE auto inverseMass(const Masses& m, const Levers& levers, const Levers& along) {
    return m.massA + m.massB + m.inertiaA * levers.a * along.a + m.inertiaB * levers.b * along.b;
}

/// A diagonal element, 1/kg: the inverse of the effective mass.
template <class Masses, class Levers>
SPACETOW_INLINE auto inverseMass(const Masses& m, const Levers& levers) {
    return inverseMass(m, levers, levers);
}

/// The effective mass, kg; 0 where the inverse mass is at most `least`, 1/kg, so that an impulse moves nothing.
template <class T>
SPACETOW_INLINE T effectiveMass(T inverseMass, T least) {
    return inverseMass > least ? 1 / inverseMass : T{};
}

} // namespace spacetow::formulas
