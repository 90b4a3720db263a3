#pragma once
// How arrays with an entry for each body say "a static body": bodies of pairs are movers, and one mover stands for all
// that is static. What is asked of a pair then needs no branch.

#include "core/physics/lanes/wide.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace spacetow {

/// A body as one of a pair.
enum class Mover : std::uint32_t { Static = 0 };

constexpr Mover moverOf(Slot slot) {
    return Mover{slot + 1};
}
/// Of a mover that is not static.
constexpr Slot slotOf(Mover mover) {
    return static_cast<Slot>(mover) - 1;
}

/// One entry for each body, by slot, and one for all that is static.
template <class T>
class MoverArray {
  public:
    T& operator[](Mover mover) { return m_entries[static_cast<std::size_t>(mover)]; }
    const T& operator[](Mover mover) const { return m_entries[static_cast<std::size_t>(mover)]; }
    T& operator[](Slot slot) { return m_entries[std::size_t{slot} + 1]; }
    const T& operator[](Slot slot) const { return m_entries[std::size_t{slot} + 1]; }

    void resize(std::size_t bodies) { m_entries.resize(bodies + 1); }
    void assign(std::size_t bodies, const T& value) { m_entries.assign(bodies + 1, value); }
    /// The entry of slot 0; those of the others follow.
    const T* bodies() const { return m_entries.data() + 1; }

  private:
    std::vector<T> m_entries;
};

} // namespace spacetow
