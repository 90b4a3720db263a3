#pragma once
// Guides: lines without an end to draw along. They have no key; an index says which one, in the order of the file.

#include "core/level/level.h"

#include <cstddef>

namespace spacetow {

/// Unit vector along the guide, one way or the other.
Vec2 directionOf(const Guide& guide);
/// Of the point from the line, in metres.
double distanceTo(const Guide& guide, const Vec2& point);
/// The nearest point of the line.
Vec2 footOn(const Guide& guide, const Vec2& point);

Level guideAdded(Level level, const Guide& guide);
/// A level without such a guide comes back as it was.
Level guideReplaced(Level level, std::size_t index, const Guide& guide);
Level guideRemoved(Level level, std::size_t index);
Level guidesCleared(Level level);

} // namespace spacetow
