#pragma once
// In which order the solver meets the contacts of a body.

#include "core/physics/state/world_data.h"

namespace spacetow {

/// Puts the contacts of each body with static ones in the order of their depths, the deepest last: what is solved last
/// comes out right. In the order of the surfaces what lies between two of them would go to the same one always,
/// whichever it comes from.
void orderConstraints(const Bodies& bodies, NarrowPhase& narrow);

} // namespace spacetow
