#pragma once
// Large levels for timing the editor, complete with ship, payload and finish. Made by formula, so that every run times
// the same ones.

#include "core/level/level.h"

namespace spacetow::bench {

enum class LargeLevel : std::uint8_t {
    Chains, // a hundred edges an object
    Bodies, // the same edges, each an object of its own
    Wall,   // one closed wall about everything
};

/// A level with this number of edges, a multiple of a hundred.
Level largeLevel(LargeLevel kind, int edges);

} // namespace spacetow::bench
