#pragma once
// What is wrong with the outline of a polygon while it is drawn. World coordinates, m.

#include "core/math/vec.h"

#include <span>

namespace spacetow {

/// Whether all points lie on one line through the first.
bool isFlat(std::span<const Vec2> outline);
/// Whether the side from the last of the points to `next` meets an earlier side anywhere but where it begins. Linear.
bool crossesEarlier(std::span<const Vec2> points, const Vec2& next);

} // namespace spacetow
