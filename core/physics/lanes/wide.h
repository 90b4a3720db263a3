#pragma once
// Numbers four at a time, as one instruction of the processor takes them, and velocities laid out for that.

#include <cstdint>

namespace spacetow {

/// Where a body is in the arrays.
using Slot = std::uint32_t;

/// Four doubles; the compiler uses what registers the processor has.
using Wide = double __attribute__((vector_size(32), aligned(32)));

/// Lanes of which something is true.
using Mask = decltype(Wide{} < Wide{});

/// A velocity while contacts are solved: what four of them are loaded as.
struct alignas(32) BodyVelocity {
    double x = 0, y = 0; // velocity, m/s
    double angular = 0;  // rad/s
    double padding = 0;
};

} // namespace spacetow
