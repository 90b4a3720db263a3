#pragma once
// Crushing: a kinematic body presses a body against an immovable one. The pressed body stays in front of the immovable
// one, the kinematic body overlaps it, and a CrushedEvent reports it.

#include "core/physics/state/world_data.h"

namespace spacetow {

/// A view that owns nothing, like a span. Crushing changes the members that are not const.
struct CrushStage {
    Bodies& bodies;
    const BroadPhase& broadPhase;
    const Contacts& contacts;
    const Constraints& constraints;
    const Sleep& sleep;
    const SolverScratch& solver;
    std::vector<BodyId>& crushed;
    Events& events;

    CrushStage(WorldData& data)
        : bodies(data.bodies), broadPhase(data.broadPhase), contacts(data.contacts), constraints(data.constraints),
          sleep(data.sleep), solver(data.scratch.solver), crushed(data.crushed), events(data.events) {}
};

/// Whether a moving kinematic body may push any body, and there is an immovable body to push it against. If not,
/// nothing is crushed: skip the functions below.
bool mayCrush(const CrushStage& stage);

/// Collects the moved proxies among the bodies that a kinematic body may push: position correction or their platform
/// moves them out of their fat AABBs.
void findDisplaced(Bodies& bodies, StepFlags& flags, const SolverScratch& solver, PairSearch& search);

/// Limits the motion of these bodies, position correction included, so that none penetrates an immovable body by more
/// than the slop. Adds a CrushedEvent for each body that is crushed and was not in the last iteration. Call it directly
/// before `advance`.
void keepOutOfStatics(const CrushStage& stage, int iteration);

} // namespace spacetow
