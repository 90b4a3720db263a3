#pragma once
// Walls in a row and what touches them.

#include "core/geometry/collide.h"
#include "core/geometry/convex_parts.h"
#include "tests/geometry/random_parts.h"

#include <limits>
#include <vector>

namespace spacetow::test {

inline constexpr double inf = std::numeric_limits<double>::infinity();

/// A chain of walls through the points, joined.
inline std::vector<Part> chain(const std::vector<Vec2>& points, bool oneWay, double depth = inf) {
    std::vector<Part> parts;
    for (std::size_t i = 1; i < points.size(); ++i) {
        parts.push_back(oneWay ? edge(points[i - 1], points[i], depth) : line(points[i - 1], points[i]));
    }
    std::vector<WallPart*> walls;
    for (Part& part : parts) {
        walls.push_back(&std::get<WallPart>(part));
    }
    joinWalls(walls);
    return parts;
}

inline std::vector<Manifold> contacts(const std::vector<Part>& walls, const Part& body, const Transform& pose,
                                      double margin) {
    std::vector<Manifold> result;
    for (const Part& wall : walls) {
        const Manifold manifold = collide(wall, {}, body, pose, margin);
        if (manifold.count > 0) {
            result.push_back(manifold);
        }
    }
    return result;
}

inline Part ball(double radius) {
    return Circle{Vec2(0, 0), radius};
}

} // namespace spacetow::test
