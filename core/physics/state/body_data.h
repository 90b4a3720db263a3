#pragma once
// What is known of a body: its motion, its way in an iteration, and the rest. SI units, radians.

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
    bool yields() const { return inverseMass > 0 || inverseInertia > 0; }
};

/// How a body moves when nothing touches it, with the time step it takes: v₁ = decay·v₀ + gain·a and
/// x₁ = x₀ + gain·v₀ + lag·a, the exact solution of v' = a − damping·v for a constant a.
struct FreeMotion {
    double decay = 1;
    double gain = 0; // s
    double lag = 0;  // s²
};

/// Where a body may go before the pairs found for it cease to be all there are.
struct Room {
    Aabb centers;        // of its centre
    double turnLeft = 0; // rad
};

constexpr Slot noSlot = 0xffffffffu;

/// What one iteration needs to know of a body beside its motion; first what contacts ask for.
struct alignas(64) BodyStep {
    Vec2 shift{0, 0};       // of the centre in this iteration, m
    double turn = 0;        // rad
    double innerRadius = 0; // m, see BodyRecord; of all bodies here and there the same
    double outerRadius = 0;
    double travelled = 0;     // m: no point of the body has gone further since it was added
    bool round = false;       // one circle about the centre of mass: turning changes nothing
    bool escaped = false;     // from its room
    bool pushed = false;      // by a contact in this iteration
    bool bounced = false;     // off one
    bool bouncing = false;    // about to bounce, from where it meets something
    bool diverted = false;    // by contacts, so that it may meet what its planned motion would not have met
    Slot carrier = noSlot;    // the kinematic body that stopped it
    double fraction = 1;      // of shift and turn that is carried out
    double accounted = 1;     // share of this iteration's acceleration that the velocity has
    Vec2 push{0, 0};          // out of overlaps, m
    double pushTurn = 0;      // likewise, rad
    Vec2 startVelocity{0, 0}; // at the beginning of the iteration
    double startAngularVelocity = 0;
    Vec2 acceleration{0, 0}; // m/s², gravity and forces, constant during an update
    double angularAcceleration = 0;
    FreeMotion linear, angular;
    Room room;

    /// The way of the outermost points about the centre, m.
    double turnedWay() const { return round ? 0 : std::abs(turn) * outerRadius; }
    /// No point of the body goes further in this iteration, m; turning moves no point by more than the diameter.
    double reach() const {
        return std::sqrt(shift.squaredNorm()) + (round ? 0 : std::min(std::abs(turn), 2.0) * outerRadius);
    }
};

/// What contacts ask of a body, in one line of memory: copies that are made when its motion is planned.
struct alignas(64) BodyWay {
    Vec2 center{0, 0};
    Rot rotation;
    Vec2 shift{0, 0};
    double turned = 0; // see BodyStep::turnedWay
    double innerRadius = 0;

    BodyWay() = default;
    BodyWay(const BodyMotion& m, const BodyStep& s)
        : center(m.center), rotation(m.rotation), shift(s.shift), turned(s.turnedWay()), innerRadius(s.innerRadius) {}
    Transform pose() const { return {center, rotation}; }
};

/// Likewise.
struct BodyReach {
    double travelled = 0; // m, before the iteration
    double outerRadius = 0;
};

// rad in an iteration: beyond this a turn has no end that could be told.
constexpr double greatestTurn = 1e8;

/// Whether everything about the motion is a number that can be worked with.
inline bool isSound(const BodyMotion& m, const BodyStep& s) {
    return std::isfinite(m.velocity.squaredNorm() + m.angularVelocity + s.shift.squaredNorm() + m.center.x() +
                         m.center.y() + m.rotation.c + m.rotation.s) &&
           std::abs(s.turn) <= greatestTurn;
}

/// Whether the way in this iteration is more than anticipation covers; see contact_rules.h.
inline bool isFar(const BodyStep& s, double reach) {
    return reach > 0.5 * s.innerRadius && reach > linearSlop;
}
inline bool travelsFar(const BodyStep& s) {
    return isFar(s, s.reach());
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
    bool substepped = false; // moves in sub-steps: an active connector or a force field acts on it
    bool asleep = false;
    Slot island = 0;     // of a sleeper: one of the bodies that sleep and wake with it
    double stillFor = 0; // s
    std::uint64_t user = 0;
    Vec2 force{0, 0}; // N, for the next update
    double torque = 0;
    Aabb bounds;                   // of the last broad phase; empty when the body has been put elsewhere since
    Aabb solid;                    // the exact box of a static body when the static tree was made
    std::uint32_t firstStatic = 0; // of its parts in StaticGeometry
};

} // namespace spacetow
