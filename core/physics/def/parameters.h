#pragma once
// The parameters of an update. SI units.

#include "core/math/vec.h"

namespace spacetow {

/// An update has `iterations` equal time steps. Each is integrated in `substeps` sub-steps, then collided and solved.
/// The forces of connectors are recomputed before each sub-step.
struct UpdateParameters {
    Vec2 gravity{0, -9.81}; // m/s²
    double seconds = 0.02;  // simulated time of one update, > 0
    int iterations = 100;   // ≥ 1
    int substeps = 2;       // in each iteration, ≥ 1

    bool operator==(const UpdateParameters&) const = default;
};

} // namespace spacetow
