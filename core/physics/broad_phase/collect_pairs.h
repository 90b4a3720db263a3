#pragma once
// The broad phase's search: which parts of the bodies that have left their rooms are near which others.

#include "core/physics/state/world_data.h"

namespace spacetow {

/// Lists the parts of all moving bodies, all of which then have to be found.
void listColliders(WorldData& data);

/// Gives those who have left their rooms new ones, for so many seconds.
void giveRoom(WorldData& data, double seconds);

/// Fills `foundPairs` with all pairs of those, sorted as the table is.
void collectPairs(WorldData& data);

} // namespace spacetow
