#pragma once
// Pairs of parts, their persistent contacts, and the constraints of the solver. SI units, radians.

#include "core/geometry/part.h"
#include "core/geometry/passage.h"
#include "core/math/transform.h"
#include "core/physics/lanes/contact_batches.h"
#include "core/physics/state/mover.h"

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

namespace spacetow {

struct ContactPoint {
    std::uint32_t feature = 0;
    double normalImpulse = 0; // N s, of the last iteration
};

/// Selects the collision function of a pair. `Circle` is a circle about the centre of mass of its body.
enum class PairKind : std::uint8_t { Sensor, CircleCircle, CircleEdge, CircleStatic, General };

/// The bodies and parts of a pair. Pairs are ordered by bodies, then by parts.
struct PairKey {
    Slot bodyA = 0, bodyB = 0;
    std::uint32_t partA = 0, partB = 0;

    std::uint64_t bodies() const { return std::uint64_t{bodyA} << 32 | bodyB; }
    std::uint64_t parts() const { return std::uint64_t{partA} << 32 | partB; }
    bool operator<(const PairKey& o) const {
        return bodies() != o.bodies() ? bodies() < o.bodies() : parts() < o.parts();
    }
};

/// Two parts whose fat AABBs overlap. `bodyA` is not static; if neither body is static, `bodyA` has the lower slot.
struct Pair {
    static constexpr std::uint32_t none = 0xffffffffu;

    Slot bodyA = 0, bodyB = 0;
    std::uint32_t partA = 0, partB = 0;
    const Part* shapeA = nullptr; // about the centre of mass
    const Part* shapeB = nullptr; // likewise, or in world coordinates for a static body
    PairKind kind = PairKind::General;
    bool staticB = false;
    bool unmergeable = false;     // its contact can lie in one plane with no other contact
    bool sweep = false;           // the time of impact stops the parts where they meet; they bounce from there
    std::uint32_t collider = 0;   // of a static part: its index, see BroadPhase::staticCollider
    std::uint32_t contact = none; // index in Contacts::pool

    PairKey key() const { return {bodyA, bodyB, partA, partB}; }
};

/// Until the motion bounds of the two bodies add up to the separation bound, the parts of the pair cannot touch. The
/// test reads neither the pair nor its parts.
struct PairBound {
    Mover moverA = Mover::Static, moverB = Mover::Static;
    double separationBound = 0; // m

    // The bound of a pair whose contact, alone or merged with others, has a lane: the narrow phase skips the pair.
    static constexpr double never = std::numeric_limits<double>::infinity();
    void exclude() { separationBound = never; }
    /// The narrow phase updates the pair in every iteration until it sets a bound.
    void reset() { separationBound = 0; }
};

/// The bound of a pair that the narrow phase has not updated yet.
PairBound unknownBound(const Pair& pair);

struct PairFlags {
    Passage passage =
        Passage::None; // of one body through the one-way wall of the other, as of the last update of the pair
    bool touching = false;
    bool passed = false;         // of a sensor pair: the parts overlapped within the iteration, but not at its end
    bool reported = false;       // it touched at the last report of touch events
    bool inSolver = false;       // the contact has a lane; until the lane is closed, the narrow phase skips the pair
    bool limitsFraction = false; // the pair may need an iteration in parts, see safeFraction()
};

/// A manifold in the local coordinates of its bodies. It is kept while the relative pose of its parts stays within the
/// manifold tolerance.
struct KeptManifold {
    double tolerance = -1; // manifold tolerance, m: relative motion that outdates it; negative: it is out of date
    Transform relative;    // pose of a relative to b when the manifold was made
    bool normalOnA = false;
    Vec2 normal{0, 1}; // unit, from a to b, in local coordinates: of a if `normalOnA`, else of b
    struct Point {
        Vec2 onA{0, 0}, onB{0, 0}; // anchors, in local coordinates of a and of b
    };
    std::array<Point, 2> points;
};

/// The persistent contact of a pair: manifold, mixed material and impulses. While the contact has a lane, its impulses
/// are in the lane.
struct Contact {
    std::int32_t count = 0;            // of points
    std::uint32_t constraintIndex = 0; // while it has a lane: index in Constraints::circleContacts or generalContacts
    double friction = 0;
    double restitution = 0;
    double tangentImpulse = 0; // N s, of the last iteration
    std::array<ContactPoint, 2> points;
    KeptManifold manifold; // of general pairs only; those of circles are computed in every iteration
};

/// The pair table: parallel arrays, sorted by bodies and parts.
struct PairTable {
    std::vector<PairBound> bounds;
    std::vector<PairFlags> flags;
    std::vector<Pair> pairs;

    std::size_t size() const { return pairs.size(); }
    std::size_t capacity() const { return pairs.capacity(); }
    void clear();
    void add(const Pair& pair);
    void addFrom(const PairTable& other, std::size_t index);
    /// The index of the first pair whose PairKey::bodies() is at least `bodies`.
    std::size_t firstFrom(std::uint64_t bodies) const;
};

/// A circle contact with a lane: one point in line with the centres of mass, so that the normal impulse turns neither
/// body. Solver data is in the lane.
struct CircleContact {
    Slot a = 0, b = 0;
    std::uint32_t pair = 0, contact = 0;
    Lane lane;
    bool scalarUpdate = false; // the narrow phase updates it, not the kernel: b is static, or there is restitution
    bool bounces = false;      // in this iteration
};

/// Any other contact with a lane.
struct GeneralContact {
    struct Point {
        std::uint32_t pair, contact, index; // pair, contact in the pool, and point of that contact
        bool bounces;                       // restitution acts in this iteration
    };
    Slot a = 0, b = 0;
    Lane lane;
    std::uint32_t count = 0;        // of points
    bool singular = false;          // its 2 × 2 system is singular: one point acts for both
    bool mergeable = false;         // another contact may lie in one plane with it
    bool merged = false;            // it replaces the contacts of several pairs, see Constraints::mergedPairs
    bool bounces = false;           // restitution acts at a point in this iteration
    std::array<bool, 2> touching{}; // by point, of a merged contact
    std::array<Point, 2> points{};
};

/// The index of the pair of a contact with a lane; of a merged one, that of its first point.
inline std::uint32_t pairOf(const CircleContact& c) {
    return c.pair;
}
inline std::uint32_t pairOf(const GeneralContact& c) {
    return c.points[0].pair;
}

struct ConstraintPoint {
    double leverA, leverB; // cross products of the arms with the normal, m
    double normalMass;     // kg; 0 if an impulse along the normal moves neither body
    double separation;     // m, negative when the surfaces overlap
    double target;         // m/s: the least normal velocity
    double normalImpulse;  // N s
    Vec2 armA;             // from the centre of mass to the contact point
    double tangentLeverA, tangentLeverB;
    std::uint32_t pair, contact, index; // as in GeneralContact::Point
    bool bounces;                       // likewise
};

/// A general contact before it gets its lane. One row of friction serves both points, as all points of a plane have the
/// same velocity along the plane. The constructor sets as little as it can, as constraints are made by the thousand:
/// the flags, and a second point that does not act.
struct Constraint {
    Slot a, b;
    int count = 0;
    bool unmergeable;
    bool merged; // it replaces several contacts
    Vec2 normal; // from a to b
    double friction;
    double restitution;
    double tangentLeverA, tangentLeverB;
    double tangentMass;
    double tangentImpulse;
    double coupling;  // 1/kg: off-diagonal element of the inverse mass matrix of the two points
    double tolerance; // m, of merged contacts: the least manifold tolerance left
    std::array<ConstraintPoint, 2> points;

    Constraint() {
        points[0].bounces = unmergeable = merged = false;
        clearSecond();
    }
    void clearSecond() {
        ConstraintPoint& second = points[1];
        second.leverA = second.leverB = second.normalMass = second.normalImpulse = second.separation = 0;
        second.bounces = false;
    }
};

} // namespace spacetow
