#pragma once
// The time step of an iteration.

namespace spacetow {

/// Length and position of one iteration in its update. An iteration that is divided into parts has a step for each
/// part.
struct IterationStep {
    double dt;        // s, length of the iteration, or of its part
    double substep;   // s, length of a sub-step: dt / substeps
    int substeps;     // in one iteration, or in one part
    double remaining; // s until the end of the update, including this iteration or part
    int index;        // of the iteration in the update, from 0
    int passes;       // of the velocity solver
};

} // namespace spacetow
