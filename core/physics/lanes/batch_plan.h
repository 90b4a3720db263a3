#pragma once
// Which four contacts are solved together: four that have no moving body in common.

#include "core/physics/lanes/wide.h"

#include <cstddef>
#include <vector>

namespace spacetow {

/// Assigns contacts to batches: each to the first with room after those of its bodies' earlier contacts.
class BatchPlan {
  public:
    /// `bodies` slots are in use. Costs no more for many bodies than for few while there are as many as before.
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
    std::uint32_t freeFrom(Slot slot) const { return m_free[slot] > m_before ? m_free[slot] - m_before : 0; }

    std::uint32_t m_before = 0;         // batches of former plans: what is no more than that in m_free is of those
    std::vector<std::uint32_t> m_free;  // by slot: the first batch that the body is not yet in, after those before
    std::vector<std::uint32_t> m_next;  // by batch: itself, or one nearer to the first with room
    std::vector<std::uint8_t> m_filled; // lanes, by batch
};

} // namespace spacetow
