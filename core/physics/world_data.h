#pragma once
// The arrays behind a world, as the stages of the update see them. Body slots are used again after a removal; slot
// order is the same for equal histories, so it may decide the order of work. SI units, radians.

#include "core/geometry/moving_quadtree.h"
#include "core/geometry/part.h"
#include "core/geometry/static_quadtree.h"
#include "core/geometry/wall_back.h"
#include "core/geometry/wall_side.h"
#include "core/math/aabb.h"
#include "core/physics/contact_batches.h"
#include "core/physics/world.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <compare>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace spacetow {

/// Penetration that is left alone so that resting contacts persist, m.
constexpr double linearSlop = 0.0004;

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

    /// No point of the body goes further in this iteration, m; turning moves no point by more than the diameter.
    double reach() const {
        return std::sqrt(shift.squaredNorm()) + (round ? 0 : std::min(std::abs(turn), 2.0) * outerRadius);
    }
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
    Aabb bounds;                   // of the last broad phase
    Aabb solid;                    // the exact box of a static body when the static tree was made
    std::uint32_t firstStatic = 0; // of its parts in StaticGeometry
};

/// The parts of all static bodies in world coordinates; immutable, shared between copies of a world.
struct StaticGeometry {
    struct Collider {
        Slot body;
        std::uint32_t part;
        Part shape;
        Aabb bounds;   // of what is solid; the tree's boxes of edges are larger
        WallSide side; // of an edge
        int back = -1; // index in `backs`
    };
    struct Back {
        std::uint32_t collider;
        WallBack region;
    };
    std::vector<Collider> colliders;
    std::vector<Back> backs; // of edges that have none: solid however deep
    Aabb area;               // within which the tree knows of them
    StaticQuadtree tree;
};

struct ContactPoint {
    std::uint32_t feature = 0;
    bool fresh = true;        // touched for the first time: what stopped an impact is not carried on
    double normalImpulse = 0; // N s, of the last iteration
};

/// By what the parts of a pair are, how their contact is found: `Round` circles stand about their centre of mass.
enum class PairKind : std::uint8_t { Felt, RoundRound, RoundEdge, RoundStatic, General };

/// Two parts that may meet during this update. `bodyA` moves; it has the lower slot when both do.
struct Pair {
    static constexpr std::uint32_t none = 0xffffffffu;

    Slot bodyA = 0, bodyB = 0;
    std::uint32_t partA = 0, partB = 0;
    const Part* shapeA = nullptr; // about the centre of mass
    const Part* shapeB = nullptr; // likewise, or in world coordinates for a static body
    PairKind kind = PairKind::General;
    bool staticB = false;
    bool alone = false;           // no other part of the same body, nor another static body, can share a plane with it
    bool sweep = false;           // the parts are to be stopped where they meet, to bounce from there
    std::uint32_t collider = 0;   // index in StaticGeometry, of a static part
    std::uint32_t contact = none; // index of what is known of their contact

    std::uint64_t bodies() const { return std::uint64_t{bodyA} << 32 | bodyB; }
    std::uint64_t parts() const { return std::uint64_t{partA} << 32 | partB; }
    bool operator<(const Pair& o) const { return bodies() != o.bodies() ? bodies() < o.bodies() : parts() < o.parts(); }
};

/// Tells without a look at the pair that it cannot be in contact yet: not before its bodies have travelled this far
/// together.
struct PairGate {
    std::uint32_t moverA = 0, moverB = 0; // indices into WorldData::travelled
    double apartUntil = 0;                // m
};

struct TouchMarks {
    bool now = false;
    bool reported = false; // as events
};

/// A manifold that is kept while its parts move little against each other, in their own coordinates.
struct KeptManifold {
    double holdsUntil = 0; // m that the bodies may have travelled together before it is looked at again
    double room = -1;      // m that the parts may come closer before it is out of date; negative: nothing is known
    Transform relative;    // of A in the coordinates of B when it was made
    bool normalOfA = false;
    Vec2 normal{0, 1}; // in the coordinates of A or B
    struct Point {
        Vec2 onA{0, 0}, onB{0, 0}; // in the coordinates of A and B
        double leverA = 0, leverB = 0;
        double tangentLeverA = 0, tangentLeverB = 0;
        double normalMass = 0;
    };
    std::array<Point, 2> points;
    double coupling = 0; // of the two points: the off-diagonal element of their inverse mass matrix
};

/// What the last iteration left of a pair's contact.
struct Contact {
    std::int32_t count = 0;               // of points
    std::uint32_t manifold = 0xffffffffu; // index of the kept one, of general pairs
    double friction = 0;
    double restitution = 0;
    double tangentImpulse = 0; // N s, of the last iteration
    std::array<ContactPoint, 2> points;
};

/// The pairs and what belongs to each, by the same index; sorted by bodies and parts.
struct PairTable {
    std::vector<PairGate> gates;
    std::vector<TouchMarks> marks;
    std::vector<Pair> pairs;

    std::size_t size() const { return pairs.size(); }
    void clear();
    void add(const Pair& pair);
    void addFrom(const PairTable& other, std::size_t index);
};

/// A part of a moving body with the box it cannot leave unnoticed.
struct MovingCollider {
    Slot body;
    std::uint32_t part;
    Aabb box;
};

/// A contact of one point in line with the centres of mass, so that its normal impulse turns nothing. The rest of it is
/// in a batch.
struct RoundContact {
    Slot a = 0, b = 0;
    std::uint32_t pair = 0, contact = 0;
    Lane lane;
    bool bounces = false;
    double separation = 0;
};

struct ConstraintPoint {
    double leverA, leverB; // cross products of the arms with the normal, m
    double normalMass;     // 0 when no push along the normal can move anything
    double separation;
    double target; // m/s: the normal velocity is to be at least this
    double normalImpulse;
    Vec2 armA; // from the centre of mass to the contact point
    double tangentLeverA, tangentLeverB;
    std::uint32_t pair, contact, index; // where its impulse is kept
    bool bounces;
};

/// Any other contact, for one iteration. Friction acts once for both points, as the velocity along a plane is the same
/// at all of its points. Made by the thousand, it starts out with a second point that does nothing and nothing else.
struct Constraint {
    Slot a, b;
    int count = 0;
    bool alone;
    Lane lane;   // of its batch
    Vec2 normal; // from a to b
    double friction;
    double restitution;
    double tangentLeverA, tangentLeverB;
    double tangentMass;
    double tangentImpulse;
    double coupling; // off-diagonal element of the two points' inverse mass matrix
    std::array<ConstraintPoint, 2> points;

    Constraint() {
        points[0].bounces = alone = false;
        silenceSecond();
    }
    void silenceSecond() {
        ConstraintPoint& second = points[1];
        second.leverA = second.leverB = second.normalMass = second.normalImpulse = second.separation = 0;
        second.bounces = false;
    }
};

struct ConnectorRecord {
    std::uint32_t generation = 0;
    bool used = false;
    std::uint64_t serial = 0; // order of creation, of bodies and connectors alike
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

struct FieldRecord {
    std::uint32_t generation = 0;
    std::shared_ptr<const ForceFieldDef> def; // none: not used
};

struct PendingChange {
    enum class Kind : std::uint8_t { Remove, Active, Tangible, Frozen } kind;
    BodyId body;
    bool first = false, second = false;
};

/// What the impulses of an iteration do to the energy of bodies, J: three sums over their motions to the sides, up and
/// around; see energy_limit.cpp.
struct EnergyChange {
    Wide a{}, b{}, c{};
};

/// The change with a share x of the impulses: a·x²/2 + b·x + c. `pushes` is the work of pushes out of overlaps.
struct EnergyBalance {
    double a = 0, b = 0, c = 0, pushes = 0;

    double gain() const { return 0.5 * a + b + c; }
};

/// Bodies that may push each other, directly or through others.
struct Islands {
    /// A body that nothing can move, next to an island, by the root of that.
    struct Driver {
        Slot slot = 0, pushed = 0;
        auto operator<=>(const Driver&) const = default;
    };
    std::vector<Slot> roots; // by slot: the lowest of its island
    std::vector<Driver> drivers;

    // Working memory.
    std::vector<Slot> all;               // roots of the bodies that move
    std::vector<Pace> inertias;          // by slot: mass, mass and inertia
    std::vector<EnergyChange> changes;   // by slot, of roots
    std::vector<EnergyBalance> balances; // likewise
    ContactBatches batches;              // of islands that are solved again
    std::vector<Lane> lanes;             // of their contacts there
    std::vector<std::uint8_t> held;      // by slot: bodies that are held back
};

using SlotPair = std::pair<Slot, Slot>; // lower first

/// Who sleeps, and what is kept for them. Empty while nobody does.
struct Sleep {
    bool allowed = false;
    Vec2 gravity{0, 0};               // under which they fell asleep
    std::vector<Slot> sleepers;       // sorted
    std::vector<Slot> disturbed;      // since the last update
    PairTable table;                  // pairs of sleepers, with each other and with static bodies
    std::vector<TagMask> touchedTags; // by slot, of those pairs

    // Working memory.
    PairTable newTable;
    std::vector<Slot> parents;        // by slot: islands as trees
    std::vector<std::uint8_t> marked; // by slot
};

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

    std::vector<FieldRecord> fields;
    std::vector<std::uint32_t> freeFields;
    std::vector<Slot> fieldBodies; // that feel any of them

    std::vector<PendingChange> pending;
    std::shared_ptr<const StaticGeometry> statics;
    bool staticsChanged = true;
    bool bodiesChanged = true; // so that lists and pairs are to be made anew
    bool pairsStale = true;    // so that nothing that is known of the pairs' distances holds

    PairTable table;
    std::vector<Contact> contacts; // of the pairs that have come near each other
    std::vector<std::uint32_t> freeContacts;
    std::vector<KeptManifold> manifolds; // of the general ones
    std::vector<std::uint32_t> freeManifolds;
    std::vector<TagMask> touchedTags; // by slot, of the last iteration
    Events events;
    std::vector<RemovedEvent> removedBefore; // since the last update

    Sleep sleep;

    MovingQuadtree tree;
    std::vector<Slot> moving;              // active and awake, kinematic bodies first
    std::vector<Slot> reporters;           // of touched tags
    std::vector<MovingCollider> colliders; // of `moving` and the sleepers
    std::vector<double> travelled;         // m, at most, at the end of the iteration: 0, then by slot

    // Working memory, kept so that a steady update allocates nothing.
    PairTable newTable;
    std::vector<Pair> newPairs, sortedPairs;
    std::vector<std::uint32_t> pairEnds; // by slot, of the sorted pairs
    std::vector<std::uint32_t> found;
    std::vector<std::uint32_t> felt; // indices of felt pairs
    std::vector<RoundContact> roundContacts;
    std::vector<Constraint> constraints;
    std::vector<std::array<double, 3>> wholeImpulses; // by contact, while an iteration is made in parts
    ContactBatches batches;
    Islands islands;
    std::vector<std::uint64_t> droppedTouches; // body pairs whose boxes parted while they touched
    std::vector<Transform> trial;              // poses during sub-steps, by slot
    bool anyFault = false;                     // something is not finite
    bool anyEscaped = false;
    bool anyFast = false; // something moves further than anticipation covers
    bool anySweep = false;
    bool anyDiverted = false;

    /// Whether the parts of the pair may meet in this iteration.
    bool isGateOpen(std::uint32_t pair) const {
        const PairGate& gate = table.gates[pair];
        return travelled[gate.moverA] + travelled[gate.moverB] + linearSlop >= gate.apartUntil;
    }
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

} // namespace spacetow
