#pragma once
// The iterations of one update.

namespace spacetow {

/// What is constant during the iterations of one update.
struct IterationStep {
    double dt;      // s, of one iteration
    double substep; // s
    int substeps;
    double remaining; // s until the end of the update, this iteration included
    int index;
    int passes; // of the velocity solver
};

} // namespace spacetow
