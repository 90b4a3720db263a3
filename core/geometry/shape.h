#pragma once
// The four shapes, in the local coordinates of what carries them (metres).

#include "core/math/vec.h"

#include <limits>
#include <variant>
#include <vector>

namespace spacetow {

constexpr double noBack = std::numeric_limits<double>::infinity(); // depth of an edge that is solid all the way

struct Circle {
    Vec2 center{0, 0};
    double radius = 1; // > 0

    bool operator==(const Circle&) const = default;
};

/// A one-way wall: solid for what comes from the left of a→b, open from behind. `depth` metres behind the
/// line count as inside the wall; what is deeper is not touched. Both ends stop what runs into them.
struct Edge {
    Vec2 a{0, 0};
    Vec2 b{1, 0};
    double depth = noBack; // ≥ 0, may be `noBack`

    bool operator==(const Edge&) const = default;
};

/// A wall that is solid from both sides.
struct Line {
    Vec2 a{0, 0};
    Vec2 b{1, 0};

    bool operator==(const Line&) const = default;
};

/// Simple and anticlockwise, may be concave; at least three vertices.
struct Polygon {
    std::vector<Vec2> vertices;

    bool operator==(const Polygon&) const = default;
};

using Shape = std::variant<Circle, Edge, Line, Polygon>;

} // namespace spacetow
