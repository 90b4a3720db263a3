#pragma once
// Connectors: their tension, applied as impulses (kicks) around each sub-step.

#include "core/physics/solver/force_stage.h"

namespace spacetow {

/// Where in an iteration the connectors act: before its first sub-step, between two, after its last. Half the impulse
/// at either end makes the motion of springs second order (velocity Verlet).
enum class Kick : std::uint8_t { First, Between, Last };

/// The time over which explicit forces act in a kick, s; `h` is the length of a sub-step, s.
inline double kickTime(double h, Kick kick) {
    return kick == Kick::Between ? h : 0.5 * h;
}

/// The same for implicit forces: these act over the whole sub-step that follows, and not in the last
/// kick.
inline double kickTime(double h, Kick kick, bool implicit) {
    return implicit ? (kick == Kick::Last ? 0 : h) : kickTime(h, kick);
}

/// Flags bodies that have a connector too stiff for explicit integration with sub-steps of `h` seconds.
void findImplicit(const Bodies& bodies, const Forces& forces, Substeps& substeps, double h);

/// Applies the impulses of one kick, for sub-steps of `h` seconds, at the trial poses; changes velocities only. Damping
/// is implicit, and so is the spring where it is too stiff for the sub-step: the result stays finite and gains no
/// energy.
void applyConnectorForces(const ForceStage& stage, double h, Kick kick);

} // namespace spacetow
