#pragma once
// A path with fewer points.

#include "core/math/vec.h"

#include <span>
#include <vector>

namespace spacetow {

/// First and last point and so many between them that no other is further than `tolerance` metres from the line through
/// its neighbours (Douglas and Peucker). Finite points. Cost: usually n log n.
std::vector<Vec2> thinned(std::span<const Vec2> points, double tolerance);

} // namespace spacetow
