#pragma once
// Union, difference and intersection of areas. Metres. Results are rounded to 10⁻⁸ m; corners of what went in come out
// to the bit.

#include "core/math/vec.h"

#include <vector>

namespace spacetow {

using PolygonSet = std::vector<std::vector<Vec2>>; // simple outlines; may overlap each other

enum class PolygonBoolean { Union, Difference, Intersection };

/// What lies in `a` or `b`, in `a` but not in `b`, or in both: simple anticlockwise outlines that do not overlap and
/// have no holes; an area with a hole is cut through it into several. Coordinates are below 10⁶ m.
PolygonSet combined(const PolygonSet& a, const PolygonSet& b, PolygonBoolean how);

/// Which points outlines that cross themselves and each other, or lie in one another, fill: those they go round an odd
/// number of times, or those they go round more often one way than the other.
enum class FillRule { EvenOdd, NonZero };

/// What outlines, of at least three points and running either way, fill: areas as `combined` gives them.
PolygonSet filledAreas(const PolygonSet& outlines, FillRule rule);

} // namespace spacetow
