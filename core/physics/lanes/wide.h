#pragma once
// SIMD vectors of four doubles, and body velocities in the layout that the kernels load.

#include <cstdint>

namespace spacetow {

/// The index of a body in the arrays.
using Slot = std::uint32_t;

/// Four doubles; on processors without 256-bit registers the compiler splits them.
using Wide = double __attribute__((vector_size(32), aligned(32)));

/// One all-ones or all-zeros integer a lane, as a comparison of two Wides gives.
using Mask = decltype(Wide{} < Wide{});

/// The velocity of a body in the solver: one row of a gather.
struct alignas(32) BodyVelocity {
    double x = 0, y = 0; // velocity, m/s
    double angular = 0;  // rad/s
    double padding = 0;
};

} // namespace spacetow
