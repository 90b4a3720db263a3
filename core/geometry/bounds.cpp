#include "core/geometry/bounds.h"

#include <span>

namespace spacetow {

namespace {

Aabb circleBounds(const Circle& circle, const Transform& pose) {
    const Vec2 center = pose.toWorld(circle.center);
    const Vec2 reach(circle.radius, circle.radius);
    return {center - reach, center + reach};
}

Aabb pointBounds(std::span<const Vec2> points, const Transform& pose) {
    Aabb bounds;
    for (const Vec2& p : points) {
        bounds.include(pose.toWorld(p));
    }
    return bounds;
}

Aabb bandBounds(const Vec2& a, const Vec2& b, double depth, const Transform& pose) {
    const Vec2 along = b - a;
    const double length = along.norm();
    const double reach = std::isfinite(depth) ? depth : noBackReach;
    const Vec2 behind = length > 0 ? Vec2(leftOf(along) * (-reach / length)) : Vec2(0, 0);
    const std::array<Vec2, 4> corners{a, b, a + behind, b + behind};
    return pointBounds(corners, pose);
}

struct BoundsMaker {
    const Transform& pose;

    Aabb operator()(const Circle& circle) const { return circleBounds(circle, pose); }
    Aabb operator()(const Edge& edge) const { return bandBounds(edge.a, edge.b, edge.depth, pose); }
    Aabb operator()(const Line& line) const { return bandBounds(line.a, line.b, 0, pose); }
    Aabb operator()(const Polygon& polygon) const { return pointBounds(polygon.vertices, pose); }
    Aabb operator()(const WallPart& wall) const {
        return bandBounds(wall.a, wall.b, wall.oneWay ? wall.depth : 0, pose);
    }
    Aabb operator()(const ConvexPart& convex) const {
        return pointBounds(std::span(convex.corners).first(static_cast<std::size_t>(convex.count)), pose);
    }
};

} // namespace

Aabb boundsOf(const Shape& shape, const Transform& pose) {
    return std::visit(BoundsMaker{pose}, shape);
}

Aabb boundsOf(const Part& part, const Transform& pose) {
    return std::visit(BoundsMaker{pose}, part);
}

Aabb boundsOf(std::span<const Part> parts, const Transform& pose) {
    Aabb box;
    for (const Part& part : parts) {
        box.include(boundsOf(part, pose));
    }
    return box;
}

Aabb enlargedEdgeBounds(const Aabb& bounds) {
    const Vec2 half = 1.1 * (0.5 * bounds.size() + Vec2(0.1, 0.1));
    return {bounds.center() - half, bounds.center() + half};
}

} // namespace spacetow
