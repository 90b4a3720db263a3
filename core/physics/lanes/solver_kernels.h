#pragma once
// The kernels of the contact solver: passes over all batches, four contacts at a time. SI units.

#include "core/physics/lanes/contact_batches.h"

#include <cstddef>
#include <vector>

namespace spacetow {

/// A strided array by slot: each row begins with four doubles, and is `stride` bytes long. A view.
struct BodyRows {
    const void* first;
    std::size_t stride;
};

/// The body data that refreshContacts reads.
struct BodyViews {
    BodyRows poses;          // centre of mass, cosine and sine
    BodyRows plannedMotions; // delta position, motion of the outermost points by the delta angle, inner radius
};

/// Whether the processor has 256-bit registers. The functions below compute the same bits with and without them.
bool hasWideRegisters();

/// Updates normals, separations, targets, levers and masses for the present poses, and flags outdated contacts.
/// `perSecond` is iterations per second.
void refreshContacts(ContactBatches& batches, const BodyViews& bodies, double perSecond,
                     bool wide = hasWideRegisters());

/// Applies the accumulated impulses. `velocities` is by slot, with one more element for lanes without a contact, here
/// and below.
void warmStart(ContactBatches& batches, std::vector<BodyVelocity>& velocities, bool wide = hasWideRegisters());

/// One velocity iteration over all contacts (projected Gauss–Seidel).
void solvePass(ContactBatches& batches, std::vector<BodyVelocity>& velocities, bool wide = hasWideRegisters());

/// Relaxation factor of overrelaxPass. The best factor is the nearer to 2 the longer a chain of bodies is. A chain of n
/// bodies converges in about n passes with the best factor, in about n² without.
constexpr double overrelaxation = 1.9;

/// One over-relaxed velocity iteration (projected SOR). After the last one, call solvePass once. Only circle contacts
/// are over-relaxed: stacks of polygons with friction would tremble. Source: C. W. Cryer, "The solution of a quadratic
/// programming problem using systematic overrelaxation" (1971).
void overrelaxPass(ContactBatches& batches, std::vector<BodyVelocity>& velocities, bool wide = hasWideRegisters());

/// Stores the normal velocity of each contact, and flags contacts that touch, overlap or close faster than their limit.
/// Returns whether any contact closes too fast.
bool measureVelocities(ContactBatches& batches, std::vector<BodyVelocity>& velocities, bool wide = hasWideRegisters());

/// How position correction works in an iteration of `dt` seconds.
struct CorrectionRules {
    double dt;
    double share; // 0 … 1: of the penetration beyond the slop that is corrected
    double most;  // m: greatest correction of a contact
};

/// Adds pseudo-velocities that reduce overlaps to `corrections`, from the results of measureVelocities: a contact that
/// separates by itself gets less. Returns whether any contact overlaps.
bool correctPositions(ContactBatches& batches, std::vector<BodyVelocity>& corrections, const CorrectionRules& rules,
                      bool wide = hasWideRegisters());

} // namespace spacetow
