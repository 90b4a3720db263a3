#pragma once
// The arrays behind a world, as the stages of the update see them. Body slots are used again after a removal; slot
// order is the same for equal histories, so it may decide the order of work. SI units, radians.

#include "core/geometry/moving_quadtree.h"
#include "core/geometry/part.h"
#include "core/geometry/static_quadtree.h"
#include "core/geometry/wall_back.h"
#include "core/geometry/wall_side.h"
#include "core/math/aabb.h"
#include "core/physics/contact_data.h"
#include "core/physics/island_data.h"
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

/// A part of a moving body.
struct MovingCollider {
    Slot body;
    std::uint32_t part;
    bool slender = false; // its box is mostly empty
    bool escaped = false; // its body has, and is looking for pairs
    bool astray = false;  // not where the tree has it
};

/// What the broad phase finds of a pair; sorted as pairs are.
struct FoundPair {
    Slot bodyA = 0, bodyB = 0;
    std::uint32_t partA = 0, partB = 0;

    FoundPair() = default;
    FoundPair(Slot a, Slot b, std::uint32_t ofA, std::uint32_t ofB) : bodyA(a), bodyB(b), partA(ofA), partB(ofB) {}
    explicit FoundPair(const Pair& pair) : FoundPair(pair.bodyA, pair.bodyB, pair.partA, pair.partB) {}
    std::uint64_t bodies() const { return std::uint64_t{bodyA} << 32 | bodyB; }
    std::uint64_t parts() const { return std::uint64_t{partA} << 32 | partB; }
    bool operator<(const FoundPair& o) const {
        return bodies() != o.bodies() ? bodies() < o.bodies() : parts() < o.parts();
    }
};

/// Elements of a table that stay together when it changes.
struct Stretch {
    std::uint32_t begin = 0, end = 0; // in the table as it was
    std::uint32_t to = 0;             // where they begin in the table as it becomes
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

/// A pair that may have to be stopped where it meets; see continuous.h.
struct OnWay {
    std::uint32_t pair = 0;
    Slot bodyA = 0, bodyB = 0;
    std::uint32_t lookedAt = 0; // 0: not yet
    bool touches = false;       // then only its turns are limited
    bool stopsA = false, stopsB = false;
};

struct WorldData {
    UpdateParameters parameters;

    // Bodies, by slot.
    std::vector<BodyMotion> motions;
    std::vector<BodyStep> steps;
    std::vector<BodyRecord> records;
    std::vector<Slot> freeSlots;
    std::uint64_t nextSerial = 0;

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
    std::vector<RoundContact> roundContacts; // that the solver has, see contact_lanes.h
    std::vector<GeneralContact> generalContacts;
    ContactBatches batches;
    bool contactsListed = false;                 // so that the above are those of the pairs
    bool anySingle = false, anySingular = false; // of these contacts
    bool anyBounce = false;
    std::vector<std::uint16_t> wallContacts; // by slot: general contacts with what others may share a plane with
    std::vector<std::pair<std::uint32_t, std::uint32_t>> neighbours; // contacts that may come to lie in one plane
    std::vector<std::uint32_t> absorbed;                             // pairs that merged contacts stand for
    bool mergeDoubt = false;                                         // whether these may have changed
    bool justListed = false;                                         // all contacts, in this iteration
    std::size_t listChanges = 0;                                     // since all were listed
    std::vector<TagMask> touchedTags;                                // by slot, of the last iteration
    Events events;

    Sleep sleep;

    MovingQuadtree tree;
    std::vector<Slot> moving;              // active and awake, kinematic bodies first
    std::vector<Slot> reporters;           // of touched tags
    std::vector<MovingCollider> colliders; // of `moving` and the sleepers
    std::vector<double> travelled;         // m, at most, at the end of the iteration: 0, then by slot
    std::vector<BodyWay> ways;             // nothing, then by slot
    std::vector<BodyReach> reaches;        // nothing, then by slot
    std::vector<std::uint8_t> alert;       // whether a body's way is to be looked at: 0, then by slot

    // Working memory, kept so that a steady update allocates nothing.
    PairTable newTable;
    std::vector<Pair> newPairs;
    std::vector<std::uint32_t> pairEnds; // by slot, of the sorted pairs
    std::vector<std::uint32_t> found;
    std::vector<std::uint32_t> felt;                  // indices of felt pairs
    std::vector<std::uint32_t> open;                  // indices of pairs to be looked at
    std::vector<Constraint> constraints;              // general contacts that are not yet listed
    std::vector<std::array<double, 3>> wholeImpulses; // by contact, while an iteration is made in parts
    Islands islands;
    std::vector<std::uint64_t> droppedTouches; // body pairs whose boxes parted while they touched
    std::vector<Transform> trial;              // poses during sub-steps, by slot
    bool anyFault = false;                     // something is not finite
    bool anyEscaped = false;
    bool anyFast = false; // something moves further than anticipation covers
    bool anySweep = false;
    bool anyDiverted = false;
    bool islandsStale = true;                     // the pairs or who moves have changed
    std::vector<std::uint8_t> yields;             // 0, then by slot: whether anything can move or turn it
    std::vector<Aabb> boxes;                      // that colliders cannot leave unnoticed
    std::vector<std::uint32_t> firstColliders;    // by slot
    std::vector<std::uint32_t> astray;            // colliders that are not where the tree has them
    std::vector<Slot> escaped;                    // whose pairs are found anew
    std::vector<MovingQuadtree::Two> overlapping; // colliders whose boxes do
    std::vector<FoundPair> foundPairs, sortedPairs;
    std::vector<std::uint8_t> leaves;     // 0, then by slot: whether a body has escaped, while pairs are merged
    std::vector<std::uint32_t> leaving;   // pairs of those who have
    std::vector<std::uint32_t> dropped;   // of those, which were not found again
    std::vector<std::uint32_t> newPlaces; // of new pairs: the index before which they belong
    std::vector<Stretch> stretches;       // of the table that remain
    std::vector<OnWay> onWays;
    std::vector<std::uint32_t> shortenedAt; // by slot: the look at a pair that did so
    std::uint32_t looks = 0;                // at pairs on their ways

    /// Whether the parts of the pair may meet in this iteration.
    bool isGateOpen(std::uint32_t pair) const {
        const PairGate& gate = table.gates[pair];
        return travelled[gate.moverA] + travelled[gate.moverB] + linearSlop >= gate.apartUntil;
    }
    /// What the bodies of the pair have travelled together before the iteration, m.
    double milesOf(const PairGate& gate) const {
        return reaches[gate.moverA].travelled + reaches[gate.moverB].travelled;
    }
    /// To be called when the motion of the body has been planned, or it no longer moves.
    void noteWay(Slot slot) {
        ways[slot + 1] = {motions[slot], steps[slot]};
        reaches[slot + 1] = {steps[slot].travelled, steps[slot].outerRadius};
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
