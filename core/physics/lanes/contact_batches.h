#pragma once
// Contacts in fours that have no moving body in common, laid out so that one instruction serves all four. Each body
// meets its contacts in the order in which they were given, so the result is, to the bit, that of one after the other.
// Reading material: E. Catto, "SIMD Matters" (2024), whose graph colouring gives up that order.

#include "core/physics/lanes/batch_plan.h"
#include "core/physics/lanes/wide.h"

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

namespace spacetow {

// What no velocity falls short of, m/s.
constexpr double noTarget = -1e30;

/// From what the contacts of moving circles are updated.
struct alignas(32) CircleAnchors {
    std::array<Slot, 4> a{}, b{};
    std::array<std::uint32_t, 4> owner{}; // index in `circleContacts`
    Mask wideUpdate{};                    // lanes that the kernel updates; others are updated one by one
    Wide radiusA{}, radiusB{};

    void vacate() {
        a.fill(0);
        b.fill(0);
        wideUpdate = Mask{};
    }
    void close(std::uint32_t lane) {
        a[lane] = b[lane] = 0;
        wideUpdate[lane] = 0;
    }
};

/// Contact anchors: from what other contacts are updated while their manifolds are kept.
struct alignas(32) ContactAnchors {
    std::array<Slot, 4> a{}, b{};
    std::array<std::uint32_t, 4> owner{}; // index in `constraints`
    Mask staticB{};                       // b is static: its points are in the world's coordinates
    Mask normalOnA{};                     // the normal is in the coordinates of a
    Mask acts1{}, acts2{};                // whether a push at the point can move anything
    Mask first{}, second{};               // whether there is the point at all
    Mask singular{};                      // one of the points acts for both
    Wide normalX{}, normalY{};
    Wide onA1X{}, onA1Y{}, onB1X{}, onB1Y{}, onA2X{}, onA2Y{}, onB2X{}, onB2Y{};
    Wide relativeX{}, relativeY{}, cosine{}, sine{}; // of a in the coordinates of b when the manifold was made
    Wide tolerance{};                                // m that the parts may come closer before it is out of date
    Wide radiusA{};                                  // around the body
    Wide leastInverseMass{};                         // 1/kg: what yields no more to a push does not yield to it

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

/// Quantities as in CircleContact; masses and inertias are inverse.
struct alignas(32) CircleBatch {
    using Anchors = CircleAnchors;

    std::array<Slot, 4> a{}, b{};
    Wide normalX{}, normalY{};
    Wide massA{}, massB{}, inertiaA{}, inertiaB{};
    Wide leverA{}, leverB{};
    Wide normalMass{}, tangentMass{};
    Wide friction{}, target{};
    Wide normalImpulse{}, tangentImpulse{};
    Wide closingLimit{}; // m/s: nearer than they may come in this iteration
    Wide velocity{};     // m/s along the normal, after the last pass
    Wide separation{};   // m

    void vacate(Slot nobody) {
        a.fill(nobody);
        b.fill(nobody);
    }
};

/// Quantities as in Constraint. A missing second point has a target that every velocity exceeds.
struct alignas(32) ConstraintBatch {
    using Anchors = ContactAnchors;

    std::array<Slot, 4> a{}, b{};
    Wide normalX{}, normalY{};
    Wide massA{}, massB{}, inertiaA{}, inertiaB{};
    Wide tangentLeverA{}, tangentLeverB{};
    Wide tangentMass{}, friction{}, tangentImpulse{};
    Wide leverA1{}, leverB1{}, target1{}, impulse1{};
    Wide leverA2{}, leverB2{}, target2{}, impulse2{};
    Wide k11{}, k22{}, coupling{}, inverseDeterminant{}; // of the inverse mass matrix
    Wide mass1{}, mass2{};                               // 1/k11, 1/k22
    Wide closingLimit1{}, closingLimit2{};
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

/// Which lanes of a batch something is true of, a bit each.
using LaneBits = std::uint8_t;

/// What the passes over all contacts have found.
struct BatchFlags {
    LaneBits occupied = 0;
    LaneBits outdated = 0; // out of reach, or the manifold no longer holds
    LaneBits closes = 0;   // faster than it may
    LaneBits touched = 0;  // at the end of the iteration before
    LaneBits touches = 0;  // with an impulse or without a gap
    LaneBits overlaps = 0; // by more than the slop
};

/// Batches are used again without being cleared: that takes longer than filling them.
template <class Batch>
class Batches {
  public:
    using Anchors = typename Batch::Anchors;

    void reset(std::size_t bodies) { m_plan.reset(bodies); }
    /// Room for as much as `other` has room for.
    void reserve(const Batches& other) {
        m_plan.reserve(other.m_plan);
        m_batches.reserve(other.m_batches.capacity());
        m_anchors.reserve(other.m_anchors.capacity());
        m_flags.reserve(other.m_flags.capacity());
    }
    Batch& operator[](std::uint32_t index) { return m_batches[index]; }
    const Batch& operator[](std::uint32_t index) const { return m_batches[index]; }
    Batch* begin() { return m_batches.data(); }
    Anchors& anchors(std::size_t index) { return m_anchors[index]; }
    const Anchors& anchors(std::size_t index) const { return m_anchors[index]; }
    BatchFlags& flags(std::size_t index) { return m_flags[index]; }
    const BatchFlags& flags(std::size_t index) const { return m_flags[index]; }
    std::size_t size() const { return m_plan.size(); }

    /// A lane for the contact of two bodies.
    Lane open(Slot a, bool movableA, Slot b, bool movableB) {
        const std::size_t used = m_plan.size();
        Lane lane{m_plan.place(a, movableA, b, movableB), 0};
        if (m_batches.size() < m_plan.size()) {
            m_batches.resize(m_plan.size());
            m_anchors.resize(m_plan.size());
            m_flags.resize(m_plan.size());
        }
        for (std::size_t fresh = used; fresh < m_plan.size(); ++fresh) {
            m_batches[fresh].vacate(m_plan.nobody());
            m_anchors[fresh].vacate();
            m_flags[fresh] = {};
        }
        LaneBits& occupied = m_flags[lane.batch].occupied;
        lane.lane = static_cast<std::uint32_t>(std::countr_one(occupied));
        occupied = static_cast<LaneBits>(occupied | 1u << lane.lane);
        m_batches[lane.batch].a[lane.lane] = a;
        m_batches[lane.batch].b[lane.lane] = b;
        return lane;
    }

    /// Gives the lane up; its place may be used again.
    void close(Lane lane) {
        m_plan.release(lane.batch);
        BatchFlags& flags = m_flags[lane.batch];
        const auto others = static_cast<LaneBits>(~(1u << lane.lane));
        flags.occupied &= others;
        flags.touched &= others;
        m_anchors[lane.batch].close(lane.lane);
        m_batches[lane.batch].a[lane.lane] = m_batches[lane.batch].b[lane.lane] = m_plan.nobody();
    }

  private:
    BatchPlan m_plan;
    std::vector<Batch> m_batches;
    std::vector<Anchors> m_anchors;
    std::vector<BatchFlags> m_flags;
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
void forLanes(const Batches<Batch>& batches, LaneBits BatchFlags::*which, const Visit& visit) {
    for (std::uint32_t k = 0; k < batches.size(); ++k) {
        for (unsigned lanes = batches.flags(k).*which; lanes != 0; lanes &= lanes - 1) {
            visit(Lane{k, static_cast<std::uint32_t>(std::countr_zero(lanes))});
        }
    }
}

/// All contacts that are solved together.
struct ContactBatches {
    Batches<CircleBatch> circles;
    Batches<ConstraintBatch> general;
};

/// Of the largest element of two points' inverse mass matrix, squared, to the determinant: from here on the points have
/// so nearly the same effect that one acts for both.
constexpr double singularRatio = 1000;

} // namespace spacetow
