#pragma once
// Looks for what is wrong with a level that could be read. Cheap enough to run after every edit.

#include "core/level/problem.h"

#include <stop_token>

namespace spacetow {

/// In the order of the objects, those of the level itself first. Pointers are those of the file the level would be
/// written to; lines are 0.
/// When a stop is requested, what has been found so far.
std::vector<Problem> lint(const Level& level, const std::stop_token& stop = {});

} // namespace spacetow
