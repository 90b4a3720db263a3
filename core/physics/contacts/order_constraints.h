#pragma once
// The order in which the solver visits the contacts of a body.

#include "core/physics/state/world_data.h"

namespace spacetow {

/// Sorts the general contacts between each body and static bodies by penetration, the deepest last. The contact that
/// is solved last in a pass is satisfied exactly. In the order of the pair table, a body between two walls would always
/// sink into the same wall, from whichever wall the body came. Other contacts keep their places.
void orderConstraints(const Bodies& bodies, NarrowPhase& narrow);

} // namespace spacetow
