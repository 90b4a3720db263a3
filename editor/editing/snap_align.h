#pragma once
// Objects that a point or a box is in line with: upright and level lines through the sides and the middles of others'
// bounds, and through the places of ship and payload, whose rims nobody builds by. World coordinates, m.

#include "editor/editing/snap_search.h"

#include <optional>

namespace spacetow {

struct Alignment {
    double value = 0; // m; the coordinate of the line: x of an upright one
    double mine = 0;  // that of the side, middle or point that comes to lie on it
    Key key = 0;      // whose bounds these are
    double far = 0;   // m, the middle of those bounds, along the line
};

constexpr double calm = 0.5; // of the reach: within this what is everywhere draws, alignments and angles

/// What of the bounds of something is aligned.
Aabb alignedBox(const Object& object, const Aabb& bounds);

/// The nearest line within reach of a side or the middle, of upright ones (axis 0) or level ones (1). Where the grid
/// is on, a line beside it draws only where it is nearer than the grid, and not within a few pixels of it.
std::optional<Alignment> alignmentOf(const Level& level, const SnapSettings& settings, const SnapSubject& subject,
                                     const SnapQuery& query, int axis);

} // namespace spacetow
