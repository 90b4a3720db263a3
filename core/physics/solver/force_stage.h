#pragma once
// What the integration of forces works on.

#include "core/physics/state/world_data.h"

namespace spacetow {

/// A view, as a span is: what it shows may be changed unless it is const here.
struct ForceStage {
    Bodies& bodies;
    Forces& forces;
    const Sleep& sleep;
    Events& events;
    Substeps& substeps;

    ForceStage(WorldData& data)
        : bodies(data.bodies), forces(data.forces), sleep(data.sleep), events(data.events),
          substeps(data.scratch.substeps) {}
};

} // namespace spacetow
