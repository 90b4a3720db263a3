#include "core/physics/lanes/solver_kernels.h"

#include "core/physics/def/tolerances.h"
#include "core/physics/lanes/gather.h"

namespace spacetow {

namespace {

using namespace lanes;

SPACETOW_INLINE void applyWarmStart(BatchBodies& bodies, const CircleBatch& c) {
    const Wide x = c.normalImpulse * c.normalX - c.tangentImpulse * c.normalY;
    const Wide y = c.normalImpulse * c.normalY + c.tangentImpulse * c.normalX;
    bodies.apply(c, {x, y, c.tangentImpulse * c.leverA, c.tangentImpulse * c.leverB});
}

SPACETOW_INLINE void applyWarmStart(BatchBodies& bodies, const ConstraintBatch& c) {
    const Wide normal = c.impulse1 + c.impulse2;
    const Wide x = normal * c.normalX - c.tangentImpulse * c.normalY;
    const Wide y = normal * c.normalY + c.tangentImpulse * c.normalX;
    bodies.apply(c, {x, y, c.impulse1 * c.leverA1 + c.impulse2 * c.leverA2 + c.tangentImpulse * c.tangentLeverA,
                     c.impulse1 * c.leverB1 + c.impulse2 * c.leverB2 + c.tangentImpulse * c.tangentLeverB});
}

/// The levers of an impulse on both bodies.
struct Levers {
    Wide a, b; // m
};

/// The accumulated tangent impulse that stops sliding along the tangent (−y, x) of the normal, clamped to ±`limit`.
template <class Batch>
SPACETOW_INLINE Wide friction(const BatchBodies& bodies, const Batch& c, const Levers& levers, Wide limit) {
    const Wide sliding = bodies.along(-c.normalY, c.normalX) + bodies.turning(levers.a, levers.b);
    return lesser(greater(c.tangentImpulse - c.tangentMass * sliding, -limit), limit);
}

template <class Batch>
SPACETOW_INLINE void applyFriction(BatchBodies& bodies, Batch& c, const Levers& levers, Wide impulse) {
    const Wide change = impulse - c.tangentImpulse;
    c.tangentImpulse = impulse;
    bodies.apply(c, {-change * c.normalY, change * c.normalX, change * levers.a, change * levers.b});
}

SPACETOW_INLINE Levers tangentLeversOf(const CircleBatch& c) {
    return {c.leverA, c.leverB};
}
SPACETOW_INLINE Levers tangentLeversOf(const ConstraintBatch& c) {
    return {c.tangentLeverA, c.tangentLeverB};
}
SPACETOW_INLINE Wide normalImpulseOf(const CircleBatch& c) {
    return c.normalImpulse;
}
SPACETOW_INLINE Wide normalImpulseOf(const ConstraintBatch& c) {
    return c.impulse1 + c.impulse2;
}
template <class Batch>
SPACETOW_INLINE void solveFriction(BatchBodies& bodies, Batch& c) {
    const Levers levers = tangentLeversOf(c);
    applyFriction(bodies, c, levers, friction(bodies, c, levers, c.friction * normalImpulseOf(c)));
}
template <class Batch>
SPACETOW_INLINE void solveFriction(BatchBodies& bodies, Batch& c, Mask which) {
    const Levers levers = tangentLeversOf(c);
    const Wide impulse = friction(bodies, c, levers, c.friction * normalImpulseOf(c));
    applyFriction(bodies, c, levers, which ? impulse : c.tangentImpulse);
}

SPACETOW_INLINE void solveNormals(BatchBodies& bodies, CircleBatch& c, double relaxation) {
    const Wide excess = bodies.along(c.normalX, c.normalY) - c.target;
    const Wide impulse = greater(c.normalImpulse - relaxation * c.normalMass * excess, Wide{});
    const Wide change = impulse - c.normalImpulse;
    c.normalImpulse = impulse;
    bodies.push(c, change * c.normalX, change * c.normalY);
}

/// Normal impulses at the two points.
struct Impulses {
    Wide first, second; // kg m/s
};

/// Solves the linear complementarity problem x ≥ 0, K x + b ≥ 0, x·(K x + b) = 0 by total enumeration, as Box2D's block
/// solver does. The order of the points does not matter, so that mirrored scenes stay mirrored.
SPACETOW_INLINE Impulses complementary(const ConstraintBatch& c, Wide b1, Wide b2) {
    const Wide none{};
    const Wide x1 = (c.coupling * b2 - c.k22 * b1) * c.inverseDeterminant;
    const Wide x2 = (c.coupling * b1 - c.k11 * b2) * c.inverseDeterminant;
    const auto both = (x1 >= none) & (x2 >= none);
    const Wide only1 = -b1 * c.mass1;
    const auto first = (only1 >= none) & (c.coupling * only1 + b2 >= none);
    const Wide only2 = -b2 * c.mass2;
    const auto second = (only2 >= none) & (c.coupling * only2 + b1 >= none);
    return {both ? x1 : (first ? only1 : none), both ? x2 : (first ? none : (second ? only2 : none))};
}

/// Never over-relaxed: see overrelaxPass.
SPACETOW_INLINE void solveNormals(BatchBodies& bodies, ConstraintBatch& c, double /*relaxation*/) {
    const Wide closing = bodies.along(c.normalX, c.normalY);
    const Wide b1 =
        closing + bodies.turning(c.leverA1, c.leverB1) - c.target1 - (c.k11 * c.impulse1 + c.coupling * c.impulse2);
    const Wide b2 =
        closing + bodies.turning(c.leverA2, c.leverB2) - c.target2 - (c.coupling * c.impulse1 + c.k22 * c.impulse2);
    const auto [x1, x2] = complementary(c, b1, b2);
    const Wide d1 = x1 - c.impulse1;
    const Wide d2 = x2 - c.impulse2;
    c.impulse1 = x1;
    c.impulse2 = x2;
    const Wide change = d1 + d2;
    bodies.apply(
        c, {change * c.normalX, change * c.normalY, d1 * c.leverA1 + d2 * c.leverA2, d1 * c.leverB1 + d2 * c.leverB2});
}

/// Friction comes first, so that the pass ends with correct normal velocities. A contact that gets its first normal
/// impulse in this pass had no limit for friction before; its friction is solved again afterwards.
template <class Batch>
SPACETOW_INLINE void solveOnce(BatchBodies& bodies, Batch& c, double relaxation) {
    const Wide before = normalImpulseOf(c);
    solveFriction(bodies, c);
    solveNormals(bodies, c, relaxation);
    const Mask hit = (before == Wide{}) & (normalImpulseOf(c) > Wide{});
    if (any(hit)) {
        solveFriction(bodies, c, hit);
    }
}

SPACETOW_INLINE Mask touching(const CircleBatch& c) {
    return (c.normalImpulse > Wide{}) | (c.separation <= Wide{});
}
SPACETOW_INLINE Mask touching(const ConstraintBatch& c) {
    return (c.impulse1 > Wide{}) | (c.separation1 <= Wide{}) | (c.impulse2 > Wide{}) | (c.separation2 <= Wide{});
}

SPACETOW_INLINE Mask overlapping(const CircleBatch& c) {
    return c.separation < Wide{} - linearSlop;
}
SPACETOW_INLINE Mask overlapping(const ConstraintBatch& c) {
    return (c.separation1 < Wide{} - linearSlop) | (c.separation2 < Wide{} - linearSlop);
}

enum class Task { WarmStart, Solve, Overrelax, Measure };

template <class Batch>
SPACETOW_INLINE void warmStartAll(BodyVelocity* velocities, Batches<Batch>& batches) {
    const std::size_t count = batches.size();
    for (std::size_t i = 0; i < count; ++i) {
        const Batch& batch = batches.begin()[i];
        BatchBodies bodies{gather(velocities, batch.a), gather(velocities, batch.b)};
        applyWarmStart(bodies, batch);
        scatter(velocities, batch.a, bodies.a);
        scatter(velocities, batch.b, bodies.b);
    }
}

template <class Batch>
SPACETOW_INLINE void solveAll(BodyVelocity* velocities, Batches<Batch>& batches, double relaxation) {
    const std::size_t count = batches.size();
    for (std::size_t i = 0; i < count; ++i) {
        Batch& batch = batches.begin()[i];
        BatchBodies bodies{gather(velocities, batch.a), gather(velocities, batch.b)};
        solveOnce(bodies, batch, relaxation);
        scatter(velocities, batch.a, bodies.a);
        scatter(velocities, batch.b, bodies.b);
    }
}

SPACETOW_INLINE Mask measure(const BatchBodies& bodies, CircleBatch& c) {
    c.velocity = bodies.along(c.normalX, c.normalY);
    return c.velocity < c.closingLimit;
}

SPACETOW_INLINE Mask measure(const BatchBodies& bodies, ConstraintBatch& c) {
    const Wide linear = bodies.along(c.normalX, c.normalY);
    c.velocity1 = linear + bodies.turning(c.leverA1, c.leverB1);
    c.velocity2 = linear + bodies.turning(c.leverA2, c.leverB2);
    return (c.velocity1 < c.closingLimit1) | (c.velocity2 < c.closingLimit2);
}

template <class Batch>
SPACETOW_INLINE bool measureAll(const BodyVelocity* velocities, Batches<Batch>& batches) {
    const std::size_t count = batches.size();
    LaneBits closes = 0;
    for (std::size_t i = 0; i < count; ++i) {
        Batch& batch = batches.begin()[i];
        const Mask here = measure(BatchBodies{gather(velocities, batch.a), gather(velocities, batch.b)}, batch);
        BatchFlags& flags = batches.flags(i);
        flags.closes = bits(here) & flags.occupied;
        flags.touches = bits(touching(batch)) & flags.occupied;
        flags.overlaps = bits(overlapping(batch)) & flags.occupied;
        closes |= flags.closes;
    }
    return closes != 0;
}

SPACETOW_INLINE bool runTask(ContactBatches& batches, BodyVelocity* velocities, Task task) {
    switch (task) {
    case Task::WarmStart:
        warmStartAll(velocities, batches.circles);
        warmStartAll(velocities, batches.general);
        break;
    case Task::Solve:
        solveAll(velocities, batches.circles, 1);
        solveAll(velocities, batches.general, 1);
        break;
    case Task::Overrelax:
        solveAll(velocities, batches.circles, overrelaxation);
        solveAll(velocities, batches.general, overrelaxation);
        break;
    case Task::Measure: {
        const bool circlesClose = measureAll(velocities, batches.circles);
        return measureAll(velocities, batches.general) || circlesClose;
    }
    }
    return false;
}

#if defined(__x86_64__)
__attribute__((target("avx2"))) bool runTaskWide(ContactBatches& batches, BodyVelocity* velocities, Task task) {
    return runTask(batches, velocities, task);
}
#endif

bool dispatch(ContactBatches& batches, std::vector<BodyVelocity>& velocities, Task task, [[maybe_unused]] bool wide) {
#if defined(__x86_64__)
    if (wide) {
        return runTaskWide(batches, velocities.data(), task);
    }
#endif
    return runTask(batches, velocities.data(), task);
}

} // namespace

bool hasWideRegisters() {
#if defined(__x86_64__)
    static const bool has = __builtin_cpu_supports("avx2") != 0;
    return has;
#else
    return false;
#endif
}

void warmStart(ContactBatches& batches, std::vector<BodyVelocity>& velocities, bool wide) {
    dispatch(batches, velocities, Task::WarmStart, wide);
}

void solvePass(ContactBatches& batches, std::vector<BodyVelocity>& velocities, bool wide) {
    dispatch(batches, velocities, Task::Solve, wide);
}

void overrelaxPass(ContactBatches& batches, std::vector<BodyVelocity>& velocities, bool wide) {
    dispatch(batches, velocities, Task::Overrelax, wide);
}

bool measureVelocities(ContactBatches& batches, std::vector<BodyVelocity>& velocities, bool wide) {
    return dispatch(batches, velocities, Task::Measure, wide);
}

} // namespace spacetow
