#pragma once
// Pairs of parts, what is kept of their contacts, and contacts as the solver gets them. SI units, radians.

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

/// By what the parts of a pair are, how their contact is found: circles here stand about their centres of mass.
enum class PairKind : std::uint8_t { Sensor, CircleCircle, CircleEdge, CircleStatic, General };

/// Two parts that may meet during this update. `bodyA` moves; it has the lower slot when both do.
struct Pair {
    static constexpr std::uint32_t none = 0xffffffffu;

    Slot bodyA = 0, bodyB = 0;
    std::uint32_t partA = 0, partB = 0;
    const Part* shapeA = nullptr; // about the centre of mass
    const Part* shapeB = nullptr; // likewise, or in world coordinates for a static body
    PairKind kind = PairKind::General;
    bool staticB = false;
    bool unmergeable = false;     // no other part of the same body, nor another static body, can share a plane with it
    bool sweep = false;           // the parts are to be stopped where they meet, to bounce from there
    std::uint32_t collider = 0;   // of a static part, see WorldData
    std::uint32_t contact = none; // index of what is known of their contact

    std::uint64_t bodies() const { return std::uint64_t{bodyA} << 32 | bodyB; }
    std::uint64_t parts() const { return std::uint64_t{partA} << 32 | partB; }
    bool operator<(const Pair& o) const { return bodies() != o.bodies() ? bodies() < o.bodies() : parts() < o.parts(); }
};

/// Tells without reading the pair that it cannot be in contact yet: not before the motion bounds of its bodies add up
/// to the separation bound.
struct PairBound {
    Mover moverA = Mover::Static, moverB = Mover::Static;
    double separationBound = 0; // m

    // While the contact of the pair has a lane, alone or merged with others, the pair itself is not updated.
    static constexpr double never = std::numeric_limits<double>::infinity();
    void exclude() { separationBound = never; }
    /// The pair is to be updated: nothing is known of its separation.
    void reset() { separationBound = 0; }
};

/// Of a pair that nothing is known of.
PairBound unknownBound(const Pair& pair);

struct PairFlags {
    Passage passage = Passage::None; // through a one-way wall, when the pair was last updated
    bool touching = false;
    bool passed = false;   // by a sensor within this iteration, without touching it at the end
    bool reported = false; // as events, at the end of the last iteration
    bool inSolver = false; // its contact has a lane; until that is closed the pair is excluded from updates
    bool limitsFraction =
        false; // the speculative margin may cover but a part of its motion; holds while pairs are not stale
};

/// A manifold that is kept while its parts move little against each other, in their own coordinates.
struct KeptManifold {
    double tolerance = -1; // m that the parts may come closer before it is out of date; negative: nothing is known
    Transform relative;    // of A in the coordinates of B when it was made
    bool normalOnA = false;
    Vec2 normal{0, 1}; // in the coordinates of A or B
    struct Point {
        Vec2 onA{0, 0}, onB{0, 0}; // in the coordinates of A and B
    };
    std::array<Point, 2> points;
};

/// What a pair's contact is from one update to the next: its points, their impulses while the solver does not have it,
/// and its manifold.
struct Contact {
    std::int32_t count = 0;            // of points
    std::uint32_t constraintIndex = 0; // index among the contacts that the solver has, while it has it
    double friction = 0;
    double restitution = 0;
    double tangentImpulse = 0; // N s, of the last iteration
    std::array<ContactPoint, 2> points;
    KeptManifold manifold; // of general pairs; the others are compared anew in each iteration
};

/// The pairs and what belongs to each, by the same index; sorted by bodies and parts.
struct PairTable {
    std::vector<PairBound> bounds;
    std::vector<PairFlags> flags;
    std::vector<Pair> pairs;

    std::size_t size() const { return pairs.size(); }
    std::size_t capacity() const { return pairs.capacity(); }
    void clear();
    void add(const Pair& pair);
    void addFrom(const PairTable& other, std::size_t index);
};

/// A contact of one point in line with the centres of mass, so that its normal impulse turns nothing. The rest of it is
/// in a batch.
struct CircleContact {
    Slot a = 0, b = 0;
    std::uint32_t pair = 0, contact = 0;
    Lane lane;
    bool scalarUpdate = false; // not by the kernel: b is static, or they bounce
    bool bounces = false;      // in this iteration
};

/// Any other contact; likewise.
struct GeneralContact {
    struct Point {
        std::uint32_t pair, contact, index; // where its impulse is kept
        bool bounces;
    };
    Slot a = 0, b = 0;
    Lane lane;
    std::uint32_t count = 0;        // of points
    bool singular = false;          // one of its points acts for both
    bool mergeable = false;         // something else may share a plane with it
    bool merged = false;            // stands for several pairs, which `mergedPairs` has
    bool bounces = false;           // at any point in this iteration
    std::array<bool, 2> touching{}; // the points of a merged one
    std::array<Point, 2> points{};
};

/// The index of the pair that a constraint belongs to.
inline std::uint32_t pairOf(const CircleContact& c) {
    return c.pair;
}
inline std::uint32_t pairOf(const GeneralContact& c) {
    return c.points[0].pair;
}

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

/// A general contact before it gets its lane. Friction acts once for both points, as the velocity along a plane is the
/// same at all of its points. Made by the thousand, it starts out with a second point that does nothing and nothing
/// else.
struct Constraint {
    Slot a, b;
    int count = 0;
    bool unmergeable;
    bool merged; // stands for several
    Vec2 normal; // from a to b
    double friction;
    double restitution;
    double tangentLeverA, tangentLeverB;
    double tangentMass;
    double tangentImpulse;
    double coupling;  // off-diagonal element of the two points' inverse mass matrix
    double tolerance; // of merged ones: m that the parts may come closer before a manifold is out of date
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
