#pragma once
// What the update of contacts works on.

#include "core/physics/state/world_data.h"

namespace spacetow {

/// A view, as a span is: what it shows may be changed unless it is const here.
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
