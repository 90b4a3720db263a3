#pragma once
// Random parts and poses for tests of properties, and the transformations that must not change an answer.

#include "core/base/random.h"
#include "core/geometry/convex_parts.h"
#include "core/geometry/polygon.h"
#include "core/math/transform.h"

#include <cmath>
#include <numbers>

namespace spacetow::test {

inline Vec2 randomPoint(Random& random, double reach) {
    const double x = random.uniform(-reach, reach);
    return {x, random.uniform(-reach, reach)};
}

inline Transform randomPose(Random& random, double reach) {
    const Vec2 position = randomPoint(random, reach);
    return {position, Rot::fromAngle(random.uniform(-4, 4))};
}

/// Convex, 3 … 8 corners on an ellipse, centred near `center`.
inline ConvexPart randomConvex(Random& random, const Vec2& center = Vec2(0, 0)) {
    for (;;) {
        const int count = 3 + static_cast<int>(random.below(6));
        const double width = random.uniform(0.2, 1.5);
        const double height = random.uniform(0.2, 1.5);
        Polygon polygon;
        for (int i = 0; i < count; ++i) {
            const double angle = 2 * std::numbers::pi * (i + random.uniform(0, 0.7)) / count;
            polygon.vertices.push_back(center + Vec2(width * std::cos(angle), height * std::sin(angle)));
        }
        const std::vector<Part> parts = partsOf(polygon);
        if (parts.size() == 1) {
            return std::get<ConvexPart>(parts[0]);
        }
    }
}

inline WallPart randomWall(Random& random) {
    WallPart wall;
    wall.a = randomPoint(random, 1);
    wall.b = wall.a + Rot::fromAngle(random.uniform(-4, 4)) * Vec2(random.uniform(0.3, 2), 0);
    wall.oneWay = random.below(2) == 0;
    wall.depth = wall.oneWay ? random.uniform(0, 0.6) : 0;
    return wall;
}

inline Part randomPart(Random& random) {
    switch (random.below(3)) {
    case 0: {
        const Vec2 center = randomPoint(random, 0.3);
        return Circle{center, random.uniform(0.1, 1)};
    }
    case 1:
        return randomWall(random);
    default:
        return randomConvex(random, randomPoint(random, 0.3));
    }
}

inline Part box(double halfWidth, double halfHeight, const Vec2& center = Vec2(0, 0)) {
    Polygon polygon;
    polygon.vertices = {center + Vec2(-halfWidth, -halfHeight), center + Vec2(halfWidth, -halfHeight),
                        center + Vec2(halfWidth, halfHeight), center + Vec2(-halfWidth, halfHeight)};
    return partsOf(polygon)[0];
}

inline Part edge(const Vec2& a, const Vec2& b, double depth = noBack) {
    return partsOf(Edge{a, b, depth})[0];
}
inline Part line(const Vec2& a, const Vec2& b) {
    return partsOf(Line{a, b})[0];
}

inline bool isNear(const Vec2& a, const Vec2& b, double tolerance = 1e-9) {
    return (a - b).norm() <= tolerance;
}
inline bool isNear(double a, double b, double tolerance = 1e-9) {
    return std::fabs(a - b) <= tolerance;
}

/// The pose of something after everything has been moved by `by`.
inline Transform carried(const Transform& by, const Transform& pose) {
    return {by.toWorld(pose.position), by.rotation * pose.rotation};
}

} // namespace spacetow::test
