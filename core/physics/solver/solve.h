#pragma once
// The contact solver: sequential impulses (E. Catto, "Iterative Dynamics with Temporal Coherence", 2005), accumulated
// and warm started from the last iteration; the two points of a manifold are solved together. Velocities are
// changed by impulses only; position correction moves bodies without changing their velocities.

#include "core/physics/solver/solver_stage.h"

namespace spacetow {

/// Solves the contacts: no surfaces close by more than their separation within the iteration. Stores the impulses for
/// the next warm start, flags the pairs in contact, and sets delta position and delta angle of the bodies that contacts
/// pushed, limited where the impulses have not converged, with a share of the position correction.
void solveVelocities(const SolverStage& stage, const IterationStep& step);

} // namespace spacetow
