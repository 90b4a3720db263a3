#pragma once
// Distances between parts. A wall is a segment, whatever its depth and sides; cuts of polygons make no difference.
// Metres.

#include "core/geometry/part.h"
#include "core/math/transform.h"

#include <array>

namespace spacetow {

/// A part in world coordinates as a point, a segment or a convex polygon that is grown by `radius`.
struct Core {
    int count = 0; // 1, 2 or 3 … 8 points
    std::array<Vec2, ConvexPart::maxCorners> points;
    std::array<Vec2, ConvexPart::maxCorners> normals; // of polygons: face i, outward
    double radius = 0;                                // m
};

Core coreOf(const Part& part, const Transform& pose);

struct ClosestPoints {
    Vec2 onA{0, 0}; // world, on the surfaces; no meaning when the parts overlap
    Vec2 onB{0, 0};
    Vec2 normal{0, 1};   // unit, from A to B; no meaning when the cores overlap
    double distance = 0; // m, 0 when they overlap or touch
};

ClosestPoints closestPoints(const Part& a, const Transform& poseA, const Part& b, const Transform& poseB);

/// Distance of the cores, 0 when they overlap, and the points on them; the radii play no part.
ClosestPoints closestOfCores(const Core& a, const Core& b);

} // namespace spacetow
