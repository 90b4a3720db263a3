#pragma once
// Prepares shapes for collision: an edge or a line becomes a wall part, a polygon becomes convex parts. Joins walls
// that continue each other and parts that share faces, so that no body is caught at a joint (ghost collisions).

#include "core/geometry/part.h"

#include <span>
#include <vector>

namespace spacetow {

/// The parts of a shape, in its own coordinates. None for a polygon that encloses nothing.
std::vector<Part> partsOf(const Shape& shape);

/// Joins the walls among the parts to each other, and the convex parts to each other, see below.
void joinParts(std::span<Part* const> parts);

/// Joins walls whose ends are within the tolerance of near_points.h: edge to edge in the direction a → b, and line to
/// line in either; then the remaining ends edge to line, on the side that is solid on both. If more than two walls meet
/// at a point, the straightest pairs are joined; more than `jointCrowd` are not joined at all. All walls are in the
/// same coordinates. Resets earlier joints. O(n log n).
void joinWalls(std::span<WallPart* const> walls);

/// Joins parts with faces that lie on each other from a common corner on, within the same tolerance. The common stretch
/// becomes an inner face of both parts, as if they had been cut from one polygon: a row of boxes is as smooth as one
/// long box. The longer face gets a corner where the shorter one ends. Also sets ConvexPart::normalsBeyond. All parts
/// are in the same coordinates. O(n log n).
void joinConvexParts(std::span<ConvexPart* const> parts);

} // namespace spacetow
