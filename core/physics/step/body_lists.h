#pragma once
// The lists that spare an update a pass over all bodies: the moving bodies, and the tree of static ones.

#include "core/physics/state/world_data.h"

namespace spacetow {

/// Lists the moving bodies. If static bodies have changed, also brings their tree up to date.
void refreshBodyLists(WorldData& data);

} // namespace spacetow
