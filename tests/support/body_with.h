#pragma once
// Objects for tests, in a word.

#include "core/level/level.h"

namespace spacetow::test {

/// A static body with one shape, under the given key.
Object bodyWith(Key key, LevelShape shape, const Vec2& position = {0, 0});

} // namespace spacetow::test
