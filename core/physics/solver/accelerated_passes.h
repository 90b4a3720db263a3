#pragma once
// Passes over contacts until they have converged. Plain passes (Gauss–Seidel) take thousands where light bodies carry
// heavy ones. Anderson acceleration takes tens: D. G. Anderson, "Iterative Procedures for Nonlinear Integral Equations"
// (1965); H. F. Walker, P. Ni, "Anderson Acceleration for Fixed-Point Iterations" (2011).

#include "core/physics/lanes/contact_batches.h"

#include <span>
#include <vector>

namespace spacetow {

/// All contacts of some batches. The result depends on the order in its last bits.
struct OrderedLanes {
    std::span<const Lane> circles, general;
};

/// Runs at most `most` ≥ 1 passes, fewer once they no longer change the impulses.
void solveUntilConverged(ContactBatches& batches, const OrderedLanes& lanes, std::vector<BodyVelocity>& velocities,
                         int most);

} // namespace spacetow
