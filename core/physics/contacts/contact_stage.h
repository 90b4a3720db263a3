#pragma once
// The parts of a world that the narrow phase may reach.

#include "core/physics/state/world_data.h"

namespace spacetow {

/// A view that owns nothing, like a span. The narrow phase changes the members that are not const.
struct ContactStage {
    Bodies& bodies;
    const BroadPhase& broadPhase;
    Contacts& contacts;
    Constraints& constraints;
    StepFlags& flags;
    const PairChanges& changes;
    NarrowPhase& narrow;

    ContactStage(WorldData& data)
        : bodies(data.bodies), broadPhase(data.broadPhase), contacts(data.contacts), constraints(data.constraints),
          flags(data.flags), changes(data.scratch.changes), narrow(data.scratch.narrow) {}
};

} // namespace spacetow
