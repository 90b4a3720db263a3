#pragma once
// Solves some islands further than others. Each keeps its order of contacts, so that the rest of the world makes no
// difference to it.

#include "core/physics/solver/solver_stage.h"

namespace spacetow {

/// No island is marked as `unconverged`.
void clearUnconverged(const Bodies& bodies, const Islands& islands, const Sleep& sleep, SolverScratch& solver);

/// More passes, at least one, over the contacts of the islands that are marked as `unconverged`; all but the last are
/// over-relaxed.
void solveUnconverged(const SolverStage& stage, int passes);

/// More passes over islands in which contacts close faster than they may: an impact has to reach the ground through all
/// that is between. Takes what has been measured at the contacts; false when none of them closes any more.
bool solveClosingIslands(const SolverStage& stage);

/// Whenever there is something to solve again, it is not to allocate.
void reserveForUnconverged(const SolverStage& stage);

} // namespace spacetow
