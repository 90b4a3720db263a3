#pragma once
// Contacts take energy and never add any: impulses that were carried over, a solver that has not converged, restitution
// together with friction, and pushing bodies out of overlaps could otherwise lift a pile or drive a jammed body. What
// a component does depends on no other.

#include "core/physics/solver/solver_stage.h"

namespace spacetow {

/// After the passes, for components to which the contacts' impulses add energy: makes more passes, then makes bounces
/// softer, then takes back a share of the impulses. Components that a moving kinematic body may push are left alone, as
/// that may do any work. Leaves momentum as it is. True when velocities have changed.
bool limitEnergyGain(const SolverStage& stage);

/// Applies the position corrections, but those of shallow overlaps with no more energy than contacts took from
/// their component in this iteration of `dt` seconds.
void applyCorrections(const SolverStage& stage, double dt);

} // namespace spacetow
