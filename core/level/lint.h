#pragma once
// Looks for what is wrong with a level that could be read. Cheap enough to run beside the window after every edit: the
// time grows little faster than the number of walls.

#include "core/level/problem.h"

#include <stop_token>

namespace spacetow {

/// In the order of the objects, those of the level itself first. Pointers are those of the file the level would be
/// written to; lines are 0. Problems that the level hides are among them.
/// When a stop is requested, what has been found so far.
std::vector<Problem> lint(const Level& level, const std::stop_token& stop = {});
/// Only what tells whether each object can be built.
std::vector<Problem> buildingProblems(const Level& level);
/// These, and what is wrong with where ship, payload and finish are: for those who try many places.
std::vector<Problem> placingProblems(const Level& level);

/// For each problem whether the author of the level does not want to see it.
std::vector<bool> hiddenAmong(const Level& level, const std::vector<Problem>& problems);
/// Hidden from now on, or shown again.
Level withProblemHidden(Level level, const Problem& problem, bool hidden);

} // namespace spacetow
