#pragma once
// What makes of one level another one, small enough to be recorded many times: objects that are gone, and those that
// are new or others than before, whole.

#include "core/level/level.h"

#include <vector>

namespace spacetow {

struct LevelDelta {
    std::vector<Key> removed; // in the order in which they stood
    Level changed;            // the level after, with these of its objects alone
    /// All objects of the level after; empty when the others stand as before, and the new ones after them.
    std::vector<Key> order;

    bool operator==(const LevelDelta&) const = default;
};

/// Objects are compared by value; those that both levels share take no time.
LevelDelta deltaBetween(const Level& before, const Level& after);

/// `after`, when `before` is the level of which the delta was made. Of another level, what is not there is not removed,
/// and what is not named stands at the end.
Level withDelta(const Level& before, const LevelDelta& delta);

} // namespace spacetow
