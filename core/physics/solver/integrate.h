#pragma once
// Motion without contacts: forces, gravity, damping and connectors change the velocities and say how far each body
// would go; after the contacts are solved the bodies are advanced.

#include "core/physics/solver/force_stage.h"

namespace spacetow {

/// Accelerations and damping factors for this update; consumes the forces applied since the last one.
void prepareMotion(Bodies& bodies, const IterationStep& step, const Vec2& gravity);

/// How far a body moves by itself in one step of its own: an iteration, or a sub-step when connectors or fields act on
/// it. Part of prepareMotion; by itself after connections have changed in the middle of an update.
void prepareSteps(Bodies& bodies, const IterationStep& step);

/// Velocities at the end of the iteration, and delta position and angle on the way there, as if nothing were touched.
void integrateVelocities(const ForceStage& stage, const IterationStep& step);

/// Undoes integrateVelocities.
void restoreVelocities(Bodies& bodies);

/// Carries out the motion and the displacements out of overlaps. A body that was stopped on its way, in an iteration
/// of `dt` seconds, gives back the velocity that the rest of the way would have added.
void advance(Bodies& bodies, double dt);

/// Switches off bodies whose state is not sound, so that they spoil no others.
void isolateFaults(Bodies& bodies, Events& events, int iteration);

} // namespace spacetow
