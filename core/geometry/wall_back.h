#pragma once
// The solid region behind an edge of infinite depth: all points behind its face and between its ends.

#include "core/geometry/wall_side.h"
#include "core/math/aabb.h"

#include <array>

namespace spacetow {

/// An unbounded convex region that contains the solid region.
struct WallBack {
    struct Limit {
        Vec2 inward{0, 1}; // unit
        double least = 0;  // m: p · inward ≥ least for every point p of the region
    };
    std::array<Limit, 3> limits;
    int count = 0;
    Vec2 first{-1, 0}, last{1, 0}; // unit: directions to infinity lie between them, anticlockwise

    /// Whether the box overlaps the region. Conservative: may be true for a box that is near a corner of the region.
    bool meets(const Aabb& box) const;
};

/// The region behind one side of a wall. Behind a hollow joint it extends to the region of the neighbour.
WallBack backOf(const WallSide& side);

} // namespace spacetow
