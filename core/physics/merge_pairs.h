#pragma once
// From the pairs that the broad phase has found to the table of pairs.

#include "core/physics/world_data.h"

namespace spacetow {

/// Both are sorted. Old pairs of bodies that stayed in their rooms remain; the others must have been found again.
/// Returns whether the table has changed.
bool mergePairs(WorldData& data);

} // namespace spacetow
