#pragma once
// What a moving kinematic body stops goes on with it.

#include "core/physics/state/world_data.h"

namespace spacetow {

/// Whatever stops a body that touches a kinematic one stops it on its way with that.
void findCarriers(Bodies& bodies, const PairTable& table, const Constraints& constraints);

/// What was stopped by a kinematic body stays where it is on it while that goes on.
void carryStopped(Bodies& bodies);

} // namespace spacetow
