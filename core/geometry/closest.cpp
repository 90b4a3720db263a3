#include "core/geometry/closest.h"

#include "core/geometry/intersect.h"

#include <limits>

namespace spacetow {

namespace {

struct CoreMaker {
    const Transform& pose;

    Core operator()(const Circle& circle) const {
        Core core;
        core.count = 1;
        core.points[0] = pose.toWorld(circle.center);
        core.radius = circle.radius;
        return core;
    }
    Core operator()(const WallPart& wall) const {
        Core core;
        core.count = 2;
        core.points[0] = pose.toWorld(wall.a);
        core.points[1] = pose.toWorld(wall.b);
        return core;
    }
    Core operator()(const ConvexPart& convex) const {
        Core core;
        core.count = convex.count;
        for (std::size_t i = 0; i < static_cast<std::size_t>(convex.count); ++i) {
            core.points[i] = pose.toWorld(convex.corners[i]);
            core.normals[i] = pose.rotation * convex.normals[i];
        }
        return core;
    }
};

const Vec2& pointOf(const Core& core, int i) {
    return core.points[static_cast<std::size_t>(i)];
}
const Vec2& normalOf(const Core& core, int i) {
    return core.normals[static_cast<std::size_t>(i)];
}

/// Whether some face of the polygon has all of `other` in front of it.
bool hasSeparatingFace(const Core& polygon, const Core& other) {
    for (int i = 0; i < polygon.count; ++i) {
        double least = std::numeric_limits<double>::infinity();
        for (int k = 0; k < other.count; ++k) {
            least = std::min(least, normalOf(polygon, i).dot(pointOf(other, k) - pointOf(polygon, i)));
        }
        if (least > 0) {
            return true;
        }
    }
    return false;
}

/// Whether all of the polygon lies on one side of the line through the segment.
bool isBesideLine(const Core& segment, const Core& polygon) {
    const Vec2 along = pointOf(segment, 1) - pointOf(segment, 0);
    bool left = true;
    bool right = true;
    for (int i = 0; i < polygon.count; ++i) {
        const double side = cross(along, pointOf(polygon, i) - pointOf(segment, 0));
        left = left && side > 0;
        right = right && side < 0;
    }
    return left || right;
}

bool coresOverlap(const Core& a, const Core& b) {
    if (a.count < 3 && b.count < 3) {
        return a.count == 2 && b.count == 2 && segmentsMeet(pointOf(a, 0), pointOf(a, 1), pointOf(b, 0), pointOf(b, 1));
    }
    if ((a.count >= 3 && hasSeparatingFace(a, b)) || (b.count >= 3 && hasSeparatingFace(b, a))) {
        return false;
    }
    return !(a.count == 2 && isBesideLine(a, b)) && !(b.count == 2 && isBesideLine(b, a));
}

struct NearestPoints {
    double squared = std::numeric_limits<double>::infinity(); // m²
    Vec2 onA{0, 0}, onB{0, 0};
};

/// Looks at the points of `part` over the sides of `sides`.
void includePoints(const Core& sides, const Core& part, bool sidesAreA, NearestPoints& nearest) {
    const int sideCount = sides.count == 2 ? 1 : sides.count;
    for (int i = 0; i < sideCount; ++i) {
        const Vec2& from = pointOf(sides, i);
        const Vec2& to = pointOf(sides, i + 1 < sides.count ? i + 1 : 0);
        for (int k = 0; k < part.count; ++k) {
            const Vec2& p = pointOf(part, k);
            const Vec2 on = closestOnSegment(from, to, p);
            const double squared = (p - on).squaredNorm();
            if (squared < nearest.squared) {
                nearest = {squared, sidesAreA ? on : p, sidesAreA ? p : on};
            }
        }
    }
}

} // namespace

Core coreOf(const Part& part, const Transform& pose) {
    return std::visit(CoreMaker{pose}, part);
}

ClosestPoints closestOfCores(const Core& a, const Core& b) {
    ClosestPoints closest;
    if (coresOverlap(a, b)) {
        return closest;
    }
    NearestPoints nearest;
    includePoints(a, b, true, nearest);
    includePoints(b, a, false, nearest);
    closest.onA = nearest.onA;
    closest.onB = nearest.onB;
    closest.distance = std::sqrt(nearest.squared);
    if (closest.distance > 0) {
        closest.normal = (closest.onB - closest.onA) / closest.distance;
    }
    return closest;
}

ClosestPoints closestPoints(const Part& a, const Transform& poseA, const Part& b, const Transform& poseB) {
    const Core coreA = coreOf(a, poseA);
    const Core coreB = coreOf(b, poseB);
    ClosestPoints closest = closestOfCores(coreA, coreB);
    closest.onA += coreA.radius * closest.normal;
    closest.onB -= coreB.radius * closest.normal;
    closest.distance = std::max(0.0, closest.distance - (coreA.radius + coreB.radius));
    return closest;
}

} // namespace spacetow
