#pragma once
// Edits of what the bodies of a level are and touch, by tag.

#include "core/level/level.h"

namespace spacetow {

/// Bodies that are `a` come to touch those that are `b`, and the other way round, or cease to.
Level withTagsMeeting(Level level, int a, int b, bool meet);

/// The tags that somebody has written down for an object: what it is, touches, or is not to touch.
TagMask tagsInUse(const Object& object);
TagMask tagsInUse(const Level& level);

} // namespace spacetow
