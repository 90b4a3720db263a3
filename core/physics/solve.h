#pragma once
// The contact solver: sequential impulses (E. Catto, "Iterative Dynamics with Temporal Coherence", 2005), accumulated
// and warm started from the last iteration; the two points of a manifold are solved together. Velocities are
// changed by impulses only; what overlaps is pushed apart by displacement.

#include "core/physics/world_data.h"

namespace spacetow {

/// Impulses so that nothing closes more than its gap within the iteration; sets shift and turn of pushed bodies.
void solveVelocities(WorldData& data, const IterationStep& step);

/// Keeps the impulses for the next iteration and marks the pairs in contact.
void storeImpulses(WorldData& data);

/// Moves apart what overlaps by more than the slop, a part of it an iteration.
void pushOut(WorldData& data, const IterationStep& step);

} // namespace spacetow
