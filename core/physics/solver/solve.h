#pragma once
// The contact solver: sequential impulses (E. Catto, "Iterative Dynamics with Temporal Coherence", 2005), accumulated
// and warm started from the last iteration; the two points of a manifold are solved together. Velocities are
// changed by impulses only; what overlaps is pushed apart by displacement.

#include "core/physics/solver/solver_stage.h"

namespace spacetow {

/// Impulses so that nothing closes more than its gap within the iteration. Keeps them for the next one, marks the pairs
/// in contact, and sets the motion of the pushed bodies: delta position and angle by their new velocities, not further
/// than the surfaces allow where the impulses have not converged, and a part of the way out of overlaps.
void solveVelocities(const SolverStage& stage, const IterationStep& step);

} // namespace spacetow
