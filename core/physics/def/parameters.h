#pragma once
// What an update is made with.

#include "core/math/vec.h"

namespace spacetow {

/// The update loop: each update makes `iterations` passes of motion and collision, each of `substeps` sub-steps of
/// motion, before which the forces of connectors and fields are recomputed.
struct UpdateParameters {
    Vec2 gravity{0, -9.81}; // m/s²
    double seconds = 0.02;  // simulated by one update, > 0
    int iterations = 100;   // ≥ 1
    int substeps = 2;       // an iteration, ≥ 1

    bool operator==(const UpdateParameters&) const = default;
};

} // namespace spacetow
