#pragma once
// The passes of the contact solver over batches, four contacts at a time.

#include "core/physics/lanes/contact_batches.h"

#include <cstddef>
#include <vector>

namespace spacetow {

/// Where something is kept of each body, by slot: four doubles at the beginning of `stride` bytes each.
struct BodyRows {
    const void* first;
    std::size_t stride;
};

/// From what contacts are made anew.
struct BodyViews {
    BodyRows poses;          // centre of mass, cosine and sine
    BodyRows plannedMotions; // delta position, motion of the outermost points by the delta angle, inner radius
};

/// Whether the processor has registers for four doubles. What follows computes the same bits with them and without.
bool hasWideRegisters();

/// Normals, gaps, targets and what depends on them, from where bodies are now; and notes of what is outdated.
/// Iterations come `perSecond`.
void refreshContacts(ContactBatches& batches, const BodyViews& bodies, double perSecond,
                     bool wide = hasWideRegisters());

/// Applies the impulses that the contacts begin with. Velocities are those of bodies, by slot, and one more for lanes
/// without a contact; here and below.
void warmStart(ContactBatches& batches, std::vector<BodyVelocity>& velocities, bool wide = hasWideRegisters());

/// One pass over all contacts.
void solvePass(ContactBatches& batches, std::vector<BodyVelocity>& velocities, bool wide = hasWideRegisters());

/// How far single points are pushed apart in an over-relaxed pass, as a multiple of what stops them. The best one is
/// the nearer to 2 the longer a chain of bodies is; a chain of n is solved by some n passes with it, by some n²
/// without.
constexpr double overrelaxation = 1.9;

/// One over-relaxed pass, for where many follow each other; the last is to be an ordinary one. Contacts of polygons are
/// solved as ever: their friction would keep stacks trembling. C. W. Cryer, "The solution of a quadratic programming
/// problem using systematic overrelaxation" (1971).
void overrelaxPass(ContactBatches& batches, std::vector<BodyVelocity>& velocities, bool wide = hasWideRegisters());

/// The normal velocities that are left, and notes of what touches, what overlaps and what closes faster than it may.
/// Whether anything does.
bool measureVelocities(ContactBatches& batches, std::vector<BodyVelocity>& velocities, bool wide = hasWideRegisters());

/// How overlaps are reduced in an iteration of `dt` seconds.
struct CorrectionRules {
    double dt;
    double share; // of what is more than the slop
    double most;  // m
};

/// Adds what pushes bodies out of overlaps to `corrections`, by the measured velocities and flags: what parts anyway is
/// pushed less. Whether anything overlaps.
bool correctPositions(ContactBatches& batches, std::vector<BodyVelocity>& corrections, const CorrectionRules& rules,
                      bool wide = hasWideRegisters());

} // namespace spacetow
