#pragma once
// What is different between two levels, and what a merge could not decide, in words.

#include "core/level/compare.h"
#include "core/level/kept_changes.h"
#include "core/level/merge.h"

#include <QString>

#include <vector>

namespace spacetow {

struct DifferenceLine {
    Key object = 0; // 0: the level itself
    ObjectChange change = ObjectChange::Changed;
    QString text; // one line, without a full stop
};

/// In the order of the difference, which is that between the two levels.
std::vector<DifferenceLine> differenceLines(const Level& before, const Level& after, const LevelDifference& difference);

/// One line, without a full stop.
QString changeText(const Level& before, const Level& after, const LevelChange& change);

/// `level` is the merged one.
QString sentence(const MergeConflict& conflict, const Level& level);

} // namespace spacetow
