#pragma once
// Cuts a simple polygon into triangles and joins them to convex pieces. Works on vertex numbers.

#include "core/math/vec.h"

#include <span>
#include <vector>

namespace spacetow {

/// The outline without repeated vertices, without vertices in the middle of a straight side and without spikes that
/// enclose nothing; anticlockwise. Fewer than three vertices when it encloses nothing.
std::vector<Vec2> cleanOutline(std::span<const Vec2> outline);

/// Convex anticlockwise pieces of at most `maxCorners` (≥ 3) corners that cover a clean outline, as numbers of its
/// vertices. An outline that crosses itself is cut up somehow. O(n²) at worst. `looks` is increased by how often a
/// vertex was held against a triangle, which is most of the work. Ear clipping (Meisters, 1975), then removal of
/// diagonals (Hertel and Mehlhorn, 1983), longest first.
std::vector<std::vector<int>> convexPieces(std::span<const Vec2> outline, int maxCorners, std::size_t* looks = nullptr);

} // namespace spacetow
