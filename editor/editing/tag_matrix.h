#pragma once
// Which tags meet, over all objects of a level: the table that the matrix panel shows.

#include "core/level/level.h"

#include <array>
#include <vector>

namespace spacetow {

enum class TagMeeting : std::uint8_t {
    Nobody, // no object has either tag
    None,   // those that are one never touch those that are the other
    Some,
    All,
};

struct TagMatrix {
    struct Cell {
        TagMeeting meeting = TagMeeting::Nobody;
        bool isFixed = false; // the rules of the game decide, whatever the level says

        bool operator==(const Cell&) const = default;
    };
    std::vector<int> tags; // named or in use, ascending
    std::array<std::array<Cell, TagTable::size>, TagTable::size> cells;
    std::array<int, TagTable::size> objects{}; // that have the tag

    const Cell& cell(int a, int b) const { return cells[static_cast<std::size_t>(a)][static_cast<std::size_t>(b)]; }
    bool operator==(const TagMatrix&) const = default;
};

/// Linear in the objects, and little.
TagMatrix tagMatrix(const Level& level);

} // namespace spacetow
