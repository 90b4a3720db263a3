#pragma once
// Moving platforms: what a moving kinematic body stops goes on with it.

#include "core/physics/state/world_data.h"

namespace spacetow {

/// Notes the kinematic body that a body touches: whatever stops the body stops it on its way with that.
void findPlatforms(Bodies& bodies, const PairTable& table, const Constraints& constraints);

/// What was stopped by a kinematic body stays where it is on it while that goes on.
void moveWithPlatforms(Bodies& bodies);

} // namespace spacetow
