#pragma once
// Points, boxes and segments against segments.

#include "core/math/aabb.h"
#include "core/math/vec.h"

#include <optional>

namespace spacetow {

/// The point of the segment a…b nearest to `p`; a segment without length is a point.
Vec2 closestOnSegment(const Vec2& a, const Vec2& b, const Vec2& p);
/// Whether two closed segments share a point; touching ends and overlapping collinear segments count.
bool segmentsMeet(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d);
/// How far along a → b (0 … 1) the segment c…d is met first; nothing when it is not, or when they are parallel
/// and apart. Collinear ones give the first shared point.
std::optional<double> segmentFraction(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d);
/// The point where two segments meet; the first along a → b when they overlap.
std::optional<Vec2> segmentIntersection(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d);

/// Whether the segment a…b and the box share a point; borders count.
bool segmentMeets(const Vec2& a, const Vec2& b, const Aabb& box);

} // namespace spacetow
