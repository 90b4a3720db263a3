#pragma once
// Whether two parts meet at all, for bodies that are felt without exerting a force.

#include "core/geometry/part.h"
#include "core/math/transform.h"

namespace spacetow {

/// Whether intangible bodies feel each other: the parts meet anywhere, walls from either side and with one another
/// included, or collide() would let them touch at a margin of 0.
bool overlaps(const Part& a, const Transform& poseA, const Part& b, const Transform& poseB);

} // namespace spacetow
