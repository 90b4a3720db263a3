#pragma once
// Moving platforms: a body that a moving kinematic body stops moves on with that body.

#include "core/physics/state/world_data.h"

namespace spacetow {

/// Finds the platform of each body: the kinematic body that it touches. A body that is stopped later is stopped
/// relative to its platform.
void findPlatforms(Bodies& bodies, const PairTable& table, const Constraints& constraints);

/// Moves stopped bodies on with their platforms, for the rest of the iteration.
void moveWithPlatforms(Bodies& bodies);

} // namespace spacetow
