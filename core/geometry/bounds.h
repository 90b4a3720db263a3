#pragma once
// Bounding boxes of shapes and parts in the world.

#include "core/geometry/part.h"
#include "core/math/aabb.h"
#include "core/math/transform.h"

namespace spacetow {

// m: how far behind an edge without a back its box reaches. A static one is solid beyond it too, see wall_back.h.
constexpr double noBackReach = 10;

/// Exact boxes. That of an edge covers the band of its depth.
Aabb boundsOf(const Shape& shape, const Transform& pose);
Aabb boundsOf(const Part& part, const Transform& pose);

/// The box of an edge with each half extent enlarged by 0.1 m and then by a tenth (report, page 7), which makes it
/// harder to slip past its ends.
Aabb enlargedEdgeBounds(const Aabb& bounds);

} // namespace spacetow
