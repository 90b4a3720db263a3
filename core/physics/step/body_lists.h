#pragma once
// What an update goes by instead of visiting all bodies: lists of those that move, and the tree of those that do not.

#include "core/physics/state/world_data.h"

namespace spacetow {

/// Lists the moving bodies and, when static bodies have changed, builds their tree anew.
void prepareStructure(WorldData& data);

} // namespace spacetow
