#pragma once
// Gather and scatter of four bodies, and the operations of the kernels. All functions are inlined into kernels that are
// compiled twice, for processors with and without 256-bit registers. Both kernels compute the same bits: the operations
// are the same, and none is fused.

#include "core/physics/lanes/contact_batches.h"
#include "core/physics/lanes/contact_formulas.h"

#include <array>
#include <cstring>

namespace spacetow::lanes {

using formulas::greater;
using formulas::lesser;

/// Four vectors of four components, by component. As velocities: x and y in m/s, z angular in rad/s. As poses: x and y
/// of the centre of mass in m, z the cosine, w the sine of the angle.
struct WideVec4 {
    Wide x, y, z, w;
};

/// The transpose of a 4 × 4 matrix: the core of gather and of scatter.
SPACETOW_INLINE WideVec4 transposed(Wide r0, Wide r1, Wide r2, Wide r3) {
    const Wide low02 = __builtin_shufflevector(r0, r1, 0, 4, 2, 6);
    const Wide low13 = __builtin_shufflevector(r0, r1, 1, 5, 3, 7);
    const Wide high02 = __builtin_shufflevector(r2, r3, 0, 4, 2, 6);
    const Wide high13 = __builtin_shufflevector(r2, r3, 1, 5, 3, 7);
    return {__builtin_shufflevector(low02, high02, 0, 1, 4, 5), __builtin_shufflevector(low13, high13, 0, 1, 4, 5),
            __builtin_shufflevector(low02, high02, 2, 3, 6, 7), __builtin_shufflevector(low13, high13, 2, 3, 6, 7)};
}

SPACETOW_INLINE Wide row(const BodyVelocity& velocity) {
    Wide result;
    std::memcpy(&result, &velocity, sizeof result);
    return result;
}

SPACETOW_INLINE WideVec4 gather(const BodyVelocity* velocities, const std::array<Slot, 4>& slots) {
    return transposed(row(velocities[slots[0]]), row(velocities[slots[1]]), row(velocities[slots[2]]),
                      row(velocities[slots[3]]));
}

SPACETOW_INLINE void scatter(BodyVelocity* velocities, const std::array<Slot, 4>& slots, const WideVec4& velocity) {
    const WideVec4 rows = transposed(velocity.x, velocity.y, velocity.z, velocity.w);
    std::memcpy(static_cast<void*>(&velocities[slots[0]]), &rows.x, sizeof(Wide));
    std::memcpy(static_cast<void*>(&velocities[slots[1]]), &rows.y, sizeof(Wide));
    std::memcpy(static_cast<void*>(&velocities[slots[2]]), &rows.z, sizeof(Wide));
    std::memcpy(static_cast<void*>(&velocities[slots[3]]), &rows.w, sizeof(Wide));
}

/// A linear impulse (x, y) on b, its opposite on a, and the angular impulses on b (`twistB`) and, negative, on a.
struct Impulse {
    Wide x, y, twistA, twistB;
};

/// The velocities, or position corrections, of the bodies of a batch.
struct BatchBodies {
    WideVec4 a, b;

    SPACETOW_INLINE Wide along(Wide x, Wide y) const { return (b.x - a.x) * x + (b.y - a.y) * y; }
    SPACETOW_INLINE Wide turning(Wide leverA, Wide leverB) const { return b.z * leverB - a.z * leverA; }
    template <class Batch>
    SPACETOW_INLINE void apply(const Batch& c, const Impulse& impulse) {
        push(c, impulse.x, impulse.y);
        a.z -= c.inertiaA * impulse.twistA;
        b.z += c.inertiaB * impulse.twistB;
    }
    template <class Batch>
    SPACETOW_INLINE void push(const Batch& c, Wide x, Wide y) {
        a.x -= c.massA * x;
        a.y -= c.massA * y;
        b.x += c.massB * x;
        b.y += c.massB * y;
    }
};

SPACETOW_INLINE LaneBits bits(Mask mask) {
#if defined(__x86_64__)
    using Half = double __attribute__((vector_size(16))); // SSE2, which every x86-64 processor has
    std::array<Half, 2> halves;
    std::memcpy(halves.data(), &mask, sizeof mask);
    const int low = __builtin_ia32_movmskpd(halves[0]);
    const int high = __builtin_ia32_movmskpd(halves[1]);
    return static_cast<LaneBits>(low | high << 2);
#else
    return static_cast<LaneBits>((mask[0] & 1) | (mask[1] & 2) | (mask[2] & 4) | (mask[3] & 8));
#endif
}

SPACETOW_INLINE bool any(Mask mask) {
    return bits(mask) != 0;
}

} // namespace spacetow::lanes
