#pragma once
// Looks for what is wrong with a level that could be read. Cheap enough to run after every edit.

#include "core/level/problem.h"

namespace spacetow {

/// In the order of the objects, those of the level itself first. Lines and pointers are left empty.
std::vector<Problem> lint(const Level& level);

} // namespace spacetow
