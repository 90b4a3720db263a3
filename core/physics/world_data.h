#pragma once
// The arrays behind a world, as the stages of the update see them. Body slots are used again after a removal; slot
// order is the same for equal histories, so it may decide the order of work. SI units, radians.

#include "core/geometry/moving_quadtree.h"
#include "core/geometry/part.h"
#include "core/geometry/static_quadtree.h"
#include "core/math/aabb.h"
#include "core/physics/world.h"

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace spacetow {

using Slot = std::uint32_t;

/// What moves. The solver reads and writes little else.
struct BodyMotion {
    Vec2 center{0, 0}; // of mass, world
    Rot rotation;
    Vec2 velocity{0, 0};
    double angularVelocity = 0;
    double inverseMass = 0;    // as contacts and connectors feel it: 0 for what they cannot move
    double inverseInertia = 0; // likewise
};

/// How a body moves when nothing touches it, with the time step it takes: v₁ = decay·v₀ + gain·a and
/// x₁ = x₀ + gain·v₀ + lag·a, the exact solution of v' = a − damping·v for a constant a.
struct FreeMotion {
    double decay = 1;
    double gain = 0; // s
    double lag = 0;  // s²
};

/// What one iteration needs to know of a body beside its motion.
struct BodyStep {
    Vec2 acceleration{0, 0}; // m/s², gravity and forces, constant during an update
    double angularAcceleration = 0;
    FreeMotion linear, angular;
    Vec2 startVelocity{0, 0}; // at the beginning of the iteration
    double startAngularVelocity = 0;
    Vec2 shift{0, 0};     // of the centre in this iteration, m
    double turn = 0;      // rad
    double reach = 0;     // no point of the body moves further in this iteration, m
    double fraction = 1;  // of shift and turn that is carried out
    bool pushed = false;  // by a contact in this iteration
    bool bounced = false; // off one
};

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
    bool connected = false; // by an active connector
    std::uint64_t user = 0;
    Vec2 force{0, 0}; // N, for the next update
    double torque = 0;
    TagMask touchedTags;
    std::uint64_t lastReport = ~std::uint64_t{0}; // iteration count of the last tags-touched event
    Aabb bounds;                                  // of the last broad phase
    Aabb centerBox;                               // while the centre stays in here the pairs found are all there are
    double turnLeft = 0;                          // rad the body may still turn before that ceases to be true
    std::uint32_t firstStatic = 0;                // of its parts in StaticGeometry
};

/// The parts of all static bodies in world coordinates; immutable, shared between copies of a world.
struct StaticGeometry {
    struct Collider {
        Slot body;
        std::uint32_t part;
        Part shape;
    };
    std::vector<Collider> colliders;
    StaticQuadtree tree;
};

struct ContactPoint {
    std::uint32_t feature = 0;
    double normalImpulse = 0; // N s, of the last iteration
    double tangentImpulse = 0;
    bool fresh = true; // touched for the first time: what stopped an impact is not carried on
};

/// Two parts that may meet during this update. `bodyA` moves; it has the lower slot when both do.
struct Pair {
    Slot bodyA = 0, bodyB = 0;
    std::uint32_t partA = 0, partB = 0;
    const Part* shapeA = nullptr; // about the centre of mass
    const Part* shapeB = nullptr; // likewise, or in world coordinates for a static body
    bool staticB = false;
    bool solid = true; // false: felt, without force
    bool touching = false;
    bool sweep = false; // the parts are to be stopped where they meet, to bounce from there
    int count = 0;
    std::array<ContactPoint, 2> points;

    std::uint64_t bodies() const { return std::uint64_t{bodyA} << 32 | bodyB; }
    std::uint64_t parts() const { return std::uint64_t{partA} << 32 | partB; }
    bool operator<(const Pair& o) const { return bodies() != o.bodies() ? bodies() < o.bodies() : parts() < o.parts(); }
};

/// A part of a moving body with the box it cannot leave unnoticed.
struct MovingCollider {
    Slot body;
    std::uint32_t part;
    Aabb box;
};

struct ConstraintPoint {
    Vec2 armA{0, 0}, armB{0, 0}; // from the centres of mass to the contact point
    double separation = 0;
    double normalMass = 0;
    double tangentMass = 0;
    double normalImpulse = 0;
    double tangentImpulse = 0;
    double target = 0; // m/s: the normal velocity is to be at least this
    bool bounces = false;
    std::uint32_t pair = 0; // where its impulses are kept
    std::uint32_t index = 0;
};

/// A contact as the solver sees it, for one iteration.
struct Constraint {
    Slot a = 0, b = 0;
    int count = 0;
    bool block = false; // the two points are solved together
    Vec2 normal{0, 1};  // from a to b
    double friction = 0;
    double restitution = 0;
    double coupling = 0; // off-diagonal element of the two points' mass matrix
    double determinant = 0;
    std::array<ConstraintPoint, 2> points;
};

struct ConnectorRecord {
    std::uint32_t generation = 0;
    bool used = false;
    Slot a = 0, b = 0;
    Vec2 anchorA{0, 0}, anchorB{0, 0}; // about the centres of mass
    double length = 0;
    double stiffness = 0;
    double damping = 0;
    bool slack = false;
    bool bodiesCollide = false;
    Truncation truncation;
    double tension = 0;
};

struct PendingChange {
    enum class Kind : std::uint8_t { Remove, Active, Tangible, Frozen } kind;
    BodyId body;
    bool first = false, second = false;
};

using SlotPair = std::pair<Slot, Slot>; // lower first

struct WorldData {
    UpdateParameters parameters;

    // Bodies, by slot.
    std::vector<BodyMotion> motions;
    std::vector<BodyStep> steps;
    std::vector<BodyRecord> records;
    std::vector<Slot> freeSlots;
    std::uint64_t nextSerial = 0;
    std::uint64_t iterationCount = 0; // since the world was made

    std::vector<ConnectorRecord> connectors;
    std::vector<std::uint32_t> freeConnectors;
    std::vector<SlotPair> notColliding; // sorted

    std::vector<PendingChange> pending;
    std::shared_ptr<const StaticGeometry> statics;
    bool staticsChanged = true;

    std::vector<Pair> pairs;        // sorted
    std::vector<SlotPair> touching; // body pairs in contact after the last iteration, sorted
    Events events;
    std::vector<RemovedEvent> removedBefore; // since the last update

    // Working memory, kept so that a steady update allocates nothing.
    MovingQuadtree tree;
    std::vector<Slot> moving;              // active, kinematic bodies first
    std::vector<MovingCollider> colliders; // of `moving`
    std::vector<Pair> newPairs;
    std::vector<std::uint32_t> found;
    std::vector<Constraint> constraints;
    std::vector<SlotPair> touchingNow;
    std::vector<Transform> trial; // poses during sub-steps, by slot

    BodyId idOf(Slot slot) const { return {slot, records[slot].generation}; }
    Transform pose(Slot slot) const { return {motions[slot].center, motions[slot].rotation}; }
};

/// What is constant during the iterations of one update.
struct IterationStep {
    double dt;      // s, of one iteration
    double substep; // s
    int substeps;
    double remaining; // s until the end of the update, this iteration included
    int index;
    int passes; // of the velocity solver
};

/// Penetration that is left alone so that resting contacts persist, m.
constexpr double linearSlop = 0.0005;

} // namespace spacetow
