#pragma once
// Which tags really touched in a run, and which met and passed through each other because a mask said so.

#include "core/physics/world/world.h"

#include <array>

namespace spacetow {

class TagTouches {
  public:
    /// Of the last update of the world: the touches that began. With `meetings`, those whose masks do not meet too.
    void note(const World& world, bool meetings);

    bool haveTouched(int a, int b) const { return m_touched[static_cast<std::size_t>(a)].contains(b); }
    bool havePassed(int a, int b) const { return m_passed[static_cast<std::size_t>(a)].contains(b); }
    bool operator==(const TagTouches&) const = default;

  private:
    using Table = std::array<TagMask, 32>; // by tag; both ways round

    static void add(Table& table, TagMask a, TagMask b);

    Table m_touched{}, m_passed{};
};

} // namespace spacetow
