#include "core/physics/def/tolerances.h"
#include "core/physics/lanes/gather.h"
#include "core/physics/lanes/solver_kernels.h"

namespace spacetow {

namespace {

using namespace lanes;

/// The way that the surfaces at a point are pushed apart, as an impulse, kg m.
SPACETOW_INLINE Wide wayOut(Wide separation, Wide velocity, Wide mass, const PushRules& rules) {
    const Wide excess = -linearSlop - separation - rules.dt * greater(velocity, Wide{});
    return excess > Wide{} ? lesser(rules.share * excess, Wide{} + rules.most) * mass : Wide{};
}

SPACETOW_INLINE void pushOut(Ends& ends, const RoundBatch& c, const RoundShapes&, const PushRules& rules) {
    const Wide way = wayOut(c.separation, c.velocity, c.normalMass, rules);
    ends.push(c, way * c.normalX, way * c.normalY);
}

SPACETOW_INLINE void pushOut(Ends& ends, const ConstraintBatch& c, const ConstraintShapes& s, const PushRules& rules) {
    const Wide way1 = s.acts1 ? wayOut(c.separation1, c.velocity1, c.mass1, rules) : Wide{};
    const Wide way2 = s.acts2 ? wayOut(c.separation2, c.velocity2, c.mass2, rules) : Wide{};
    const Wide way = way1 + way2;
    ends.apply(c, {way * c.normalX, way * c.normalY, way1 * c.leverA1 + way2 * c.leverA2,
                   way1 * c.leverB1 + way2 * c.leverB2});
}

template <class Batch>
SPACETOW_INLINE bool pushAll(Pace* pushes, Batches<Batch>& batches, const PushRules& rules) {
    const std::size_t count = batches.size();
    bool any = false;
    for (std::size_t i = 0; i < count; ++i) {
        if (batches.notes(i).overlaps == 0) {
            continue;
        }
        const Batch& batch = batches.begin()[i];
        Ends ends{load(pushes, batch.a), load(pushes, batch.b)};
        pushOut(ends, batch, batches.shapes(i), rules);
        store(pushes, batch.a, ends.a);
        store(pushes, batch.b, ends.b);
        any = true;
    }
    return any;
}

SPACETOW_INLINE bool pushBoth(ContactBatches& batches, const PushRules& rules) {
    const bool round = pushAll(batches.pushes.data(), batches.round, rules);
    return pushAll(batches.pushes.data(), batches.general, rules) || round;
}

#if defined(__x86_64__)
__attribute__((target("avx2"))) bool pushWide(ContactBatches& batches, const PushRules& rules) {
    return pushBoth(batches, rules);
}
#endif

} // namespace

bool pushApart(ContactBatches& batches, const PushRules& rules, [[maybe_unused]] bool wide) {
#if defined(__x86_64__)
    if (wide) {
        return pushWide(batches, rules);
    }
#endif
    return pushBoth(batches, rules);
}

} // namespace spacetow
