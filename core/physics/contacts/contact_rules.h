#pragma once
// The rules of all contacts: speculative margin, target velocity and closing limit.

#include "core/physics/contacts/effective_mass.h"
#include "core/physics/lanes/contact_formulas.h"
#include "core/physics/state/world_data.h"

#include <algorithm>
#include <cmath>

namespace spacetow {

// Approach velocity above which restitution acts, m/s.
constexpr double bounceThreshold = 0.005;

/// Whether a change of velocity, m/s, is more than the rounding error of impulses that cancel each other. `turnChange`
/// is the change of angular velocity times the outer radius, m/s.
inline bool isPush(const Vec2& change, double turnChange) {
    constexpr double least = 1e-12; // m/s
    return oneNorm(change) + std::abs(turnChange) > least;
}

/// Whether contacts with these unit normals may lie in one plane: the angle between them is at most 4.5e-5 rad.
inline bool areParallelNormals(const Vec2& a, const Vec2& b) {
    return a.dot(b) >= 1 - 1e-9;
}

/// Whether contacts of one body with these two bodies may lie in one plane.
inline bool mayShareSurface(const Bodies& bodies, Slot one, Slot other) {
    const auto isStatic = [&](Slot slot) { return bodies.records[slot].kind == BodyKind::Static; };
    return one == other || (isStatic(one) && isStatic(other));
}

/// The speculative margin of two bodies, m; see formulas::speculativeMargin.
inline double speculativeMargin(const PlannedMotion& a, const PlannedMotion& b) {
    const double motion = oneNorm(a.deltaPosition - b.deltaPosition);
    return formulas::speculativeMargin(motion + a.turnMotion + b.turnMotion, a.innerRadius + b.innerRadius);
}

/// The speculative margin of a body against a static one, m.
inline double speculativeMargin(const PlannedMotion& a) {
    return formulas::speculativeMargin(oneNorm(a.deltaPosition) + a.turnMotion, a.innerRadius);
}

/// The bounding circles of two bodies, about their centres of mass.
struct BoundingCircles {
    double radii;   // m, the sum of both radii
    double reach;   // m, `radii` plus the speculative margin
    double squared; // m², squared distance of the centres

    bool areApart() const { return squared > reach * reach; }
    double separation() const { return std::sqrt(squared) - radii; } // m
};

/// Neither body of the pair may be static.
inline BoundingCircles boundingCirclesOf(const Bodies& bodies, const PairBound& bound) {
    const PlannedMotion& a = bodies.plannedMotions[bound.moverA];
    const PlannedMotion& b = bodies.plannedMotions[bound.moverB];
    const double radii = bodies.extents[bound.moverA].outerRadius + bodies.extents[bound.moverB].outerRadius;
    return {radii, radii + speculativeMargin(a, b), (b.center - a.center).squaredNorm()};
}

/// The closing limit of a contact, m/s: with a normal velocity below the limit the contact has not converged. With
/// restitution the limit is just below the target: an impact on a body that touches others would lose energy else.
inline double closingLimit(double separation, double target, double restitution, double perSecond) {
    constexpr double tolerance = 0.001; // m/s
    const double closing = formulas::closingLimit(separation, perSecond);
    return restitution > 0 ? std::max(closing, target - tolerance) : closing;
}

/// The approach velocity of two surfaces along their normal, m/s, positive when they close.
struct Approach {
    double before; // at the beginning of the iteration
    double after;  // with the forces of the iteration, without impulses of contacts
};

/// The approach velocity of two bodies along the unit normal from a to b, at a point with these levers.
inline Approach approachOf(const Bodies& bodies, Slot slotA, Slot slotB, const Vec2& normal, const Levers& levers) {
    const BodyStep& startA = bodies.steps[slotA];
    const BodyStep& startB = bodies.steps[slotB];
    const BodyMotion& a = bodies.motions[slotA];
    const BodyMotion& b = bodies.motions[slotB];
    const double before = (startB.startVelocity - startA.startVelocity).dot(normal) +
                          startB.startAngularVelocity * levers.b - startA.startAngularVelocity * levers.a;
    const double after =
        (b.velocity - a.velocity).dot(normal) + b.angularVelocity * levers.b - a.angularVelocity * levers.a;
    return {-before, -after};
}

/// Whether and when restitution acts: not at all, in this iteration, or at the time of impact.
enum class Bounce : std::uint8_t { None, Now, AtImpact };

struct Target {
    Bounce bounce = Bounce::None;
    double velocity = 0; // m/s: the least normal velocity
};

/// The target of the normal velocity. Surfaces that touch bounce now; the forces of this iteration then act on the
/// rebound. Surfaces that are apart and meet within the iteration bounce at the time of impact. `perSecond` is
/// iterations per second.
inline Target targetOf(const Approach& approach, double separation, double restitution, double perSecond) {
    const double closing = formulas::targetVelocity(separation, perSecond);
    if (separation > linearSlop) {
        const bool meets = std::max(approach.before, approach.after) > (separation - linearSlop) * perSecond;
        return {meets && approach.after > bounceThreshold ? Bounce::AtImpact : Bounce::None, closing};
    }
    const double rebound = restitution * approach.before - (approach.after - approach.before);
    if (approach.before > bounceThreshold && rebound > 0) {
        return {Bounce::Now, rebound};
    }
    return {Bounce::None, closing};
}

} // namespace spacetow
