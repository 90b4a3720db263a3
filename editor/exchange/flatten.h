#pragma once
// Curves as straight segments that stray from them by no more than a tolerance. Any unit of length.

#include "editor/exchange/drawing.h"

namespace spacetow {

/// The vertices of the path, ends included, each within rounding of a point of it; no point of the path is further than
/// `tolerance` (> 0) from the segments. Of a closed path the last vertex joins the first. Nothing when there would be
/// more than `most`.
std::optional<std::vector<Vec2>> flattened(const DrawnPath& path, double tolerance, int most);

} // namespace spacetow
