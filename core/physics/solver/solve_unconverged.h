#pragma once
// More velocity iterations for components that have not converged. Each component keeps the order of its contacts, so
// its result does not depend on other components.

#include "core/physics/solver/solver_stage.h"

namespace spacetow {

/// Clears the flag `unconverged` of all components.
void clearUnconverged(const Bodies& bodies, const ContactGraph& graph, SolverScratch& solver);

/// Runs `passes` ≥ 1 more iterations over the components with the flag `unconverged`; all but the last are
/// over-relaxed.
void solveUnconverged(const SolverStage& stage, int passes);

/// Runs more iterations over components in which contacts close faster than their limit: an impact has to reach the
/// ground through the whole heap. Needs the results of measureVelocities. Returns whether any contact still closes too
/// fast.
bool solveClosingComponents(const SolverStage& stage);

/// Bodies whose mass is not that of the contact graph have got another one since: the graph takes it over, and their
/// components are solved until they converge, as the warm-start impulses bore the old weight.
void solveReweighed(const SolverStage& stage);

/// Reserves memory, so that the functions above allocate none; solveReweighed does, and has nothing to do in most
/// updates.
void reserveForUnconverged(const SolverStage& stage);

} // namespace spacetow
