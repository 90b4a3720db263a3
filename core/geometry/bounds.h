#pragma once
// Bounding boxes of shapes and parts in the world.

#include "core/geometry/part.h"
#include "core/math/aabb.h"
#include "core/math/transform.h"

#include <span>

namespace spacetow {

// m: the AABB of an edge of infinite depth reaches this far behind the edge. A static edge is solid beyond it as well,
// see wall_back.h.
constexpr double noBackReach = 10;

/// Exact AABBs. The AABB of an edge covers its depth.
Aabb boundsOf(const Shape& shape, const Transform& pose);
Aabb boundsOf(const Part& part, const Transform& pose);
/// The AABB of all parts of a body.
Aabb boundsOf(std::span<const Part> parts, const Transform& pose);

/// The AABB of an edge with each half extent enlarged by 0.1 m and then by a tenth.
Aabb enlargedEdgeBounds(const Aabb& bounds);

} // namespace spacetow
