#pragma once
// Where a polygon is that a wall may meet: over which stretch of it, on which side, whether it is behind.

#include "core/geometry/wall_side.h"

#include <limits>

namespace spacetow {

/// The stretch of a wall that the corners of a polygon are over, and of its prolongation.
struct Extent {
    double from = std::numeric_limits<double>::infinity(); // m from the start of the wall
    double to = -std::numeric_limits<double>::infinity();
};

Extent extentAlong(const WallSide& side, const ConvexPart& convex);

/// On which side of a line a polygon is that its centre is not over: the line and the one that continues it, both
/// prolonged to the centre, may disagree; then what of the polygon is over the line decides.
bool isMostlyOnRight(const WallPart& line, const ConvexPart& convex);

/// Whether the wall stops a part whose centre is behind its face. The parts of a polygon that is inside the depth as a
/// whole belong together, even where some are deeper.
bool isHeld(const WallSide& side, const ConvexPart& convex);

} // namespace spacetow
