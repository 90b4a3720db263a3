#pragma once
// Looks for what is wrong with a level that could be read. Cheap enough to run after every edit.

#include "core/level/problem.h"

namespace spacetow {

/// In the order of the objects, those of the level itself first. Pointers are those of the file the level would be
/// written to; lines are 0.
std::vector<Problem> lint(const Level& level);

} // namespace spacetow
