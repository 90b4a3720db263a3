#include "tests/support/gaps.h"

#include "core/geometry/intersect.h"
#include "core/geometry/polygon.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace spacetow::test {

namespace {

/// The corners in order; a circle has none.
std::vector<Vec2> cornersOf(const Shape& shape) {
    if (const auto* polygon = std::get_if<Polygon>(&shape)) {
        return polygon->vertices;
    }
    if (const auto* edge = std::get_if<Edge>(&shape)) {
        return {edge->a, edge->b};
    }
    if (const auto* line = std::get_if<Line>(&shape)) {
        return {line->a, line->b};
    }
    return {};
}

} // namespace

std::vector<Vec2> outlinePoints(const Shape& shape, const Transform& pose, double spacing) {
    if (const auto* circle = std::get_if<Circle>(&shape)) {
        return {pose.toWorld(circle->center)};
    }
    const std::vector<Vec2> corners = cornersOf(shape);
    std::vector<Vec2> points;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec2 from = corners[i];
        const Vec2 side = corners[(i + 1) % corners.size()] - from;
        const int pieces = std::max(1, static_cast<int>(std::ceil(side.norm() / spacing)));
        for (int k = 0; k < pieces; ++k) {
            points.push_back(pose.toWorld(from + side * (static_cast<double>(k) / pieces)));
        }
    }
    return points;
}

double lowestAlong(const Shape& shape, const Transform& pose, const Vec2& point, const Vec2& normal) {
    if (const auto* circle = std::get_if<Circle>(&shape)) {
        return normal.dot(pose.toWorld(circle->center) - point) - circle->radius;
    }
    double lowest = std::numeric_limits<double>::infinity();
    for (const Vec2& corner : cornersOf(shape)) {
        lowest = std::min(lowest, normal.dot(pose.toWorld(corner) - point));
    }
    return lowest;
}

double distanceTo(const Shape& shape, const Transform& pose, const Vec2& point) {
    if (const auto* circle = std::get_if<Circle>(&shape)) {
        return (pose.toWorld(circle->center) - point).norm() - circle->radius;
    }
    const Vec2 local = pose.toLocal(point);
    const std::vector<Vec2> corners = cornersOf(shape);
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec2 on = closestOnSegment(corners[i], corners[(i + 1) % corners.size()], local);
        nearest = std::min(nearest, (local - on).norm());
    }
    return std::holds_alternative<Polygon>(shape) && contains(corners, local) ? -nearest : nearest;
}

double overlapDepth(const Shape& a, const Transform& poseA, const Shape& b, const Transform& poseB, double spacing) {
    const auto deepest = [spacing](const Shape& pointed, const Transform& pose, const Shape& solid,
                                   const Transform& solidPose) {
        const auto* circle = std::get_if<Circle>(&pointed);
        double depth = -std::numeric_limits<double>::infinity();
        for (const Vec2& point : outlinePoints(pointed, pose, spacing)) {
            depth = std::max(depth, (circle != nullptr ? circle->radius : 0) - distanceTo(solid, solidPose, point));
        }
        return depth;
    };
    return std::max(deepest(a, poseA, b, poseB), deepest(b, poseB, a, poseA));
}

} // namespace spacetow::test
