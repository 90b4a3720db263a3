#pragma once
// Random polygons with their centroid at the origin, metres.

#include "core/base/random.h"
#include "core/geometry/mass.h"
#include "core/geometry/shape.h"

#include <numbers>

namespace spacetow::test {

inline Polygon aroundCentroid(Polygon polygon) {
    const Vec2 center = massOf(Shape(polygon), 1).center;
    for (Vec2& v : polygon.vertices) {
        v -= center;
    }
    return polygon;
}

/// Corners on a circle.
inline Polygon smallConvex(Random& random, double radius) {
    const int count = 3 + static_cast<int>(random.below(5));
    Polygon polygon;
    for (int i = 0; i < count; ++i) {
        const double angle = 2 * std::numbers::pi * (i + random.uniform(-0.35, 0.35)) / count;
        polygon.vertices.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
    }
    return aroundCentroid(polygon);
}

/// Corners far out and near by turns.
inline Polygon smallStar(Random& random, double radius) {
    const int count = 5 + static_cast<int>(random.below(6));
    Polygon polygon;
    for (int i = 0; i < count; ++i) {
        const double angle = 2 * std::numbers::pi * (i + random.uniform(-0.3, 0.3)) / count;
        const double r = radius * (i % 2 == 1 ? random.uniform(0.35, 0.7) : random.uniform(0.8, 1));
        polygon.vertices.emplace_back(r * std::cos(angle), r * std::sin(angle));
    }
    return aroundCentroid(polygon);
}

} // namespace spacetow::test
