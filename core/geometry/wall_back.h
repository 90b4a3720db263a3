#pragma once
// What is solid behind an edge without a back: all that lies below its face and between its ends, however deep.

#include "core/geometry/wall_side.h"
#include "core/math/aabb.h"

#include <array>

namespace spacetow {

/// An unbounded convex region, which may be a little more than what is solid.
struct WallBack {
    struct Limit {
        Vec2 inward{0, 1}; // unit
        double least = 0;  // m: of p · inward
    };
    std::array<Limit, 3> limits;
    int count = 0;
    Vec2 first{-1, 0}, last{1, 0}; // unit: whichever way it goes on without end lies between, anticlockwise

    /// Whether the box reaches into it; where only corners come near it, the answer may be yes in error.
    bool meets(const Aabb& box) const;
};

/// Of one side of a wall. Behind a hollow joint it reaches as far as the neighbour's does at the other side of the gap.
WallBack backOf(const WallSide& side);

} // namespace spacetow
