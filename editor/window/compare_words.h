#pragma once
// What is different in another state of a level, in a few lines for a bar.

#include "core/level/level.h"

#include <QString>

namespace spacetow {

/// A line for each of the first differences; empty when there is none.
QString differencesInWords(const Level& before, const Level& after);

} // namespace spacetow
