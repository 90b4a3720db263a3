#pragma once
// What the solver works on.

#include "core/physics/state/world_data.h"

namespace spacetow {

/// A view, as a span is: what it shows may be changed unless it is const here.
struct SolverStage {
    Bodies& bodies;
    Contacts& contacts;
    Constraints& constraints;
    ContactGraph& graph;
    const Sleep& sleep;
    ImpulseLog& impulses;
    StepFlags& flags;
    SolverScratch& solver;

    SolverStage(WorldData& data)
        : bodies(data.bodies), contacts(data.contacts), constraints(data.constraints), graph(data.contactGraph),
          sleep(data.sleep), impulses(data.impulses), flags(data.flags), solver(data.scratch.solver) {}
};

} // namespace spacetow
