#pragma once
// Nothing is passed through: bodies that would move further in an iteration than anticipation covers are swept along
// their way and stop at the first thing they would hit. The contact itself is solved in the next iteration.

#include "core/physics/world_data.h"

namespace spacetow {

/// Shortens the motion (BodyStep::fraction) of swept bodies.
void stopAtImpacts(WorldData& data);

} // namespace spacetow
