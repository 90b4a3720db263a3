#pragma once
// Which pairs the narrow phase has to look at.

#include "core/physics/state/world_data.h"

namespace spacetow {

/// Fills `open` with the pairs that are not listed and may come into contact in this iteration. The gates of those of
/// which nothing is known, and the discs around whose bodies do not meet in it, are shut again at once.
void listOpen(WorldData& data);

} // namespace spacetow
