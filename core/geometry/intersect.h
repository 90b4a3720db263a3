#pragma once
// Intersections of segments with segments and boxes, and the closest point of a segment.

#include "core/math/aabb.h"
#include "core/math/vec.h"

#include <optional>

namespace spacetow {

/// The point of the segment a…b nearest to `p`; a segment without length is a point.
Vec2 closestOnSegment(const Vec2& a, const Vec2& b, const Vec2& p);
/// Whether two closed segments share a point; touching ends and overlapping collinear segments count.
bool segmentsMeet(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d);
/// The fraction of a → b, 0 … 1, at which it first meets the segment c…d; none if they do not meet. Collinear segments
/// give the first shared point.
std::optional<double> segmentFraction(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d);
/// The point where two segments meet; the first along a → b when they overlap.
std::optional<Vec2> segmentIntersection(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d);

/// Whether the segment a…b and the box share a point; borders count.
bool segmentMeets(const Vec2& a, const Vec2& b, const Aabb& box);

} // namespace spacetow
