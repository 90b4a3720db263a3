#include "core/physics/contact_batches.h"

#include <algorithm>
#include <cstring>
#include <limits>

// Everything in this file is inlined into functions for processors with and without wide registers. Both compute the
// same bits: the operations are the same, and none is fused.
#define SPACETOW_INLINE inline __attribute__((always_inline))

namespace spacetow {

namespace {

SPACETOW_INLINE Wide greater(Wide a, Wide b) {
    return a > b ? a : b;
}

SPACETOW_INLINE Wide lesser(Wide a, Wide b) {
    return a < b ? a : b;
}

struct WidePace {
    Wide x, y, turn, unused;
};

// A body comes again in the next batch but one, so that the processor need not wait for the result of the last.
constexpr std::uint32_t pause = 2;

/// Rows to columns and back.
SPACETOW_INLINE WidePace transposed(Wide r0, Wide r1, Wide r2, Wide r3) {
    const Wide low02 = __builtin_shufflevector(r0, r1, 0, 4, 2, 6);
    const Wide low13 = __builtin_shufflevector(r0, r1, 1, 5, 3, 7);
    const Wide high02 = __builtin_shufflevector(r2, r3, 0, 4, 2, 6);
    const Wide high13 = __builtin_shufflevector(r2, r3, 1, 5, 3, 7);
    return {__builtin_shufflevector(low02, high02, 0, 1, 4, 5), __builtin_shufflevector(low13, high13, 0, 1, 4, 5),
            __builtin_shufflevector(low02, high02, 2, 3, 6, 7), __builtin_shufflevector(low13, high13, 2, 3, 6, 7)};
}

SPACETOW_INLINE Wide row(const Pace& pace) {
    Wide result;
    std::memcpy(&result, &pace, sizeof result);
    return result;
}

SPACETOW_INLINE WidePace load(const Pace* paces, const std::array<Slot, 4>& slots) {
    return transposed(row(paces[slots[0]]), row(paces[slots[1]]), row(paces[slots[2]]), row(paces[slots[3]]));
}

SPACETOW_INLINE void store(Pace* paces, const std::array<Slot, 4>& slots, const WidePace& pace) {
    const WidePace rows = transposed(pace.x, pace.y, pace.turn, pace.unused);
    std::memcpy(static_cast<void*>(&paces[slots[0]]), &rows.x, sizeof(Wide));
    std::memcpy(static_cast<void*>(&paces[slots[1]]), &rows.y, sizeof(Wide));
    std::memcpy(static_cast<void*>(&paces[slots[2]]), &rows.turn, sizeof(Wide));
    std::memcpy(static_cast<void*>(&paces[slots[3]]), &rows.unused, sizeof(Wide));
}

/// The bodies of a batch's contacts.
struct Ends {
    WidePace a, b;

    SPACETOW_INLINE Wide along(Wide x, Wide y) const { return (b.x - a.x) * x + (b.y - a.y) * y; }
    SPACETOW_INLINE Wide turning(Wide leverA, Wide leverB) const { return b.turn * leverB - a.turn * leverA; }
    /// An impulse (x, y) on b and its opposite on a, which twist them by these angular impulses.
    template <class Batch>
    SPACETOW_INLINE void apply(const Batch& c, Wide x, Wide y, Wide twistA, Wide twistB) {
        push(c, x, y);
        a.turn -= c.inertiaA * twistA;
        b.turn += c.inertiaB * twistB;
    }
    template <class Batch>
    SPACETOW_INLINE void push(const Batch& c, Wide x, Wide y) {
        a.x -= c.massA * x;
        a.y -= c.massA * y;
        b.x += c.massB * x;
        b.y += c.massB * y;
    }
};

SPACETOW_INLINE void warm(Ends& ends, const RoundBatch& c) {
    const Wide x = c.normalImpulse * c.normalX - c.tangentImpulse * c.normalY;
    const Wide y = c.normalImpulse * c.normalY + c.tangentImpulse * c.normalX;
    ends.apply(c, x, y, c.tangentImpulse * c.leverA, c.tangentImpulse * c.leverB);
}

SPACETOW_INLINE void warm(Ends& ends, const ConstraintBatch& c) {
    const Wide normal = c.impulse1 + c.impulse2;
    const Wide x = normal * c.normalX - c.tangentImpulse * c.normalY;
    const Wide y = normal * c.normalY + c.tangentImpulse * c.normalX;
    ends.apply(c, x, y, c.impulse1 * c.leverA1 + c.impulse2 * c.leverA2 + c.tangentImpulse * c.tangentLeverA,
               c.impulse1 * c.leverB1 + c.impulse2 * c.leverB2 + c.tangentImpulse * c.tangentLeverB);
}

SPACETOW_INLINE bool any(Mask mask) {
    return (mask[0] | mask[1] | mask[2] | mask[3]) != 0;
}

/// Friction: what it takes to stop the sliding along the tangent (−y, x) of the normal, as far as `limit` reaches.
template <class Batch>
SPACETOW_INLINE Wide friction(const Ends& ends, const Batch& c, Wide leverA, Wide leverB, Wide limit) {
    const Wide sliding = ends.along(-c.normalY, c.normalX) + ends.turning(leverA, leverB);
    return lesser(greater(c.tangentImpulse - c.tangentMass * sliding, -limit), limit);
}

template <class Batch>
SPACETOW_INLINE void rub(Ends& ends, Batch& c, Wide leverA, Wide leverB, Wide impulse) {
    const Wide change = impulse - c.tangentImpulse;
    c.tangentImpulse = impulse;
    ends.apply(c, -change * c.normalY, change * c.normalX, change * leverA, change * leverB);
}

SPACETOW_INLINE Wide normalOf(const RoundBatch& c) {
    return c.normalImpulse;
}
SPACETOW_INLINE Wide normalOf(const ConstraintBatch& c) {
    return c.impulse1 + c.impulse2;
}
SPACETOW_INLINE void solveFriction(Ends& ends, RoundBatch& c) {
    rub(ends, c, c.leverA, c.leverB, friction(ends, c, c.leverA, c.leverB, c.friction * normalOf(c)));
}
SPACETOW_INLINE void solveFriction(Ends& ends, ConstraintBatch& c) {
    rub(ends, c, c.tangentLeverA, c.tangentLeverB,
        friction(ends, c, c.tangentLeverA, c.tangentLeverB, c.friction * normalOf(c)));
}
SPACETOW_INLINE void solveFriction(Ends& ends, RoundBatch& c, Mask which) {
    const Wide impulse = friction(ends, c, c.leverA, c.leverB, c.friction * normalOf(c));
    rub(ends, c, c.leverA, c.leverB, which ? impulse : c.tangentImpulse);
}
SPACETOW_INLINE void solveFriction(Ends& ends, ConstraintBatch& c, Mask which) {
    const Wide impulse = friction(ends, c, c.tangentLeverA, c.tangentLeverB, c.friction * normalOf(c));
    rub(ends, c, c.tangentLeverA, c.tangentLeverB, which ? impulse : c.tangentImpulse);
}

SPACETOW_INLINE void solveNormals(Ends& ends, RoundBatch& c) {
    const Wide excess = ends.along(c.normalX, c.normalY) - c.target;
    const Wide impulse = greater(c.normalImpulse - c.normalMass * excess, Wide{});
    const Wide change = impulse - c.normalImpulse;
    c.normalImpulse = impulse;
    ends.push(c, change * c.normalX, change * c.normalY);
}

/// The impulses x ≥ 0 with K x + b ≥ 0 and x·(K x + b) = 0, found by trying which of them act. The order of the
/// points does not matter, so that mirrored scenes stay mirrored.
SPACETOW_INLINE void complementary(const ConstraintBatch& c, Wide b1, Wide b2, Wide& x1, Wide& x2) {
    const Wide none{};
    x1 = (c.coupling * b2 - c.k22 * b1) * c.inverseDeterminant;
    x2 = (c.coupling * b1 - c.k11 * b2) * c.inverseDeterminant;
    const auto both = (x1 >= none) & (x2 >= none);
    const Wide only1 = -b1 * c.mass1;
    const auto first = (only1 >= none) & (c.coupling * only1 + b2 >= none);
    const Wide only2 = -b2 * c.mass2;
    const auto second = (only2 >= none) & (c.coupling * only2 + b1 >= none);
    x1 = both ? x1 : (first ? only1 : none);
    x2 = both ? x2 : (first ? none : (second ? only2 : none));
}

SPACETOW_INLINE void solveNormals(Ends& ends, ConstraintBatch& c) {
    const Wide closing = ends.along(c.normalX, c.normalY);
    const Wide b1 =
        closing + ends.turning(c.leverA1, c.leverB1) - c.target1 - (c.k11 * c.impulse1 + c.coupling * c.impulse2);
    const Wide b2 =
        closing + ends.turning(c.leverA2, c.leverB2) - c.target2 - (c.coupling * c.impulse1 + c.k22 * c.impulse2);
    Wide x1;
    Wide x2;
    complementary(c, b1, b2, x1, x2);
    const Wide d1 = x1 - c.impulse1;
    const Wide d2 = x2 - c.impulse2;
    c.impulse1 = x1;
    c.impulse2 = x2;
    const Wide change = d1 + d2;
    ends.apply(c, change * c.normalX, change * c.normalY, d1 * c.leverA1 + d2 * c.leverA2,
               d1 * c.leverB1 + d2 * c.leverB2);
}

/// Friction first, so that the normal velocities come out right. What is hit in this pass has no normal impulse to
/// limit its friction before, and rubs afterwards.
template <class Batch>
SPACETOW_INLINE void solveOnce(Ends& ends, Batch& c) {
    const Wide before = normalOf(c);
    solveFriction(ends, c);
    solveNormals(ends, c);
    const Mask hit = (before == Wide{}) & (normalOf(c) > Wide{});
    if (any(hit)) {
        solveFriction(ends, c, hit);
    }
}

/// What stays the same from the first lane to the last.
struct Call {
    BodyViews bodies{};
    ContactRules rules{};
    PushRules pushes{};
};

SPACETOW_INLINE LaneBits bits(Mask mask) {
    return static_cast<LaneBits>((mask[0] & 1) | (mask[1] & 2) | (mask[2] & 4) | (mask[3] & 8));
}

SPACETOW_INLINE Wide root(Wide x) {
    return Wide{__builtin_sqrt(x[0]), __builtin_sqrt(x[1]), __builtin_sqrt(x[2]), __builtin_sqrt(x[3])};
}

SPACETOW_INLINE Wide magnitude(Wide x) {
    return x < Wide{} ? -x : x;
}

SPACETOW_INLINE Wide row(const BodyRows& rows, Slot slot) {
    Wide result;
    std::memcpy(&result, static_cast<const char*>(rows.first) + slot * rows.stride, sizeof result);
    return result;
}

SPACETOW_INLINE WidePace load(const BodyRows& rows, const std::array<Slot, 4>& slots) {
    return transposed(row(rows, slots[0]), row(rows, slots[1]), row(rows, slots[2]), row(rows, slots[3]));
}

/// What the normal velocity is to be where nothing bounces.
SPACETOW_INLINE Wide targetAt(Wide separation, const ContactRules& rules) {
    return separation > Wide{} ? -separation * rules.perSecond : Wide{};
}

SPACETOW_INLINE Wide closingAt(Wide separation, const ContactRules& rules) {
    return -rules.perSecond * greater(separation + rules.slop, Wide{} + 0.1 * rules.slop);
}

/// Which contacts are out of reach.
SPACETOW_INLINE Mask refresh(RoundBatch& c, const RoundShapes& shapes, const Call& call) {
    const WidePace a = load(call.bodies.poses, shapes.a);
    const WidePace b = load(call.bodies.poses, shapes.b);
    const Wide apartX = b.x - a.x;
    const Wide apartY = b.y - a.y;
    const Wide squared = apartX * apartX + apartY * apartY;
    const WidePace wayA = load(call.bodies.ways, shapes.a);
    const WidePace wayB = load(call.bodies.ways, shapes.b);
    const Wide way = magnitude(wayA.x - wayB.x) + magnitude(wayA.y - wayB.y);
    const Wide margin = call.rules.slop + lesser(way, 0.5 * (wayA.unused + wayB.unused));
    const Wide reach = shapes.radiusA + shapes.radiusB + margin;
    const Wide distance = root(squared);
    const Mask apart = distance > Wide{};
    const Wide separation = distance - shapes.radiusA - shapes.radiusB;
    const Wide leverA = shapes.radiusA + 0.5 * separation;
    const Wide leverB = -shapes.radiusB - 0.5 * separation;
    const Mask here = shapes.here;
    c.normalX = here ? (apart ? apartX / distance : Wide{}) : c.normalX;
    c.normalY = here ? (apart ? apartY / distance : Wide{} + 1) : c.normalY;
    c.separation = here ? separation : c.separation;
    c.leverA = here ? leverA : c.leverA;
    c.leverB = here ? leverB : c.leverB;
    const Wide mass = c.massA + c.massB + c.inertiaA * leverA * leverA + c.inertiaB * leverB * leverB;
    c.tangentMass = here ? 1 / mass : c.tangentMass;
    c.target = here ? targetAt(separation, call.rules) : c.target;
    c.closing = here ? closingAt(separation, call.rules) : c.closing;
    return here & (squared > reach * reach);
}

/// A point that stays with a body, in the world.
SPACETOW_INLINE Wide worldX(const WidePace& pose, Wide x, Wide y) {
    return pose.x + (pose.turn * x - pose.unused * y);
}
SPACETOW_INLINE Wide worldY(const WidePace& pose, Wide x, Wide y) {
    return pose.y + (pose.unused * x + pose.turn * y);
}

/// Whether the parts have moved against each other so far that their manifold may lack something.
SPACETOW_INLINE Mask outdated(const ConstraintShapes& s, const WidePace& a, const WidePace& b, const Call& call) {
    const Wide apartX = a.x - b.x;
    const Wide apartY = a.y - b.y;
    const Wide movedX = b.turn * apartX + b.unused * apartY - s.relativeX;
    const Wide movedY = b.turn * apartY - b.unused * apartX - s.relativeY;
    const Wide turnedC = b.turn * a.turn + b.unused * a.unused - s.cosine;
    const Wide turnedS = b.turn * a.unused - b.unused * a.turn - s.sine;
    const Wide left =
        s.room - root(movedX * movedX + movedY * movedY) - root(turnedC * turnedC + turnedS * turnedS) * s.radiusA;
    const WidePace wayA = load(call.bodies.ways, s.a);
    WidePace wayB = load(call.bodies.ways, s.b);
    wayB.x = s.still ? Wide{} : wayB.x;
    wayB.y = s.still ? Wide{} : wayB.y;
    wayB.turn = s.still ? Wide{} : wayB.turn;
    wayB.unused = s.still ? Wide{} : wayB.unused;
    const Wide way = magnitude(wayA.x - wayB.x) + magnitude(wayA.y - wayB.y) + magnitude(wayA.turn) * s.radiusA +
                     magnitude(wayB.turn) * s.radiusB;
    return left < call.rules.slop + lesser(way, 0.5 * (wayA.unused + wayB.unused));
}

SPACETOW_INLINE Mask refresh(ConstraintBatch& c, const ConstraintShapes& s, const Call& call) {
    const WidePace a = load(call.bodies.poses, s.a);
    WidePace b = load(call.bodies.poses, s.b);
    b.x = s.still ? Wide{} : b.x;
    b.y = s.still ? Wide{} : b.y;
    b.turn = s.still ? Wide{} + 1 : b.turn;
    b.unused = s.still ? Wide{} : b.unused;
    const Wide cosine = s.ownedByA ? a.turn : b.turn;
    const Wide sine = s.ownedByA ? a.unused : b.unused;
    c.normalX = cosine * s.normalX - sine * s.normalY;
    c.normalY = sine * s.normalX + cosine * s.normalY;
    const Wide apart1X = worldX(b, s.onB1X, s.onB1Y) - worldX(a, s.onA1X, s.onA1Y);
    const Wide apart1Y = worldY(b, s.onB1X, s.onB1Y) - worldY(a, s.onA1X, s.onA1Y);
    const Wide apart2X = worldX(b, s.onB2X, s.onB2Y) - worldX(a, s.onA2X, s.onA2Y);
    const Wide apart2Y = worldY(b, s.onB2X, s.onB2Y) - worldY(a, s.onA2X, s.onA2Y);
    const Wide separation1 = apart1X * c.normalX + apart1Y * c.normalY;
    const Wide separation2 = apart2X * c.normalX + apart2Y * c.normalY;
    const Wide far = Wide{} + std::numeric_limits<double>::infinity();
    const Wide never = Wide{} + noTarget;
    c.separation1 = s.first ? separation1 : far;
    c.separation2 = s.second ? separation2 : far;
    c.target1 = s.acts1 ? targetAt(separation1, call.rules) : never;
    c.target2 = s.acts2 ? targetAt(separation2, call.rules) : never;
    c.closing1 = s.first ? closingAt(separation1, call.rules) : never;
    c.closing2 = s.second ? closingAt(separation2, call.rules) : never;
    return outdated(s, a, b, call);
}

template <class Batch>
SPACETOW_INLINE void refreshAll(const Call& call, Batches<Batch>& batches) {
    const std::size_t count = batches.size();
    for (std::size_t i = 0; i < count; ++i) {
        BatchNotes& notes = batches.notes(i);
        notes.outdated = bits(refresh(batches.begin()[i], batches.shapes(i), call)) & notes.occupied;
    }
}

SPACETOW_INLINE Mask touching(const RoundBatch& c) {
    return (c.normalImpulse > Wide{}) | (c.separation <= Wide{});
}
SPACETOW_INLINE Mask touching(const ConstraintBatch& c) {
    return (c.impulse1 > Wide{}) | (c.separation1 <= Wide{}) | (c.impulse2 > Wide{}) | (c.separation2 <= Wide{});
}
/// The way that the surfaces at a point are pushed apart, as an impulse, kg m.
SPACETOW_INLINE Wide wayOut(Wide separation, Wide velocity, Wide mass, const PushRules& rules) {
    const Wide excess = -rules.slop - separation - rules.dt * greater(velocity, Wide{});
    return excess > Wide{} ? lesser(rules.share * excess, Wide{} + rules.most) * mass : Wide{};
}

SPACETOW_INLINE Mask overlapping(const RoundBatch& c, const RoundShapes&, double slop) {
    return c.separation < Wide{} - slop;
}
SPACETOW_INLINE Mask overlapping(const ConstraintBatch& c, const ConstraintShapes& s, double slop) {
    return (s.acts1 & (c.separation1 < Wide{} - slop)) | (s.acts2 & (c.separation2 < Wide{} - slop));
}

SPACETOW_INLINE void pushOut(Ends& ends, const RoundBatch& c, const RoundShapes&, const PushRules& rules) {
    const Wide way = wayOut(c.separation, c.velocity, c.normalMass, rules);
    ends.push(c, way * c.normalX, way * c.normalY);
}

SPACETOW_INLINE void pushOut(Ends& ends, const ConstraintBatch& c, const ConstraintShapes& s, const PushRules& rules) {
    const Wide way1 = s.acts1 ? wayOut(c.separation1, c.velocity1, c.mass1, rules) : Wide{};
    const Wide way2 = s.acts2 ? wayOut(c.separation2, c.velocity2, c.mass2, rules) : Wide{};
    const Wide way = way1 + way2;
    ends.apply(c, way * c.normalX, way * c.normalY, way1 * c.leverA1 + way2 * c.leverA2,
               way1 * c.leverB1 + way2 * c.leverB2);
}

template <class Batch>
SPACETOW_INLINE bool pushAll(Pace* pushes, Batches<Batch>& batches, const PushRules& rules) {
    const std::size_t count = batches.size();
    bool any = false;
    for (std::size_t i = 0; i < count; ++i) {
        const Batch& batch = batches.begin()[i];
        if ((bits(overlapping(batch, batches.shapes(i), rules.slop)) & batches.notes(i).occupied) == 0) {
            continue;
        }
        Ends ends{load(pushes, batch.a), load(pushes, batch.b)};
        pushOut(ends, batch, batches.shapes(i), rules);
        store(pushes, batch.a, ends.a);
        store(pushes, batch.b, ends.b);
        any = true;
    }
    return any;
}

enum class Task { Refresh, WarmStart, Solve, Measure, PushApart };

template <class Batch>
SPACETOW_INLINE void warmAll(Pace* paces, Batches<Batch>& batches) {
    const std::size_t count = batches.size();
    for (std::size_t i = 0; i < count; ++i) {
        const Batch& batch = batches.begin()[i];
        Ends ends{load(paces, batch.a), load(paces, batch.b)};
        warm(ends, batch);
        store(paces, batch.a, ends.a);
        store(paces, batch.b, ends.b);
    }
}

template <class Batch>
SPACETOW_INLINE void solveAll(Pace* paces, Batches<Batch>& batches) {
    const std::size_t count = batches.size();
    for (std::size_t i = 0; i < count; ++i) {
        Batch& batch = batches.begin()[i];
        Ends ends{load(paces, batch.a), load(paces, batch.b)};
        solveOnce(ends, batch);
        store(paces, batch.a, ends.a);
        store(paces, batch.b, ends.b);
    }
}

SPACETOW_INLINE Mask measure(const Ends& ends, RoundBatch& c) {
    c.velocity = ends.along(c.normalX, c.normalY);
    return c.velocity < c.closing;
}

SPACETOW_INLINE Mask measure(const Ends& ends, ConstraintBatch& c) {
    const Wide linear = ends.along(c.normalX, c.normalY);
    c.velocity1 = linear + ends.turning(c.leverA1, c.leverB1);
    c.velocity2 = linear + ends.turning(c.leverA2, c.leverB2);
    return (c.velocity1 < c.closing1) | (c.velocity2 < c.closing2);
}

template <class Batch>
SPACETOW_INLINE bool measureAll(const Pace* paces, Batches<Batch>& batches) {
    const std::size_t count = batches.size();
    LaneBits closes = 0;
    for (std::size_t i = 0; i < count; ++i) {
        Batch& batch = batches.begin()[i];
        const Mask here = measure(Ends{load(paces, batch.a), load(paces, batch.b)}, batch);
        BatchNotes& notes = batches.notes(i);
        notes.closes = bits(here) & notes.occupied;
        notes.touches = bits(touching(batch)) & notes.occupied;
        closes |= notes.closes;
    }
    return closes != 0;
}

SPACETOW_INLINE bool carryOut(ContactBatches& batches, Task task, const Call& call) {
    Pace* paces = batches.paces.data();
    switch (task) {
    case Task::Refresh:
        refreshAll(call, batches.round);
        refreshAll(call, batches.general);
        break;
    case Task::WarmStart:
        warmAll(paces, batches.round);
        warmAll(paces, batches.general);
        break;
    case Task::Solve:
        solveAll(paces, batches.round);
        solveAll(paces, batches.general);
        break;
    case Task::Measure: {
        const bool roundCloses = measureAll(paces, batches.round);
        return measureAll(paces, batches.general) || roundCloses;
    }
    case Task::PushApart: {
        const bool round = pushAll(batches.pushes.data(), batches.round, call.pushes);
        return pushAll(batches.pushes.data(), batches.general, call.pushes) || round;
    }
    }
    return false;
}

#if defined(__x86_64__)
__attribute__((target("avx2"))) bool carryOutWide(ContactBatches& batches, Task task, const Call& call) {
    return carryOut(batches, task, call);
}
#endif

bool start(ContactBatches& batches, Task task, [[maybe_unused]] bool wide, const Call& call = {}) {
#if defined(__x86_64__)
    if (wide) {
        return carryOutWide(batches, task, call);
    }
#endif
    return carryOut(batches, task, call);
}

} // namespace

void BatchPlan::reset(std::size_t bodies) {
    m_free.assign(bodies, 0);
    m_next.clear();
    m_filled.clear();
}

void BatchPlan::reserve(const BatchPlan& other) {
    m_free.reserve(other.m_free.capacity());
    m_next.reserve(other.m_next.capacity());
    m_filled.reserve(other.m_filled.capacity());
}

std::uint32_t BatchPlan::firstWithRoom(std::uint32_t from) {
    while (from < m_next.size() && m_next[from] != from) {
        const std::uint32_t next = m_next[from];
        if (next < m_next.size()) {
            m_next[from] = m_next[next];
        }
        from = next;
    }
    return from;
}

std::uint32_t BatchPlan::place(Slot a, bool movableA, Slot b, bool movableB) {
    const std::uint32_t earliest = std::max(movableA ? m_free[a] : 0, movableB ? m_free[b] : 0);
    const std::uint32_t batch = firstWithRoom(earliest);
    while (batch >= m_filled.size()) {
        m_next.push_back(static_cast<std::uint32_t>(m_filled.size()));
        m_filled.push_back(0);
    }
    if (++m_filled[batch] == 4) {
        m_next[batch] = batch + 1;
    }
    m_free[a] = batch + pause;
    m_free[b] = batch + pause;
    return batch;
}

void BatchPlan::release(std::uint32_t batch) {
    --m_filled[batch];
    m_next[batch] = batch;
}

bool hasWideRegisters() {
#if defined(__x86_64__)
    static const bool has = __builtin_cpu_supports("avx2") != 0;
    return has;
#else
    return false;
#endif
}

void refreshContacts(ContactBatches& batches, const BodyViews& bodies, const ContactRules& rules, bool wide) {
    start(batches, Task::Refresh, wide, {bodies, rules});
}

void warmStart(ContactBatches& batches, bool wide) {
    start(batches, Task::WarmStart, wide);
}

void solvePass(ContactBatches& batches, bool wide) {
    start(batches, Task::Solve, wide);
}

bool measureVelocities(ContactBatches& batches, bool wide) {
    return start(batches, Task::Measure, wide);
}

bool pushApart(ContactBatches& batches, const PushRules& rules, bool wide) {
    return start(batches, Task::PushApart, wide, {{}, {}, rules});
}

} // namespace spacetow
