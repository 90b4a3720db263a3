#pragma once
// The position of a convex part relative to a wall: extent, side, and whether the wall stops it. Metres.

#include "core/geometry/wall_side.h"

#include <limits>

namespace spacetow {

/// The extent of a polygon along a wall and its prolongation.
struct Extent {
    double from = std::numeric_limits<double>::infinity(); // m, from the start of the wall
    double to = -std::numeric_limits<double>::infinity();
};

Extent extentAlong(const WallSide& side, const ConvexPart& convex);

/// Whether the polygon is on the right of the line. If the line and its neighbour, prolonged to the centre of the
/// polygon, disagree about the side, the stretch of the polygon over the line decides.
bool isMostlyOnRight(const WallPart& line, const ConvexPart& convex);

/// Whether the face of the wall stops the part. The parts of a polygon whose centroid is within the depth are all
/// stopped, even those that are deeper.
bool isHeld(const WallSide& side, const ConvexPart& convex);

} // namespace spacetow
