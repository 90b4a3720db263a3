#pragma once
// Batches of four contacts, one in each SIMD lane. No two contacts of a batch share a movable body, and the batches
// keep the order of each body's contacts. The result is therefore, to the bit, that of solving one contact after the
// other. Compare E. Catto, "SIMD Matters" (2024): graph colouring gives up that order.

#include "core/physics/lanes/batch_plan.h"
#include "core/physics/lanes/wide.h"

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

namespace spacetow {

// A target velocity below every velocity, m/s: a row with this target never acts.
constexpr double noTarget = -1e30;

/// The inputs of the update of circle contacts.
struct alignas(32) CircleAnchors {
    std::array<Slot, 4> a{}, b{};
    std::array<std::uint32_t, 4> owner{}; // index in `circleContacts`
    Mask wideUpdate{};                    // lanes that the kernel updates; the narrow phase updates the others
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

/// The inputs of the update of all other contacts while their manifolds are kept: anchors, in local coordinates.
struct alignas(32) ContactAnchors {
    std::array<Slot, 4> a{}, b{};
    std::array<std::uint32_t, 4> owner{}; // index in `generalContacts`
    Mask staticB{};                       // b is static: its anchors are in world coordinates
    Mask normalOnA{};                     // the normal is in local coordinates of a, else of b
    Mask acts1{}, acts2{};                // whether an impulse at the point can move a body
    Mask first{}, second{};               // whether the manifold has the point
    Mask singular{};                      // the 2 × 2 system is singular: one point acts for both
    Wide normalX{}, normalY{};
    Wide onA1X{}, onA1Y{}, onB1X{}, onB1Y{}, onA2X{}, onA2Y{}, onB2X{}, onB2Y{};
    Wide relativeX{}, relativeY{}, cosine{}, sine{}; // the pose of a relative to b when the manifold was made
    Wide tolerance{};        // manifold tolerance, m: more relative motion outdates the manifold
    Wide radiusA{};          // m: outer radius of the body of a; 0 for a circle
    Wide leastInverseMass{}; // 1/kg: with a smaller inverse mass the point does not act

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

/// Four circle contacts. `mass` and `inertia` are inverse masses (1/kg) and inverse inertias (1/(kg m²)).
struct alignas(32) CircleBatch {
    using Anchors = CircleAnchors;

    std::array<Slot, 4> a{}, b{};
    Wide normalX{}, normalY{};
    Wide massA{}, massB{}, inertiaA{}, inertiaB{};
    Wide leverA{}, leverB{};
    Wide normalMass{}, tangentMass{};
    Wide friction{}, target{};
    Wide normalImpulse{}, tangentImpulse{};
    Wide closingLimit{}; // m/s: a velocity below it would penetrate by more than the slop
    Wide velocity{};     // m/s along the normal, after the last pass
    Wide separation{};   // m

    void vacate(Slot nobody) {
        a.fill(nobody);
        b.fill(nobody);
    }
};

/// Four contacts of one or two points; units as in CircleBatch. A missing second point has the target `noTarget`.
struct alignas(32) ConstraintBatch {
    using Anchors = ContactAnchors;

    std::array<Slot, 4> a{}, b{};
    Wide normalX{}, normalY{};
    Wide massA{}, massB{}, inertiaA{}, inertiaB{};
    Wide tangentLeverA{}, tangentLeverB{};
    Wide tangentMass{}, friction{}, tangentImpulse{};
    Wide leverA1{}, leverB1{}, target1{}, impulse1{};
    Wide leverA2{}, leverB2{}, target2{}, impulse2{};
    Wide k11{}, k22{}, coupling{}, inverseDeterminant{}; // elements and inverse determinant of the inverse mass matrix
    Wide mass1{}, mass2{};                               // 1/k11, 1/k22
    Wide closingLimit1{}, closingLimit2{};
    Wide velocity1{}, velocity2{};
    Wide separation1{}, separation2{};

    void vacate(Slot nobody) {
        a.fill(nobody);
        b.fill(nobody);
    }
};

/// The place of a contact.
struct Lane {
    std::uint32_t batch = 0, lane = 0;
};

/// A set of lanes of a batch; bit i is lane i.
using LaneBits = std::uint8_t;

/// Results of the kernels, by lane.
struct BatchFlags {
    LaneBits occupied = 0;
    LaneBits outdated = 0; // beyond the speculative margin, or the manifold is outdated
    LaneBits closes = 0;   // faster than the closing limit
    LaneBits touched = 0;  // at the end of the last iteration
    LaneBits touches = 0;  // has an impulse, or a separation ≤ 0
    LaneBits overlaps = 0; // penetrates by more than the slop
};

/// An array of batches with their plan. `reset` keeps the memory, and does not clear it: clearing costs more than
/// filling.
template <class Batch>
class Batches {
  public:
    using Anchors = typename Batch::Anchors;

    void reset(std::size_t bodies) { m_plan.reset(bodies); }
    /// Reserves the capacity that `other` has.
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

    /// Opens a lane for a contact of two bodies. The caller fills the lane.
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

    /// Closes the lane; a later contact may get it.
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

/// Copies all of a contact but its two slots.
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

/// Visits the lanes that have the flag, by batch, then by lane.
template <class Batch, class Visit>
void forLanes(const Batches<Batch>& batches, LaneBits BatchFlags::*which, const Visit& visit) {
    for (std::uint32_t k = 0; k < batches.size(); ++k) {
        for (unsigned lanes = batches.flags(k).*which; lanes != 0; lanes &= lanes - 1) {
            visit(Lane{k, static_cast<std::uint32_t>(std::countr_zero(lanes))});
        }
    }
}

/// All contacts of the solver.
struct ContactBatches {
    Batches<CircleBatch> circles;
    Batches<ConstraintBatch> general;
};

/// Limit of k² / det for the inverse mass matrix of two points, with k the largest element. Above it the matrix counts
/// as singular, and one point acts for both.
constexpr double singularRatio = 1000;

} // namespace spacetow
