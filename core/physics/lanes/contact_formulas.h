#pragma once
// The formulas of contacts, each in one place: for one contact (T is double) and for four (T is Wide), to the same
// bits.

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

/// How near surfaces have to be to count as in contact, m: no less than they approach each other in the iteration, but
/// not more than half of both inner radii together. Beyond that the time of impact takes over, whose normal is that of
/// the impact and not that of the start.
template <class T>
SPACETOW_INLINE T speculativeMargin(T motion, T innerRadii) {
    return linearSlop + lesser(motion, 0.5 * innerRadii);
}

/// The normal velocity of surfaces that do not bounce is to be at least this, m/s: they may close their gap in the
/// iteration, and no more.
template <class T>
SPACETOW_INLINE T targetVelocity(T separation, double perSecond) {
    return separation > T{} ? -separation * perSecond : T{};
}

/// How far surfaces may go into each other in the iteration where the solver has not converged, m: up to the slop.
template <class T>
SPACETOW_INLINE T penetrationAllowance(T separation) {
    return greater(separation + linearSlop, T{} + 0.1 * linearSlop);
}

/// The normal velocity that goes with it, m/s.
template <class T>
SPACETOW_INLINE T closingLimit(T separation, double perSecond) {
    return -perSecond * penetrationAllowance(separation);
}

/// How much an impulse with some levers a and b about the centres of mass, m, moves two bodies along others, 1/kg: an
/// element of the inverse mass matrix of a contact. The masses and inertias of both bodies are inverse.
template <class Masses, class Levers>
SPACETOW_INLINE auto inverseMass(const Masses& m, const Levers& levers, const Levers& along) {
    return m.massA + m.massB + m.inertiaA * levers.a * along.a + m.inertiaB * levers.b * along.b;
}

/// Likewise, along the impulse itself: the inverse of the effective mass.
template <class Masses, class Levers>
SPACETOW_INLINE auto inverseMass(const Masses& m, const Levers& levers) {
    return inverseMass(m, levers, levers);
}

/// What resists an impulse, kg; 0 for bodies that do not yield to it, or by no more than `least`, 1/kg.
template <class T>
SPACETOW_INLINE T effectiveMass(T inverseMass, T least) {
    return inverseMass > least ? 1 / inverseMass : T{};
}

} // namespace spacetow::formulas
