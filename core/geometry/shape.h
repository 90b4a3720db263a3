#pragma once
// The four shapes, in local coordinates of their body, metres.

#include "core/math/vec.h"

#include <limits>
#include <variant>
#include <vector>

namespace spacetow {

constexpr double noBack = std::numeric_limits<double>::infinity(); // infinite depth of an edge

struct Circle {
    Vec2 center{0, 0};
    double radius = 1; // > 0

    bool operator==(const Circle&) const = default;
};

/// A one-way wall: it stops bodies that come from the left of a → b, and lets bodies pass from the right unless its
/// depth is infinite. The band of `depth` metres behind the line is inside the wall: a body that was put there is
/// pushed out to the front. Both ends stop bodies from all sides.
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
