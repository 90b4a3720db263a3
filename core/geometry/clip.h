#pragma once
// Clips an incident face to the strip over a reference face: the ends of the rest are the contact points.

#include "core/math/vec.h"

#include <array>

namespace spacetow {

struct ClippedPoint {
    Vec2 point{0, 0};
    int cutAt = -1; // −1: not clipped; 0: clipped at the start of the face; 1: clipped at its end
};

struct ClippedSegment {
    std::array<ClippedPoint, 2> points; // in the order of the segment's ends
    int count = 0;                      // 0 or 2
};

/// The part of the segment p…q over the face that starts at `start` and runs `length` metres along the unit vector
/// `direction`.
ClippedSegment clipToFace(const Vec2& start, const Vec2& direction, double length, const std::array<Vec2, 2>& segment);

} // namespace spacetow
