#pragma once
// Cures for what lint finds. Each is an edit like any other: a function Level → Level that leaves all else as it is.
// Those that are safe change nothing that was meant: they may be carried out together, unseen.

#include "core/level/problem.h"

#include <span>
#include <stop_token>

namespace spacetow {

struct Fix {
    LevelCode problem; // what it cures
    FixCode label;     // what the edit is called
    bool isSafe = false;
    bool isWhole = false; // cures all problems of its kind that the object has
    Level (*apply)(Level level, const Problem& problem);
};

std::span<const Fix> fixes();
/// Null when nobody but the author can tell what to do.
const Fix* fixFor(const Problem& problem);
/// The level as it is when there is no fix, or the problem is one of another level.
Level fixed(Level level, const Problem& problem);

struct FixedLevel {
    Level level;
    std::vector<Problem> cured; // in the order in which they were
};
/// All safe fixes, of what is not hidden, until there is nothing left that they cure.
FixedLevel withSafeFixes(Level level, const std::stop_token& stop = {});

} // namespace spacetow
