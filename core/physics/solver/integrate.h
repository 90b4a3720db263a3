#pragma once
// Integration without contacts: forces, gravity, damping and connectors change the velocities and give the planned
// motion of each body. After the contacts are solved, `advance` moves the bodies.

#include "core/physics/solver/force_stage.h"

namespace spacetow {

/// Computes accelerations and damping factors for this update, and clears the applied forces.
void prepareMotion(Bodies& bodies, const IterationStep& step, const Vec2& gravity);

/// Computes the coefficients of one integration step of each body: an iteration, or a sub-step if connectors act
/// on it. Part of prepareMotion; call it alone after connections have changed during an update.
void prepareSteps(Bodies& bodies, const IterationStep& step);

/// Computes the velocities at the end of the iteration, with delta position and delta angle, without contacts.
void integrateVelocities(const ForceStage& stage, const IterationStep& step);

/// Undoes integrateVelocities.
void restoreVelocities(Bodies& bodies);

/// Applies the planned motions and the position corrections. A body that was stopped at a time of impact in an
/// iteration of `dt` seconds loses the velocity that forces would have added in the rest of it.
void advance(Bodies& bodies, double dt);

/// Deactivates bodies whose state is not finite, before contacts spread it; adds a FaultEvent for each.
void isolateFaults(Bodies& bodies, Events& events, int iteration);

} // namespace spacetow
