#pragma once
// The data of one body: its pose and velocity, its planned motion in an iteration, and its definition. SI units,
// radians.

#include "core/geometry/part.h"
#include "core/geometry/shape.h"
#include "core/math/aabb.h"
#include "core/math/transform.h"
#include "core/physics/def/body.h"
#include "core/physics/def/tolerances.h"
#include "core/physics/lanes/wide.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <vector>

namespace spacetow {

/// Pose, velocity and inverse masses. The solver reads and writes little else.
struct BodyMotion {
    Vec2 center{0, 0}; // of mass, world
    Rot rotation;
    Vec2 velocity{0, 0};
    double angularVelocity = 0;
    double inverseMass = 0;    // 1/kg, 0 if contacts and connectors cannot move the body
    double inverseInertia = 0; // 1/(kg m²), 0 if they cannot turn it

    bool isMoving() const { return angularVelocity != 0 || velocity != Vec2(0, 0); }
    /// Whether anything can move or turn it.
    bool isMovable() const { return inverseMass > 0 || inverseInertia > 0; }
};

/// Coefficients of one integration step without contacts: v₁ = decay·v₀ + gain·a and x₁ = x₀ + gain·v₀ + lag·a. They
/// are the exact solution of v' = a − damping·v for a constant a.
struct FreeMotion {
    double decay = 1;
    double gain = 0; // s
    double lag = 0;  // s²
};

/// The fat AABB of a body. Until its centre of mass leaves `centers`, or the body has turned by `angleLeft`, the pair
/// table has all of its pairs.
struct FatAabb {
    Aabb centers;         // of positions of the centre of mass, m
    double angleLeft = 0; // rad, by which the body may still turn; infinite if any turn will do
};

constexpr Slot noSlot = 0xffffffffu;

/// The working data of a body in one iteration. The members that contacts read come first.
struct alignas(64) BodyStep {
    Vec2 deltaPosition{0, 0};       // of the centre in this iteration, m
    double deltaAngle = 0;          // rad
    double innerRadius = 0;         // m, a copy of BodyRecord::innerRadius
    double outerRadius = 0;         // m, likewise
    double motionBound = 0;         // m: upper bound of the path of any point of the body since the body was added
    bool isCircle = false;          // one circle about the centre of mass: turning changes nothing
    bool movedProxy = false;        // it has left its fat AABB
    bool pushed = false;            // by a contact in this iteration
    bool bounced = false;           // restitution acted on it in this iteration
    bool bouncing = false;          // it will bounce at its time of impact in this iteration
    bool deflected = false;         // by contacts, so far that it may meet bodies off its planned motion
    Slot platform = noSlot;         // the kinematic body that it moves on with after a time of impact
    double fraction = 1;            // of delta position and delta angle, 0 … 1, before the time of impact
    double acceleratedFraction = 1; // of this iteration's acceleration, 0 … 1, that the velocity contains
    Vec2 correction{0, 0};          // position correction, m
    double angleCorrection = 0;     // rad
    Vec2 startVelocity{0, 0};       // at the beginning of the iteration
    double startAngularVelocity = 0;
    Vec2 acceleration{0, 0}; // m/s², gravity and forces, constant during an update
    double angularAcceleration = 0;
    FreeMotion linear, angular;
    FatAabb fat;

    /// How far the outermost points move by the delta angle, m.
    double maxTurnMotion() const { return isCircle ? 0 : std::abs(deltaAngle) * outerRadius; }
    /// Upper bound of the motion of any point of the body in this iteration, m. No turn moves a point by more than the
    /// diameter.
    double maxMotion() const {
        return std::sqrt(deltaPosition.squaredNorm()) +
               (isCircle ? 0 : std::min(std::abs(deltaAngle), 2.0) * outerRadius);
    }
};

/// What contacts read of a body, in one cache line. A copy, made when the motion of the body is planned.
struct alignas(64) PlannedMotion {
    Vec2 center{0, 0};
    Rot rotation;
    Vec2 deltaPosition{0, 0};
    double turnMotion = 0; // m, see BodyStep::maxTurnMotion
    double innerRadius = 0;

    PlannedMotion() = default;
    PlannedMotion(const BodyMotion& m, const BodyStep& s)
        : center(m.center), rotation(m.rotation), deltaPosition(s.deltaPosition), turnMotion(s.maxTurnMotion()),
          innerRadius(s.innerRadius) {}
    Transform pose() const { return {center, rotation}; }
};

/// What the broad phase and the narrow phase read of a body, likewise a copy.
struct BodyExtent {
    double motionBound = 0; // m, at the beginning of the iteration
    double outerRadius = 0;
};

// rad in an iteration: the rounding error of the angle after a larger turn would be a visible part of a full turn.
constexpr double greatestTurn = 1e8;

/// Whether pose, velocity and planned motion are finite, and the turn is not too large to be resolved.
inline bool isSound(const BodyMotion& m, const BodyStep& s) {
    return std::isfinite(m.velocity.squaredNorm() + m.angularVelocity + s.deltaPosition.squaredNorm() + m.center.x() +
                         m.center.y() + m.rotation.c + m.rotation.s) &&
           std::abs(s.deltaAngle) <= greatestTurn;
}

/// Whether a motion, m, exceeds the speculative margin of the body; see formulas::speculativeMargin.
inline bool exceedsMargin(const BodyStep& s, double motion) {
    return motion > 0.5 * s.innerRadius && motion > linearSlop;
}
inline bool isFast(const BodyStep& s) {
    return exceedsMargin(s, s.maxMotion());
}

/// The definition of a body, and its state outside of iterations.
struct BodyRecord {
    std::uint32_t generation = 0; // grows with every removal, so that old ids become invalid
    bool used = false;
    std::uint64_t serial = 0; // order of creation
    BodyKind kind = BodyKind::Static;
    std::shared_ptr<const std::vector<Shape>> shapes; // about the local origin
    std::shared_ptr<const std::vector<Part>> parts;   // about the centre of mass
    Vec2 localCenter{0, 0};
    double mass = 0; // kg, also of kinematic bodies; 0 for static ones
    double inertia = 0;
    double innerRadius =
        0; // m, least over the parts: the largest circle about a part's own centre inside it; 0 for walls
    double outerRadius = 0; // m, of the smallest circle about the centre of mass around the body
    double restitution = 0;
    double friction = 0;
    double linearDamping = 0;
    double angularDamping = 0;
    Filter filter;
    bool tangible = true;
    bool active = true;
    bool positionFrozen = false;
    bool rotationFrozen = false;
    bool reportsTouches = false;
    bool substepped = false; // it is integrated in sub-steps, because an active connector acts on it
    bool asleep = false;
    Slot island = 0;      // of a sleeping body: the root of its island, which wakes as a whole
    double stillTime = 0; // s, since when it has been slower than the sleep velocity
    std::uint64_t user = 0;
    Vec2 force{0, 0}; // N, for the next update
    double torque = 0;
    Aabb bounds;                   // fat AABB of the last broad phase; empty if a call has moved the body since
    std::uint32_t firstStatic = 0; // of a static body: index of its first part in BroadPhase::statics
};

} // namespace spacetow
