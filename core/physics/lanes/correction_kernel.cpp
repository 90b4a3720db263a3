#include "core/physics/def/tolerances.h"
#include "core/physics/lanes/gather.h"
#include "core/physics/lanes/solver_kernels.h"

namespace spacetow {

namespace {

using namespace lanes;

/// The position correction at a point as a pseudo-impulse, kg m.
SPACETOW_INLINE Wide positionCorrection(Wide separation, Wide velocity, Wide mass, const CorrectionRules& rules) {
    const Wide excess = -linearSlop - separation - rules.dt * greater(velocity, Wide{});
    return excess > Wide{} ? lesser(rules.share * excess, Wide{} + rules.most) * mass : Wide{};
}

SPACETOW_INLINE void correct(BatchBodies& bodies, const CircleBatch& c, const CircleAnchors&,
                             const CorrectionRules& rules) {
    const Wide correction = positionCorrection(c.separation, c.velocity, c.normalMass, rules);
    bodies.push(c, correction * c.normalX, correction * c.normalY);
}

SPACETOW_INLINE void correct(BatchBodies& bodies, const ConstraintBatch& c, const ContactAnchors& s,
                             const CorrectionRules& rules) {
    const Wide correction1 = s.acts1 ? positionCorrection(c.separation1, c.velocity1, c.mass1, rules) : Wide{};
    const Wide correction2 = s.acts2 ? positionCorrection(c.separation2, c.velocity2, c.mass2, rules) : Wide{};
    const Wide correction = correction1 + correction2;
    bodies.apply(c, {correction * c.normalX, correction * c.normalY, correction1 * c.leverA1 + correction2 * c.leverA2,
                     correction1 * c.leverB1 + correction2 * c.leverB2});
}

template <class Batch>
SPACETOW_INLINE bool correctAll(BodyVelocity* corrections, Batches<Batch>& batches, const CorrectionRules& rules) {
    const std::size_t count = batches.size();
    bool any = false;
    for (std::size_t i = 0; i < count; ++i) {
        if (batches.flags(i).overlaps == 0) {
            continue;
        }
        const Batch& batch = batches.begin()[i];
        BatchBodies bodies{gather(corrections, batch.a), gather(corrections, batch.b)};
        correct(bodies, batch, batches.anchors(i), rules);
        scatter(corrections, batch.a, bodies.a);
        scatter(corrections, batch.b, bodies.b);
        any = true;
    }
    return any;
}

SPACETOW_INLINE bool correctBoth(ContactBatches& batches, BodyVelocity* corrections, const CorrectionRules& rules) {
    const bool circles = correctAll(corrections, batches.circles, rules);
    return correctAll(corrections, batches.general, rules) || circles;
}

#if defined(__x86_64__)
__attribute__((target("avx2"))) bool correctWide(ContactBatches& batches, BodyVelocity* corrections,
                                                 const CorrectionRules& rules) {
    return correctBoth(batches, corrections, rules);
}
#endif

} // namespace

bool correctPositions(ContactBatches& batches, std::vector<BodyVelocity>& corrections, const CorrectionRules& rules,
                      [[maybe_unused]] bool wide) {
#if defined(__x86_64__)
    if (wide) {
        return correctWide(batches, corrections.data(), rules);
    }
#endif
    return correctBoth(batches, corrections.data(), rules);
}

} // namespace spacetow
