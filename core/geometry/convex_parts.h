#pragma once
// Prepares shapes for collision: a circle stays itself, an edge or a line becomes a wall, a polygon becomes convex
// parts. Then finds what continues what, so that nothing is caught where two walls or two parts meet.

#include "core/geometry/part.h"

#include <span>
#include <vector>

namespace spacetow {

/// The parts of a shape, in its own coordinates. None for a polygon that encloses nothing.
std::vector<Part> partsOf(const Shape& shape);

/// Finds the walls that continue one another: all in the same coordinates, ends no further apart than the tolerance of
/// near_points.h, edge to edge in the direction a → b and line to line in either; then, of what is left, edge to line,
/// on the side that is solid on both. Where more than two meet, the straightest pairs are joined. Resets earlier
/// joints. O(n log n); a point where a crowd of walls end joins none.
void joinWalls(std::span<WallPart* const> walls);

/// Finds faces that parts share from one corner on, within the same tolerance: all in the same coordinates. They become
/// inner faces, as if the parts had been cut from one polygon, so that a row of boxes is as smooth as one long box; the
/// longer one of two gets a corner where the other ends. What is beyond the corners of parts is found, too. O(n log n).
void joinConvexParts(std::span<ConvexPart* const> parts);

} // namespace spacetow
