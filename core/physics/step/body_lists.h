#pragma once
// The lists that spare an update a pass over all bodies: the moving bodies, and the tree of static ones.

#include "core/physics/state/world_data.h"

namespace spacetow {

/// Updates the lists of bodies if bodies have changed, and the static geometry if static bodies have changed. Resizes
/// the arrays by slot.
void refreshBodyLists(WorldData& data);

} // namespace spacetow
