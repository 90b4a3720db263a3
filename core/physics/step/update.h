#pragma once
// One update of a world: calls the stages in their order.

#include "core/physics/state/world_data.h"

namespace spacetow {

void updateWorld(WorldData& data, const UpdateParameters& parameters);

} // namespace spacetow
