#pragma once
// What is different between two levels, and what a merge could not decide, in words.

#include "core/level/compare.h"
#include "core/level/kept_changes.h"
#include "core/level/merge.h"
#include "editor/panels/form_rows.h"

#include <QString>

#include <span>
#include <string>
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

/// The label of the inspector's row, without what explains it; of a part of a point with the axis, "Position x".
QString fieldName(std::span<const FormRow> rows, const std::string& id);

/// `level` is the merged one.
QString sentence(const MergeConflict& conflict, const Level& level);

} // namespace spacetow
