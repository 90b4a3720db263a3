#pragma once
// What is known of a body: its motion, its motion in an iteration, and the rest. SI units, radians.

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

/// What moves. The solver reads and writes little else.
struct BodyMotion {
    Vec2 center{0, 0}; // of mass, world
    Rot rotation;
    Vec2 velocity{0, 0};
    double angularVelocity = 0;
    double inverseMass = 0;    // as contacts and connectors feel it: 0 for what they cannot move
    double inverseInertia = 0; // likewise

    bool isMoving() const { return angularVelocity != 0 || velocity != Vec2(0, 0); }
    /// Whether anything can move or turn it.
    bool isMovable() const { return inverseMass > 0 || inverseInertia > 0; }
};

/// How a body moves when nothing touches it, with the time step it takes: v₁ = decay·v₀ + gain·a and
/// x₁ = x₀ + gain·v₀ + lag·a, the exact solution of v' = a − damping·v for a constant a.
struct FreeMotion {
    double decay = 1;
    double gain = 0; // s
    double lag = 0;  // s²
};

/// Within which the pairs found for a body are all there are.
struct FatAabb {
    Aabb centers;         // of its centre of mass
    double angleLeft = 0; // rad
};

constexpr Slot noSlot = 0xffffffffu;

/// What one iteration needs to know of a body beside its motion; first what contacts ask for.
struct alignas(64) BodyStep {
    Vec2 deltaPosition{0, 0}; // of the centre in this iteration, m
    double deltaAngle = 0;    // rad
    double innerRadius = 0;   // m, see BodyRecord; of all bodies here and there the same
    double outerRadius = 0;
    double motionBound = 0;         // m: no point of the body has gone further since it was added
    bool isCircle = false;          // one circle about the centre of mass: turning changes nothing
    bool movedProxy = false;        // it has left its fat AABB
    bool pushed = false;            // by a contact in this iteration
    bool bounced = false;           // off one
    bool bouncing = false;          // about to bounce, from where it meets something
    bool deflected = false;         // by contacts, so that it may meet what its planned motion would not have met
    Slot platform = noSlot;         // the kinematic body that stopped it
    double fraction = 1;            // of delta position and angle that is carried out
    double acceleratedFraction = 1; // share of this iteration's acceleration that the velocity has
    Vec2 correction{0, 0};          // out of overlaps, m
    double angleCorrection = 0;     // likewise, rad
    Vec2 startVelocity{0, 0};       // at the beginning of the iteration
    double startAngularVelocity = 0;
    Vec2 acceleration{0, 0}; // m/s², gravity and forces, constant during an update
    double angularAcceleration = 0;
    FreeMotion linear, angular;
    FatAabb fat; // AABB of where the centre of mass may go

    /// How far the outermost points move by the delta angle, m.
    double maxTurnMotion() const { return isCircle ? 0 : std::abs(deltaAngle) * outerRadius; }
    /// No point of the body goes further in this iteration, m; turning moves no point by more than the diameter.
    double maxMotion() const {
        return std::sqrt(deltaPosition.squaredNorm()) +
               (isCircle ? 0 : std::min(std::abs(deltaAngle), 2.0) * outerRadius);
    }
};

/// What contacts ask of a body, in one line of memory: copies that are made when its motion is planned.
struct alignas(64) PlannedMotion {
    Vec2 center{0, 0};
    Rot rotation;
    Vec2 deltaPosition{0, 0};
    double turnMotion = 0; // see BodyStep::maxTurnMotion
    double innerRadius = 0;

    PlannedMotion() = default;
    PlannedMotion(const BodyMotion& m, const BodyStep& s)
        : center(m.center), rotation(m.rotation), deltaPosition(s.deltaPosition), turnMotion(s.maxTurnMotion()),
          innerRadius(s.innerRadius) {}
    Transform pose() const { return {center, rotation}; }
};

/// Likewise.
struct BodyExtent {
    double motionBound = 0; // m, before the iteration
    double outerRadius = 0;
};

// rad in an iteration: beyond this a turn has no end that could be told.
constexpr double greatestTurn = 1e8;

/// Whether everything about the motion is a number that can be worked with.
inline bool isSound(const BodyMotion& m, const BodyStep& s) {
    return std::isfinite(m.velocity.squaredNorm() + m.angularVelocity + s.deltaPosition.squaredNorm() + m.center.x() +
                         m.center.y() + m.rotation.c + m.rotation.s) &&
           std::abs(s.deltaAngle) <= greatestTurn;
}

/// Whether the motion in this iteration exceeds the speculative margin; see contact_rules.h.
inline bool exceedsMargin(const BodyStep& s, double reach) {
    return reach > 0.5 * s.innerRadius && reach > linearSlop;
}
inline bool isFast(const BodyStep& s) {
    return exceedsMargin(s, s.maxMotion());
}

/// Everything else about a body.
struct BodyRecord {
    std::uint32_t generation = 0;
    bool used = false;
    std::uint64_t serial = 0; // order of creation
    BodyKind kind = BodyKind::Static;
    std::shared_ptr<const std::vector<Shape>> shapes; // about the local origin
    std::shared_ptr<const std::vector<Part>> parts;   // about the centre of mass
    Vec2 localCenter{0, 0};
    double mass = 0; // kg, also of kinematic bodies; 0 for static ones
    double inertia = 0;
    double innerRadius = 0; // of the largest circle about the centre of mass inside the body; 0 for walls
    double outerRadius = 0; // of the smallest one around it
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
    bool substepped = false; // moves in sub-steps: an active connector acts on it
    bool asleep = false;
    Slot island = 0;      // of a sleeper: one of the bodies that sleep and wake with it
    double stillTime = 0; // s
    std::uint64_t user = 0;
    Vec2 force{0, 0}; // N, for the next update
    double torque = 0;
    Aabb bounds;                   // of the last broad phase; empty when the body has been put elsewhere since
    std::uint32_t firstStatic = 0; // of its parts in WorldData::statics
};

} // namespace spacetow
