#pragma once
// Union, difference and intersection of areas. Metres. Results are rounded to 10⁻⁸ m, except for corners of the input,
// which keep their bits.

#include "core/math/vec.h"

#include <vector>

namespace spacetow {

using PolygonSet = std::vector<std::vector<Vec2>>; // simple outlines; may overlap each other

enum class PolygonBoolean { Union, Difference, Intersection };

/// The union, difference or intersection of `a` and `b` as simple anticlockwise outlines that do not overlap. An area
/// with a hole is cut into several outlines. Coordinates are below 10⁶ m.
PolygonSet combined(const PolygonSet& a, const PolygonSet& b, PolygonBoolean how);

/// Which points are filled: those with an odd winding number, or those whose winding number is not zero.
enum class FillRule { EvenOdd, NonZero };

/// The filled areas of outlines that may cross themselves and each other; each has at least three points and any
/// orientation. The result has the form of `combined`.
PolygonSet filledAreas(const PolygonSet& outlines, FillRule rule);

} // namespace spacetow
