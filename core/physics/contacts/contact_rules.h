#pragma once
// The rules of all contacts: speculative margin, target velocity and closing limit.

#include "core/physics/lanes/contact_formulas.h"
#include "core/physics/state/world_data.h"

#include <algorithm>
#include <cmath>

namespace spacetow {

// Slower impacts come to rest, m/s.
constexpr double bounceThreshold = 0.005;

/// Whether a change of velocity is more than what rounding leaves of an impulse that was given and taken back. m/s.
inline bool isPush(const Vec2& change, double turnChange) {
    constexpr double least = 1e-12;
    return std::abs(change.x()) + std::abs(change.y()) + std::abs(turnChange) > least;
}

/// Whether contacts with these unit normals may be in one plane.
inline bool areParallelNormals(const Vec2& a, const Vec2& b) {
    return a.dot(b) >= 1 - 1e-9;
}

/// See contact_formulas.h.
inline double speculativeMargin(const PlannedMotion& a, const PlannedMotion& b) {
    const Vec2 apart = a.deltaPosition - b.deltaPosition;
    const double motion = std::abs(apart.x()) + std::abs(apart.y()); // no less than the length, and cheaper
    return formulas::speculativeMargin(motion + a.turnMotion + b.turnMotion, a.innerRadius + b.innerRadius);
}

/// The same against a static body.
inline double speculativeMargin(const PlannedMotion& a) {
    const double motion = std::abs(a.deltaPosition.x()) + std::abs(a.deltaPosition.y());
    return formulas::speculativeMargin(motion + a.turnMotion, a.innerRadius);
}

/// The bounding circles of the bodies of a pair, about their centres of mass.
struct BoundingCircles {
    double radii;   // m, of both together
    double reach;   // m: further apart they do not meet in this iteration
    double squared; // m², of the distance of their centres

    bool areApart() const { return squared > reach * reach; }
    double separation() const { return std::sqrt(squared) - radii; } // m
};

/// Of two bodies that move.
inline BoundingCircles boundingCirclesOf(const Bodies& bodies, const PairBound& bound) {
    const PlannedMotion& a = bodies.plannedMotions[bound.moverA];
    const PlannedMotion& b = bodies.plannedMotions[bound.moverB];
    const double radii = bodies.extents[bound.moverA].outerRadius + bodies.extents[bound.moverB].outerRadius;
    return {radii, radii + speculativeMargin(a, b), (b.center - a.center).squaredNorm()};
}

/// From which velocity on surfaces close faster than they may, so that their component is solved on, m/s. Where
/// something bounces each wants what it aims at: a hit on what touches something else would lose energy.
inline double closingLimit(double separation, double target, double restitution, double perSecond) {
    constexpr double tolerance = 0.001; // m/s
    const double closing = formulas::closingLimit(separation, perSecond);
    return restitution > 0 ? std::max(closing, target - tolerance) : closing;
}

struct Approach {
    double before; // m/s along the normal at the beginning of the iteration, positive when closing
    double after;  // with this iteration's forces
};

enum class Bounce : std::uint8_t { None, Now, AtImpact };

struct Target {
    Bounce bounce = Bounce::None;
    double velocity = 0; // m/s: the normal velocity is to be at least this
};

/// What the normal velocity is to be. Surfaces that touch bounce at once, and fall back under this iteration's forces;
/// those still apart are to be stopped where they meet. `perSecond` is the number of iterations in a second.
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
