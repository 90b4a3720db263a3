#pragma once
// What is different in another state of a level, in a few lines for a bar.

#include "core/level/level.h"

#include <QString>

#include <vector>

namespace spacetow {

struct ComparedLevels {
    QString words;         // a line for each of the first differences; empty when there is none
    std::vector<Key> keys; // of what was added or has changed, for the selection
};
ComparedLevels comparedLevels(const Level& before, const Level& after);

} // namespace spacetow
