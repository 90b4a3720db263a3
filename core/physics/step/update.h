#pragma once
// One update of a world: calls the stages in their order.

#include "core/physics/state/world_data.h"

namespace spacetow {

/// Runs one update. `parameters` apply to this update only; their ranges are checked by World::update.
void updateWorld(WorldData& data, const UpdateParameters& parameters);

} // namespace spacetow
