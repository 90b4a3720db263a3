#pragma once
// Distances between shapes of tests, worked out from the shapes themselves and not by what the engine collides with.
// Metres.

#include "core/geometry/shape.h"
#include "core/math/transform.h"

#include <vector>

namespace spacetow::test {

/// Points of the outline in the world, no further apart than `spacing`; of a circle its centre alone.
std::vector<Vec2> outlinePoints(const Shape& shape, const Transform& pose, double spacing);

/// How far the shape keeps from the plane through `point`, along its normal; negative when some of it is behind.
double lowestAlong(const Shape& shape, const Transform& pose, const Vec2& point, const Vec2& normal);

/// From a point to the outline; negative inside a circle or polygon.
double distanceTo(const Shape& shape, const Transform& pose, const Vec2& point);

/// How deep the outlines of two solid shapes are in each other at the worst of their points `spacing` apart; 0 or less
/// when they are apart.
double overlapDepth(const Shape& a, const Transform& poseA, const Shape& b, const Transform& poseB, double spacing);

} // namespace spacetow::test
