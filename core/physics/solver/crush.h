#pragma once
// What a press pushes against something that stands still: it stays on its side of that, the press overlaps it, and an
// event says that it is crushed.

#include "core/physics/state/world_data.h"

namespace spacetow {

/// A view, as a span is: what it shows may be changed unless it is const here.
struct CrushStage {
    Bodies& bodies;
    const Contacts& contacts;
    const Constraints& constraints;
    const SolverScratch& solver;
    std::vector<BodyId>& crushed;
    Events& events;

    CrushStage(WorldData& data)
        : bodies(data.bodies), contacts(data.contacts), constraints(data.constraints), solver(data.scratch.solver),
          crushed(data.crushed), events(data.events) {}
};

/// Whether a moving kinematic body may push anything. Else nothing is crushed, and the others need not be called.
bool anyPushedByKinematic(const Bodies& bodies, const SolverScratch& solver);

/// Notes which of the bodies that a kinematic one may push leave their fat AABBs by position corrections, or with their
/// platform.
void measureCorrections(Bodies& bodies, StepFlags& flags, const SolverScratch& solver, PairSearch& search);

/// Limits the motion of these bodies, position corrections included: none goes further into what stands still than the
/// slop. A body that is crushed thereby, and was not in the iteration before, is among the events. To be called when
/// the motion is about to be carried out.
void keepOutOfStatics(const CrushStage& stage, int iteration);

} // namespace spacetow
