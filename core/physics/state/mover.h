#pragma once
// Movers: indices of bodies in which one index, 0, stands for all static bodies. Loops over pairs then read the data of
// both bodies without a branch for static ones.

#include "core/physics/lanes/wide.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace spacetow {

/// One body of a pair: Static, or the slot of the body plus 1.
enum class Mover : std::uint32_t { Static = 0 };

constexpr Mover moverOf(Slot slot) {
    return Mover{slot + 1};
}
/// The slot of a mover that is not Static.
constexpr Slot slotOf(Mover mover) {
    return static_cast<Slot>(mover) - 1;
}

/// An array with one entry for each slot, and one entry that all static bodies of pairs share.
template <class T>
class MoverArray {
  public:
    T& operator[](Mover mover) { return m_entries[static_cast<std::size_t>(mover)]; }
    const T& operator[](Mover mover) const { return m_entries[static_cast<std::size_t>(mover)]; }
    T& operator[](Slot slot) { return m_entries[std::size_t{slot} + 1]; }
    const T& operator[](Slot slot) const { return m_entries[std::size_t{slot} + 1]; }

    /// `bodies` is the number of slots, here and below.
    void resize(std::size_t bodies) { m_entries.resize(bodies + 1); }
    void assign(std::size_t bodies, const T& value) { m_entries.assign(bodies + 1, value); }
    /// Pointer to the entry of slot 0. The entries of the other slots follow.
    const T* bodies() const { return m_entries.data() + 1; }

  private:
    std::vector<T> m_entries;
};

} // namespace spacetow
