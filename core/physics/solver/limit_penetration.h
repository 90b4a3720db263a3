#pragma once
// Limits penetration where the solver has not converged.

#include "core/physics/state/world_data.h"

namespace spacetow {

/// Scales down the motion of bodies whose contacts still close, so that they penetrate by no more than the slop in this
/// iteration of `dt` seconds, and the motion of the bodies that follow them. Forces accelerate such a body only for the
/// share of the iteration in which it moves. Needs the results of measureVelocities.
void limitPenetration(Bodies& bodies, const Constraints& constraints, SolverScratch& solver, double dt);

/// The same for bodies that follow a body which has been stopped at a time of impact since.
void limitPenetrationOfFollowers(Bodies& bodies, const Constraints& constraints, SolverScratch& solver, double dt);

} // namespace spacetow
