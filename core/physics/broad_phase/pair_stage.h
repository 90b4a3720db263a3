#pragma once
// The parts of a world that the search for pairs may reach.

#include "core/physics/state/world_data.h"

namespace spacetow {

/// A view that owns nothing, like a span. The search changes the members that are not const.
struct PairStage {
    Bodies& bodies;
    const Forces& forces;
    BroadPhase& broadPhase;
    Contacts& contacts;
    const Sleep& sleep;
    StepFlags& flags;
    PairSearch& search;
    PairChanges& changes;

    PairStage(WorldData& data)
        : bodies(data.bodies), forces(data.forces), broadPhase(data.broadPhase), contacts(data.contacts),
          sleep(data.sleep), flags(data.flags), search(data.scratch.search), changes(data.scratch.changes) {}
};

} // namespace spacetow
