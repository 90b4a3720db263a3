#pragma once
// Walls that lie on each other, end to end: for the rule that reports them and for the fix that takes them away.

#include "core/level/lint_walls.h"

namespace spacetow {

/// Segments of a chain that do what those of an earlier one, or earlier ones of the same, do already.
struct WallOverlap {
    int chain = 0;
    int under = 0;             // the chain that stays
    std::vector<int> segments; // of `chain`, ascending
};
std::vector<WallOverlap> wallOverlaps(const std::vector<WallChain>& chains);

} // namespace spacetow
