#pragma once
// The energy limit: contacts never add energy. Without this limit, warm starting, an unconverged solver, restitution
// with friction, and position correction could lift a pile or drive a jammed body. Each component of the contact graph
// is limited by itself.

#include "core/physics/solver/solver_stage.h"

namespace spacetow {

/// Call it after the velocity iterations. Where the impulses of a component add energy, it runs more iterations, then
/// lowers restitution, then scales the impulses down. It skips components that a moving kinematic body may push, as
/// that body may do any work. Conserves momentum. Returns whether velocities have changed.
bool limitEnergyGain(const SolverStage& stage);

/// Applies the position corrections of an iteration of `dt` seconds. Corrections of shallow overlaps add no more energy
/// to a component than contacts took from it in this iteration.
void applyCorrections(const SolverStage& stage, double dt);

} // namespace spacetow
