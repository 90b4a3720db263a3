#pragma once
// What is said of a crash: who hit what.

#include "core/game/snapshot.h"

#include <QString>

namespace spacetow {

/// A sentence by the names that objects and tags have in the level; empty where it is not known.
QString crashWords(const Loss& loss, const Level& level);

} // namespace spacetow
