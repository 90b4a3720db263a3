#pragma once
// Decomposes a simple polygon into convex pieces. Vertices are given by number.

#include "core/math/vec.h"

#include <span>
#include <vector>

namespace spacetow {

/// The outline without repeated vertices, vertices in the middle of a straight side, and spikes without area;
/// anticlockwise. Has fewer than three vertices if the area is zero.
std::vector<Vec2> cleanOutline(std::span<const Vec2> outline);

/// Convex anticlockwise pieces, of at most `maxCorners` (≥ 3) corners each, that cover a clean outline. An outline that
/// crosses itself gives arbitrary pieces. O(n²) at worst. `looks` is increased by the number of tests of a vertex
/// against a triangle, which is most of the work. Ear clipping (Meisters, 1975), then removal of diagonals (Hertel and
/// Mehlhorn, 1983), longest first.
std::vector<std::vector<int>> convexPieces(std::span<const Vec2> outline, int maxCorners, std::size_t* looks = nullptr);

} // namespace spacetow
