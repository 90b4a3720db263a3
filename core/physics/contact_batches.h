#pragma once
// Contacts in fours that have no moving body in common, laid out so that one instruction serves all four. Each body
// meets its contacts in the order in which they were given, so the result is, to the bit, that of one after the other.
// Reading material: E. Catto, "SIMD Matters" (2024), whose graph colouring gives up that order.

#include <array>
#include <cstdint>
#include <cstring>
#include <vector>

namespace spacetow {

using Slot = std::uint32_t;

/// Four doubles; the compiler uses what registers the processor has.
using Wide = double __attribute__((vector_size(32), aligned(32)));

/// A velocity while contacts are solved: what four of them are loaded as.
struct alignas(32) Pace {
    double x = 0, y = 0; // velocity, m/s
    double turn = 0;     // rad/s
    double unused = 0;
};

/// Quantities as in RoundContact; masses and inertias are inverse.
struct alignas(32) RoundBatch {
    std::array<Slot, 4> a{}, b{};
    Wide normalX{}, normalY{};
    Wide massA{}, massB{}, inertiaA{}, inertiaB{};
    Wide leverA{}, leverB{};
    Wide normalMass{}, tangentMass{};
    Wide friction{}, target{};
    Wide normalImpulse{}, tangentImpulse{};
    Wide closing{};  // m/s: nearer than they may come in this iteration
    Wide velocity{}; // m/s along the normal, after the last pass

    void vacate(Slot nobody) {
        a.fill(nobody);
        b.fill(nobody);
        closing = Wide{} - 1e300;
    }
};

/// Quantities as in Constraint. A missing second point has a target that every velocity exceeds.
struct alignas(32) ConstraintBatch {
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

    void vacate(Slot nobody) {
        a.fill(nobody);
        b.fill(nobody);
        closing1 = closing2 = Wide{} - 1e300;
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
    /// A body that contacts cannot move may be in several lanes of a batch.
    Lane place(Slot a, bool movableA, Slot b, bool movableB);
    std::size_t size() const { return m_filled.size(); }
    /// The slot for lanes without a contact: one more than those of bodies.
    Slot nobody() const { return static_cast<Slot>(m_free.size()); }

  private:
    std::uint32_t firstWithRoom(std::uint32_t from);

    std::vector<std::uint32_t> m_free;  // by slot: the first batch that the body is not yet in
    std::vector<std::uint32_t> m_next;  // by batch: itself, or one nearer to the first with room
    std::vector<std::uint8_t> m_filled; // lanes, by batch
};

/// Batches are used again without being cleared: that takes longer than filling them.
template <class Batch>
class Batches {
  public:
    void reset(std::size_t bodies) { m_plan.reset(bodies); }
    /// Room for as much as `other` has room for.
    void reserve(const Batches& other) {
        m_plan.reserve(other.m_plan);
        m_batches.reserve(other.m_batches.capacity());
    }
    Batch& operator[](std::uint32_t index) { return m_batches[index]; }
    const Batch& operator[](std::uint32_t index) const { return m_batches[index]; }
    Batch* begin() { return m_batches.data(); }
    std::size_t size() const { return m_plan.size(); }

    /// A lane for the contact of two bodies.
    Lane open(Slot a, bool movableA, Slot b, bool movableB) {
        const std::size_t used = m_plan.size();
        const Lane lane = m_plan.place(a, movableA, b, movableB);
        if (m_batches.size() < m_plan.size()) {
            m_batches.resize(m_plan.size());
        }
        for (std::size_t fresh = used; fresh < m_plan.size(); ++fresh) {
            m_batches[fresh].vacate(m_plan.nobody());
        }
        m_batches[lane.batch].a[lane.lane] = a;
        m_batches[lane.batch].b[lane.lane] = b;
        return lane;
    }

  private:
    BatchPlan m_plan;
    std::vector<Batch> m_batches;
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

/// Working memory of the solver.
struct ContactBatches {
    std::vector<Pace> paces;   // by slot, and one more for lanes without a contact
    std::vector<Pace> starts;  // by slot, at the beginning of the iteration
    std::vector<Pace> planned; // by slot, without the contacts' impulses
    Batches<RoundBatch> round;
    Batches<ConstraintBatch> general;
};

/// Whether the processor has registers for four doubles. What follows computes the same bits with them and without.
bool hasWideRegisters();

/// Applies the impulses that the contacts begin with.
void warmStart(ContactBatches& batches, bool wide = hasWideRegisters());

/// One pass over all contacts.
void solvePass(ContactBatches& batches, bool wide = hasWideRegisters());

/// The normal velocities that are left. Whether any contact closes faster than it may.
bool measureVelocities(ContactBatches& batches, bool wide = hasWideRegisters());

} // namespace spacetow
