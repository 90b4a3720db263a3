#pragma once
// Contacts in fours that have no moving body in common, laid out so that one instruction serves all four. Each body
// meets its contacts in the order in which they were given, so the result is, to the bit, that of one after the other.
// Reading material: E. Catto, "SIMD Matters" (2024), whose graph colouring gives up that order.

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

namespace spacetow {

using Slot = std::uint32_t;

/// Penetration that is left alone so that resting contacts persist, m.
constexpr double linearSlop = 0.0004;

/// Four doubles; the compiler uses what registers the processor has.
using Wide = double __attribute__((vector_size(32), aligned(32)));

/// Lanes of which something is true.
using Mask = decltype(Wide{} < Wide{});

/// A velocity while contacts are solved: what four of them are loaded as.
struct alignas(32) Pace {
    double x = 0, y = 0; // velocity, m/s
    double turn = 0;     // rad/s
    double unused = 0;
};

// What no velocity falls short of, m/s.
constexpr double noTarget = -1e30;

/// From what round contacts of moving bodies are made anew while they last.
struct alignas(32) RoundShapes {
    std::array<Slot, 4> a{}, b{};
    std::array<std::uint32_t, 4> owner{}; // index in `roundContacts`
    Mask here{};                          // lanes that are made anew here, and not one by one
    Wide radiusA{}, radiusB{};

    void vacate() {
        a.fill(0);
        b.fill(0);
        here = Mask{};
    }
    void close(std::uint32_t lane) {
        a[lane] = b[lane] = 0;
        here[lane] = 0;
    }
};

/// From what other contacts are made anew while their manifolds are kept.
struct alignas(32) ConstraintShapes {
    std::array<Slot, 4> a{}, b{};
    std::array<std::uint32_t, 4> owner{}; // index in `constraints`
    Mask still{};                         // b is static: its points are in the world's coordinates
    Mask ownedByA{};                      // the normal is in the coordinates of a
    Mask acts1{}, acts2{};                // whether a push at the point can move anything
    Mask first{}, second{};               // whether there is the point at all
    Mask singular{};                      // one of the points acts for both
    Wide normalX{}, normalY{};
    Wide onA1X{}, onA1Y{}, onB1X{}, onB1Y{}, onA2X{}, onA2Y{}, onB2X{}, onB2Y{};
    Wide relativeX{}, relativeY{}, cosine{}, sine{}; // of a in the coordinates of b when the manifold was made
    Wide room{};                                     // m that the parts may come closer before it is out of date
    Wide radiusA{};                                  // around the body
    Wide least{};                                    // 1/kg: what yields no more to a push does not yield to it

    void vacate() {
        a.fill(0);
        b.fill(0);
        acts1 = acts2 = first = second = singular = Mask{};
    }
    void close(std::uint32_t lane) {
        a[lane] = b[lane] = 0;
        acts1[lane] = acts2[lane] = first[lane] = second[lane] = singular[lane] = 0;
    }
};

/// Quantities as in RoundContact; masses and inertias are inverse.
struct alignas(32) RoundBatch {
    using Shapes = RoundShapes;

    std::array<Slot, 4> a{}, b{};
    Wide normalX{}, normalY{};
    Wide massA{}, massB{}, inertiaA{}, inertiaB{};
    Wide leverA{}, leverB{};
    Wide normalMass{}, tangentMass{};
    Wide friction{}, target{};
    Wide normalImpulse{}, tangentImpulse{};
    Wide closing{};    // m/s: nearer than they may come in this iteration
    Wide velocity{};   // m/s along the normal, after the last pass
    Wide separation{}; // m

    void vacate(Slot nobody) {
        a.fill(nobody);
        b.fill(nobody);
    }
};

/// Quantities as in Constraint. A missing second point has a target that every velocity exceeds.
struct alignas(32) ConstraintBatch {
    using Shapes = ConstraintShapes;

    std::array<Slot, 4> a{}, b{};
    Wide normalX{}, normalY{};
    Wide massA{}, massB{}, inertiaA{}, inertiaB{};
    Wide tangentLeverA{}, tangentLeverB{};
    Wide tangentMass{}, friction{}, tangentImpulse{};
    Wide leverA1{}, leverB1{}, target1{}, impulse1{};
    Wide leverA2{}, leverB2{}, target2{}, impulse2{};
    Wide k11{}, k22{}, coupling{}, inverseDeterminant{}; // of the inverse mass matrix
    Wide mass1{}, mass2{};                               // 1/k11, 1/k22
    Wide closing1{}, closing2{};
    Wide velocity1{}, velocity2{};
    Wide separation1{}, separation2{};

    void vacate(Slot nobody) {
        a.fill(nobody);
        b.fill(nobody);
    }
};

/// Where a contact's lane is.
struct Lane {
    std::uint32_t batch = 0, lane = 0;
};

/// Assigns contacts to batches: each to the first with room after those of its bodies' earlier contacts.
class BatchPlan {
  public:
    /// `bodies` slots are in use.
    void reset(std::size_t bodies);
    /// Room for as many batches and bodies as `other` has room for.
    void reserve(const BatchPlan& other);
    /// Returns the batch. A body that contacts cannot move may be in several lanes of it.
    std::uint32_t place(Slot a, bool movableA, Slot b, bool movableB);
    /// The batch has room for one more again.
    void release(std::uint32_t batch);
    std::size_t size() const { return m_filled.size(); }
    /// The slot for lanes without a contact: one more than those of bodies.
    Slot nobody() const { return static_cast<Slot>(m_free.size()); }

  private:
    std::uint32_t firstWithRoom(std::uint32_t from);

    std::vector<std::uint32_t> m_free;  // by slot: the first batch that the body is not yet in
    std::vector<std::uint32_t> m_next;  // by batch: itself, or one nearer to the first with room
    std::vector<std::uint8_t> m_filled; // lanes, by batch
};

/// Which lanes of a batch something is true of, a bit each.
using LaneBits = std::uint8_t;

/// What a look at all contacts has found.
struct BatchNotes {
    LaneBits occupied = 0;
    LaneBits outdated = 0; // out of reach, or the manifold no longer holds
    LaneBits closes = 0;   // faster than it may
    LaneBits touched = 0;  // when it was looked at before
    LaneBits touches = 0;  // with an impulse or without a gap
    LaneBits overlaps = 0; // by more than the slop
};

/// Batches are used again without being cleared: that takes longer than filling them.
template <class Batch>
class Batches {
  public:
    using Shapes = typename Batch::Shapes;

    void reset(std::size_t bodies) { m_plan.reset(bodies); }
    /// Room for as much as `other` has room for.
    void reserve(const Batches& other) {
        m_plan.reserve(other.m_plan);
        m_batches.reserve(other.m_batches.capacity());
        m_shapes.reserve(other.m_shapes.capacity());
        m_notes.reserve(other.m_notes.capacity());
    }
    Batch& operator[](std::uint32_t index) { return m_batches[index]; }
    const Batch& operator[](std::uint32_t index) const { return m_batches[index]; }
    Batch* begin() { return m_batches.data(); }
    Shapes& shapes(std::size_t index) { return m_shapes[index]; }
    const Shapes& shapes(std::size_t index) const { return m_shapes[index]; }
    BatchNotes& notes(std::size_t index) { return m_notes[index]; }
    const BatchNotes& notes(std::size_t index) const { return m_notes[index]; }
    std::size_t size() const { return m_plan.size(); }

    /// A lane for the contact of two bodies.
    Lane open(Slot a, bool movableA, Slot b, bool movableB) {
        const std::size_t used = m_plan.size();
        Lane lane{m_plan.place(a, movableA, b, movableB), 0};
        if (m_batches.size() < m_plan.size()) {
            m_batches.resize(m_plan.size());
            m_shapes.resize(m_plan.size());
            m_notes.resize(m_plan.size());
        }
        for (std::size_t fresh = used; fresh < m_plan.size(); ++fresh) {
            m_batches[fresh].vacate(m_plan.nobody());
            m_shapes[fresh].vacate();
            m_notes[fresh] = {};
        }
        LaneBits& occupied = m_notes[lane.batch].occupied;
        lane.lane = static_cast<std::uint32_t>(std::countr_one(occupied));
        occupied = static_cast<LaneBits>(occupied | 1u << lane.lane);
        m_batches[lane.batch].a[lane.lane] = a;
        m_batches[lane.batch].b[lane.lane] = b;
        return lane;
    }

    /// Gives the lane up; its place may be used again.
    void close(Lane lane) {
        m_plan.release(lane.batch);
        BatchNotes& notes = m_notes[lane.batch];
        const auto others = static_cast<LaneBits>(~(1u << lane.lane));
        notes.occupied &= others;
        notes.touched &= others;
        m_shapes[lane.batch].close(lane.lane);
        m_batches[lane.batch].a[lane.lane] = m_batches[lane.batch].b[lane.lane] = m_plan.nobody();
    }

  private:
    BatchPlan m_plan;
    std::vector<Batch> m_batches;
    std::vector<Shapes> m_shapes;
    std::vector<BatchNotes> m_notes;
};

/// Copies one contact, but for its bodies.
template <class Batch>
void copyLane(const Batch& from, std::uint32_t lane, Batch& to, std::uint32_t toLane) {
    constexpr std::size_t bodies = sizeof from.a + sizeof from.b;
    static_assert(bodies == sizeof(Wide) && sizeof(Batch) % sizeof(Wide) == 0);
    const char* source = reinterpret_cast<const char*>(&from) + lane * sizeof(double);
    char* target = reinterpret_cast<char*>(&to) + toLane * sizeof(double);
    for (std::size_t at = bodies; at < sizeof(Batch); at += sizeof(Wide)) {
        std::memcpy(target + at, source + at, sizeof(double));
    }
}

/// Visits the lanes that the notes name, in their order.
template <class Batch, class Visit>
void forLanes(const Batches<Batch>& batches, LaneBits BatchNotes::*which, const Visit& visit) {
    for (std::uint32_t k = 0; k < batches.size(); ++k) {
        for (unsigned lanes = batches.notes(k).*which; lanes != 0; lanes &= lanes - 1) {
            visit(Lane{k, static_cast<std::uint32_t>(std::countr_zero(lanes))});
        }
    }
}

/// Working memory of the solver.
struct ContactBatches {
    std::vector<Pace> paces;   // by slot, and one more for lanes without a contact
    std::vector<Pace> starts;  // by slot, at the beginning of the iteration
    std::vector<Pace> planned; // by slot, without the contacts' impulses
    std::vector<Pace> pushes;  // by slot, and one more: out of overlaps, m and rad in the iteration
    Batches<RoundBatch> round;
    Batches<ConstraintBatch> general;
};

/// Of the largest element of two points' inverse mass matrix, squared, to the determinant: from here on the points have
/// so nearly the same effect that one acts for both.
constexpr double singularRatio = 1000;

/// Where something is kept of each body, by slot: four doubles at the beginning of `stride` bytes each.
struct BodyRows {
    const void* first;
    std::size_t stride;
};

/// From what contacts are made anew.
struct BodyViews {
    BodyRows poses; // centre of mass, cosine and sine
    BodyRows ways;  // shift in the iteration, way of the outermost points about the centre, inner radius
};

/// Whether the processor has registers for four doubles. What follows computes the same bits with them and without.
bool hasWideRegisters();

/// Normals, gaps, targets and what depends on them, from where bodies are now; and notes of what is outdated.
/// Iterations come `perSecond`.
void refreshContacts(ContactBatches& batches, const BodyViews& bodies, double perSecond,
                     bool wide = hasWideRegisters());

/// Applies the impulses that the contacts begin with.
void warmStart(ContactBatches& batches, bool wide = hasWideRegisters());

/// One pass over all contacts.
void solvePass(ContactBatches& batches, bool wide = hasWideRegisters());

/// How far single points are pushed apart in an over-relaxed pass, as a multiple of what stops them. The best one is
/// the nearer to 2 the longer a chain of bodies is; a chain of n is solved by some n passes with it, by some n²
/// without.
constexpr double overrelaxation = 1.9;

/// One over-relaxed pass, for where many follow each other; the last is to be an ordinary one. Contacts of polygons are
/// solved as ever: their friction would keep stacks trembling. C. W. Cryer, "The solution of a quadratic programming
/// problem using systematic overrelaxation" (1971).
void overrelaxPass(ContactBatches& batches, bool wide = hasWideRegisters());

/// The normal velocities that are left, and notes of what touches, what overlaps and what closes faster than it may.
/// Whether anything does.
bool measureVelocities(ContactBatches& batches, bool wide = hasWideRegisters());

/// How overlaps are reduced in an iteration of `dt` seconds.
struct PushRules {
    double dt;
    double share; // of what is more than the slop
    double most;  // m
};

/// Adds what pushes bodies out of overlaps to `pushes`, by the measured velocities and notes: what parts anyway is
/// pushed less. Whether anything overlaps.
bool pushApart(ContactBatches& batches, const PushRules& rules, bool wide = hasWideRegisters());

} // namespace spacetow
