#pragma once
// The parts of a world that the integration of forces may reach.

#include "core/physics/state/world_data.h"

namespace spacetow {

/// A view that owns nothing, like a span. The integration changes the members that are not const.
struct ForceStage {
    Bodies& bodies;
    Forces& forces;
    const Sleep& sleep;
    Substeps& substeps;

    ForceStage(WorldData& data)
        : bodies(data.bodies), forces(data.forces), sleep(data.sleep), substeps(data.scratch.substeps) {}
};

} // namespace spacetow
