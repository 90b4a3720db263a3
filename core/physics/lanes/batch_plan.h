#pragma once
// Assigns contacts to batches of four. No two contacts of a batch share a movable body.

#include "core/physics/lanes/wide.h"

#include <cstddef>
#include <vector>

namespace spacetow {

/// Each contact goes to the first batch with a free lane after the batches of its bodies' earlier contacts.
class BatchPlan {
  public:
    /// Forgets all contacts; slots are below `bodies`. The cost does not grow with `bodies` unless that has changed.
    void reset(std::size_t bodies);
    /// Reserves the capacity that `other` has.
    void reserve(const BatchPlan& other);
    /// Returns the batch of the new contact. A body that is not movable may be in several lanes of one batch.
    std::uint32_t place(Slot a, bool movableA, Slot b, bool movableB);
    /// Frees one lane of the batch.
    void release(std::uint32_t batch);
    std::size_t size() const { return m_filled.size(); }
    /// The slot that lanes without a contact refer to: the number of body slots.
    Slot nobody() const { return static_cast<Slot>(m_free.size()); }

  private:
    std::uint32_t firstWithRoom(std::uint32_t from);
    std::uint32_t freeFrom(Slot slot) const { return m_free[slot] > m_before ? m_free[slot] - m_before : 0; }

    std::uint32_t m_before = 0;         // batches of earlier plans: entries of m_free up to this number are out of date
    std::vector<std::uint32_t> m_free;  // by slot: the first batch for the body's next contact, plus m_before
    std::vector<std::uint32_t> m_next;  // by batch: itself if a lane is free, else a later batch (a disjoint set)
    std::vector<std::uint8_t> m_filled; // by batch: lanes in use
};

} // namespace spacetow
