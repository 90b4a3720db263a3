#pragma once
// Objects that a point or a box is in line with: upright and level lines through the sides and the middles of others'
// bounds. World coordinates, m.

#include "editor/editing/snap_search.h"

#include <optional>

namespace spacetow {

struct Alignment {
    double value = 0; // m; the coordinate of the line: x of an upright one
    double mine = 0;  // that of the side, middle or point that comes to lie on it
    Key key = 0;      // whose bounds these are
    double far = 0;   // m, the middle of those bounds, along the line
};

/// The nearest line within reach of a side or the middle, of upright ones (axis 0) or level ones (1).
std::optional<Alignment> alignmentOf(const Level& level, const SnapSubject& subject, const SnapQuery& query, int axis,
                                     double reach);

} // namespace spacetow
