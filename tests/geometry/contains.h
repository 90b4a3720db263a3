#pragma once
// Whether a part or a shape contains a point: an oracle for tests, straight from the definitions.

#include "core/geometry/part.h"
#include "core/geometry/polygon.h"
#include "core/math/transform.h"

#include <variant>

namespace spacetow::test {

struct LocalContains {
    Vec2 p; // local

    bool operator()(const Circle& circle) const {
        return (p - circle.center).squaredNorm() <= circle.radius * circle.radius;
    }
    bool operator()(const Edge&) const { return false; }
    bool operator()(const Line&) const { return false; }
    bool operator()(const WallPart&) const { return false; }
    bool operator()(const Polygon& polygon) const { return spacetow::contains(polygon.vertices, p); }
    bool operator()(const ConvexPart& convex) const {
        for (std::size_t i = 0; i < static_cast<std::size_t>(convex.count); ++i) {
            if (convex.normals[i].dot(p - convex.corners[i]) > 0) {
                return false;
            }
        }
        return true;
    }
};

/// Border included; walls contain nothing.
inline bool contains(const Part& part, const Transform& pose, const Vec2& point) {
    return std::visit(LocalContains{pose.toLocal(point)}, part);
}

inline bool contains(const Shape& shape, const Transform& pose, const Vec2& point) {
    return std::visit(LocalContains{pose.toLocal(point)}, shape);
}

} // namespace spacetow::test
