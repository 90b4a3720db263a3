#pragma once
// Limits penetration where the solver has not converged.

#include "core/physics/state/world_data.h"

namespace spacetow {

/// Where the solver has not converged, bodies in contact would still go into each other: they go as far as the slop
/// in this iteration of `dt` seconds, and what follows them waits as well. What is held back is accelerated for as
/// long as it moves. Takes the velocities that were measured at the contacts.
void limitPenetration(Bodies& bodies, const Constraints& constraints, SolverScratch& solver, double dt);

/// Likewise what follows a body that has been stopped on its way since.
void limitPenetrationOfFollowers(Bodies& bodies, const Constraints& constraints, SolverScratch& solver, double dt);

} // namespace spacetow
