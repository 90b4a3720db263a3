#pragma once
// What a point was snapped to: for the marker on the canvas and its name. World coordinates, m.

#include "core/level/object_list.h"
#include "core/math/vec.h"

#include <cstdint>
#include <vector>

namespace spacetow {

/// Of equally good ones the first is taken.
enum class SnapKind : std::uint8_t {
    None,
    Vertex,
    Center, // of a circle, of the ship
    Anchor, // of a connector
    Intersection,
    Midpoint,      // of a segment
    Perpendicular, // the foot of one from the point before
    Edge,
    Guide,
    Alignment, // with a side or the middle of another object's bounds
    Angle,     // a multiple of 15° from the point before
    Grid,
};

/// From what was placed to what it is in line with.
struct SnapLine {
    Vec2 from{0, 0};
    Vec2 to{0, 0};
    Key key = 0; // in line with this object

    bool operator==(const SnapLine&) const = default;
};

struct SnapAnswer {
    Vec2 point{0, 0}; // where the point lands
    SnapKind kind = SnapKind::None;
    Vec2 mark{0, 0}; // what it was snapped to; things that are moved may snap by another point of theirs
    Key key = 0;     // the object it belongs to; 0: none
    Key other = 0;   // of an intersection, the second one
    int guide = -1;  // its place in the level; −1: none
    std::vector<SnapLine> lines = {};

    bool operator==(const SnapAnswer&) const = default;
};

} // namespace spacetow
