#pragma once
// Solves some components further than others. Each keeps its order of contacts, so that the rest of the world makes no
// difference to it.

#include "core/physics/solver/solver_stage.h"

namespace spacetow {

/// No component is marked as `unconverged`.
void clearUnconverged(const Bodies& bodies, const ContactGraph& graph, const Sleep& sleep, SolverScratch& solver);

/// More passes, at least one, over the contacts of the components that are marked as `unconverged`; all but the last
/// are over-relaxed.
void solveUnconverged(const SolverStage& stage, int passes);

/// More passes over components in which contacts close faster than they may: an impact has to reach the ground through
/// all that is between. Takes what has been measured at the contacts; false when none of them closes any more.
bool solveClosingComponents(const SolverStage& stage);

/// Whenever there is something to solve again, it is not to allocate.
void reserveForUnconverged(const SolverStage& stage);

} // namespace spacetow
