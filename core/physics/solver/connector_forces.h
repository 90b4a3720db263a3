#pragma once
// The tension of connectors, applied as impulses before each sub-step.

#include "core/physics/solver/force_stage.h"

namespace spacetow {

/// Where in an iteration the connectors act: before its first sub-step, between two, after its last. Half the impulse
/// at either end makes the motion of springs second order (velocity Verlet).
enum class Kick : std::uint8_t { First, Between, Last };

/// For how long what is not anticipated acts, of a sub-step of `h` seconds.
inline double kickTime(double h, Kick kick) {
    return kick == Kick::Between ? h : 0.5 * h;
}

/// The same for what a whole sub-step is anticipated of: nothing is left for the end of the iteration.
inline double kickTime(double h, Kick kick, bool anticipated) {
    return anticipated ? (kick == Kick::Last ? 0 : h) : kickTime(h, kick);
}

/// Notes which bodies have a connector that is too stiff for sub-steps of `h` seconds.
void findAnticipated(const Bodies& bodies, const Forces& forces, Substeps& substeps, double h);

/// The impulses for sub-steps of `h` seconds at the trial poses; changes velocities only. Damping, and the spring
/// itself where it is too stiff for the sub-step, are taken implicitly, so that the result stays finite and gains no
/// energy.
void applyConnectorForces(const ForceStage& stage, double h, Kick kick);

} // namespace spacetow
