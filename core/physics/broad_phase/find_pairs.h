#pragma once
// The search of the broad phase: which parts of the bodies that have left their fat AABBs are near which others.

#include "core/physics/state/world_data.h"

namespace spacetow {

/// Lists the parts of all moving bodies, all of which then have to be found.
void listProxies(WorldData& data);

/// Gives moved bodies new fat AABBs, large enough for so many seconds.
void enlargeAabbs(WorldData& data, double seconds);

/// Fills `foundPairs` with all pairs of those, sorted as the table is.
void collectPairs(WorldData& data);

} // namespace spacetow
