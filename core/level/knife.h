#pragma once
// Cutting with a knife: what the segment crosses comes apart there, within its body. World coordinates, m.

#include "core/level/level.h"

#include <span>
#include <vector>

namespace spacetow {

struct CutLevel {
    Level level;
    std::vector<Vec2> places; // where chains came apart, and the ends of cuts through polygons
};

/// Chains are split where the segment a…b meets them, closed ones opened; polygons fall into two wherever it goes right
/// through them. Circles and polygons that cross themselves stay. Does not look at what is far from the segment.
CutLevel cutAlong(Level level, std::span<const Key> keys, const Vec2& a, const Vec2& b);

} // namespace spacetow
