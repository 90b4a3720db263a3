#pragma once
// The tension of connectors, applied as impulses before each sub-step.

#include "core/physics/world_data.h"

namespace spacetow {

/// One sub-step of `h` seconds at the trial poses; changes velocities only. Damping, and the spring itself where it is
/// too stiff for the sub-step, are taken implicitly, so that the result stays finite and gains no energy.
void applyConnectorForces(WorldData& data, double h);

} // namespace spacetow
