#include "core/physics/def/tolerances.h"
#include "core/physics/lanes/gather.h"
#include "core/physics/lanes/solver_kernels.h"

#include <limits>

namespace spacetow {

namespace {

using namespace lanes;
using namespace formulas;

/// The arguments of refreshContacts that all lanes share.
struct RefreshInputs {
    BodyViews bodies;
    double perSecond; // iterations
};

SPACETOW_INLINE Wide squareRoot(Wide x) {
    return Wide{__builtin_sqrt(x[0]), __builtin_sqrt(x[1]), __builtin_sqrt(x[2]), __builtin_sqrt(x[3])};
}

SPACETOW_INLINE Wide magnitude(Wide x) {
    return x < Wide{} ? -x : x;
}

SPACETOW_INLINE Wide row(const BodyRows& rows, Slot slot) {
    Wide result;
    std::memcpy(&result, static_cast<const char*>(rows.first) + slot * rows.stride, sizeof result);
    return result;
}

SPACETOW_INLINE WideVec4 gather(const BodyRows& rows, const std::array<Slot, 4>& slots) {
    return transposed(row(rows, slots[0]), row(rows, slots[1]), row(rows, slots[2]), row(rows, slots[3]));
}

/// About the centres of mass, m.
struct LeverPair {
    Wide a, b;
};

/// Returns the lanes whose surfaces are beyond the speculative margin.
SPACETOW_INLINE Mask refresh(CircleBatch& c, const CircleAnchors& anchors, const RefreshInputs& inputs) {
    const WideVec4 a = gather(inputs.bodies.poses, anchors.a);
    const WideVec4 b = gather(inputs.bodies.poses, anchors.b);
    const Wide apartX = b.x - a.x;
    const Wide apartY = b.y - a.y;
    const Wide squared = apartX * apartX + apartY * apartY;
    const WideVec4 motionA = gather(inputs.bodies.plannedMotions, anchors.a);
    const WideVec4 motionB = gather(inputs.bodies.plannedMotions, anchors.b);
    const Wide motion = magnitude(motionA.x - motionB.x) + magnitude(motionA.y - motionB.y);
    const Wide margin = speculativeMargin(motion, motionA.w + motionB.w);
    const Wide reach = anchors.radiusA + anchors.radiusB + margin;
    const Wide distance = squareRoot(squared);
    const Mask hasNormal = distance > Wide{};
    const Wide separation = distance - anchors.radiusA - anchors.radiusB;
    const Wide leverA = anchors.radiusA + 0.5 * separation;
    const Wide leverB = -anchors.radiusB - 0.5 * separation;
    const Mask wideUpdate = anchors.wideUpdate;
    c.normalX = wideUpdate ? (hasNormal ? apartX / distance : Wide{}) : c.normalX;
    c.normalY = wideUpdate ? (hasNormal ? apartY / distance : Wide{} + 1) : c.normalY;
    c.separation = wideUpdate ? separation : c.separation;
    c.leverA = wideUpdate ? leverA : c.leverA;
    c.leverB = wideUpdate ? leverB : c.leverB;
    const Wide inverse = inverseMass(c, LeverPair{leverA, leverB});
    c.tangentMass = wideUpdate ? 1 / inverse : c.tangentMass;
    c.target = wideUpdate ? targetVelocity(separation, inputs.perSecond) : c.target;
    c.closingLimit = wideUpdate ? closingLimit(separation, inputs.perSecond) : c.closingLimit;
    return wideUpdate & (squared > reach * reach);
}

/// World coordinates of a local point.
SPACETOW_INLINE Wide worldX(const WideVec4& pose, Wide x, Wide y) {
    return pose.x + (pose.z * x - pose.w * y);
}
SPACETOW_INLINE Wide worldY(const WideVec4& pose, Wide x, Wide y) {
    return pose.y + (pose.w * x + pose.z * y);
}

/// Returns the lanes whose parts have moved relative to each other by more than the manifold tolerance leaves.
SPACETOW_INLINE Mask outdated(const ContactAnchors& s, const WideVec4& a, const WideVec4& b,
                              const RefreshInputs& inputs) {
    const Wide apartX = a.x - b.x;
    const Wide apartY = a.y - b.y;
    const Wide movedX = b.z * apartX + b.w * apartY - s.relativeX;
    const Wide movedY = b.z * apartY - b.w * apartX - s.relativeY;
    const Wide turnedC = b.z * a.z + b.w * a.w - s.cosine;
    const Wide turnedS = b.z * a.w - b.w * a.z - s.sine;
    const Wide left = s.tolerance - squareRoot(movedX * movedX + movedY * movedY) -
                      squareRoot(turnedC * turnedC + turnedS * turnedS) * s.radiusA;
    const WideVec4 motionA = gather(inputs.bodies.plannedMotions, s.a);
    WideVec4 motionB = gather(inputs.bodies.plannedMotions, s.b);
    motionB.x = s.staticB ? Wide{} : motionB.x;
    motionB.y = s.staticB ? Wide{} : motionB.y;
    motionB.z = s.staticB ? Wide{} : motionB.z;
    motionB.w = s.staticB ? Wide{} : motionB.w;
    const Wide motion = magnitude(motionA.x - motionB.x) + magnitude(motionA.y - motionB.y) + motionA.z + motionB.z;
    return left < speculativeMargin(motion, motionA.w + motionB.w);
}

/// From the centres of mass to a contact point.
struct Arms {
    Wide aX, aY, bX, bY;
    SPACETOW_INLINE Arms(const WideVec4& a, const WideVec4& b, Wide x, Wide y)
        : aX(x - a.x), aY(y - a.y), bX(x - b.x), bY(y - b.y) {}
};

SPACETOW_INLINE void setFriction(ConstraintBatch& c, const Arms& arms1, const Arms& arms2, Wide leastInverseMass) {
    c.tangentLeverA =
        0.5 * (arms1.aX * c.normalX + arms1.aY * c.normalY + (arms2.aX * c.normalX + arms2.aY * c.normalY));
    c.tangentLeverB =
        0.5 * (arms1.bX * c.normalX + arms1.bY * c.normalY + (arms2.bX * c.normalX + arms2.bY * c.normalY));
    c.tangentMass = effectiveMass(inverseMass(c, LeverPair{c.tangentLeverA, c.tangentLeverB}), leastInverseMass);
}

/// Sets levers and the 2 × 2 system. Returns the lanes in which a point begins or ceases to act, or the system becomes
/// singular or regular.
SPACETOW_INLINE Mask setBlock(ConstraintBatch& c, const ContactAnchors& s, const Arms& arms1, const Arms& arms2) {
    c.leverA1 = arms1.aX * c.normalY - arms1.aY * c.normalX;
    c.leverB1 = arms1.bX * c.normalY - arms1.bY * c.normalX;
    c.leverA2 = arms2.aX * c.normalY - arms2.aY * c.normalX;
    c.leverB2 = arms2.bX * c.normalY - arms2.bY * c.normalX;
    const Wide k11 = inverseMass(c, LeverPair{c.leverA1, c.leverB1});
    const Wide k22 = inverseMass(c, LeverPair{c.leverA2, c.leverB2});
    const Mask acts1 = s.first & (k11 > s.leastInverseMass);
    const Mask acts2 = s.second & (k22 > s.leastInverseMass);
    c.k11 = acts1 ? k11 : Wide{} + 1;
    c.k22 = acts2 ? k22 : c.k11;
    c.mass1 = 1 / c.k11;
    c.mass2 = 1 / c.k22;
    const Wide coupling = inverseMass(c, LeverPair{c.leverA1, c.leverB1}, LeverPair{c.leverA2, c.leverB2});
    const Mask both = acts1 & acts2;
    const Wide largest = greater(c.k11, c.k22);
    const Mask singular = both & (largest * largest >= singularRatio * (c.k11 * c.k22 - coupling * coupling));
    c.coupling = both & ~singular ? coupling : Wide{};
    c.inverseDeterminant = 1 / (c.k11 * c.k22 - c.coupling * c.coupling);
    return (acts1 ^ s.acts1) | (acts2 ^ s.acts2) | (singular ^ s.singular);
}

SPACETOW_INLINE Mask refresh(ConstraintBatch& c, const ContactAnchors& s, const RefreshInputs& inputs) {
    const WideVec4 a = gather(inputs.bodies.poses, s.a);
    WideVec4 b = gather(inputs.bodies.poses, s.b);
    b.x = s.staticB ? Wide{} : b.x;
    b.y = s.staticB ? Wide{} : b.y;
    b.z = s.staticB ? Wide{} + 1 : b.z;
    b.w = s.staticB ? Wide{} : b.w;
    const Wide cosine = s.normalOnA ? a.z : b.z;
    const Wide sine = s.normalOnA ? a.w : b.w;
    c.normalX = cosine * s.normalX - sine * s.normalY;
    c.normalY = sine * s.normalX + cosine * s.normalY;
    const Wide onA1X = worldX(a, s.onA1X, s.onA1Y);
    const Wide onA1Y = worldY(a, s.onA1X, s.onA1Y);
    const Wide onA2X = worldX(a, s.onA2X, s.onA2Y);
    const Wide onA2Y = worldY(a, s.onA2X, s.onA2Y);
    const Wide apart1X = worldX(b, s.onB1X, s.onB1Y) - onA1X;
    const Wide apart1Y = worldY(b, s.onB1X, s.onB1Y) - onA1Y;
    const Wide apart2X = worldX(b, s.onB2X, s.onB2Y) - onA2X;
    const Wide apart2Y = worldY(b, s.onB2X, s.onB2Y) - onA2Y;
    const Wide separation1 = apart1X * c.normalX + apart1Y * c.normalY;
    const Wide separation2 = apart2X * c.normalX + apart2Y * c.normalY;
    const Wide far = Wide{} + std::numeric_limits<double>::infinity();
    const Wide never = Wide{} + noTarget;
    c.separation1 = s.first ? separation1 : far;
    c.separation2 = s.second ? separation2 : far;
    c.target1 = s.acts1 ? targetVelocity(separation1, inputs.perSecond) : never;
    c.target2 = s.acts2 ? targetVelocity(separation2, inputs.perSecond) : never;
    c.closingLimit1 = s.first ? closingLimit(separation1, inputs.perSecond) : never;
    c.closingLimit2 = s.second ? closingLimit(separation2, inputs.perSecond) : never;
    const Arms arms1(a, b, onA1X + 0.5 * apart1X, onA1Y + 0.5 * apart1Y);
    const Arms arms2(a, b, onA2X + 0.5 * apart2X, onA2Y + 0.5 * apart2Y);
    setFriction(c, arms1, arms2, s.leastInverseMass);
    return setBlock(c, s, arms1, arms2) | outdated(s, a, b, inputs);
}

template <class Batch>
SPACETOW_INLINE void refreshAll(const RefreshInputs& inputs, Batches<Batch>& batches) {
    const std::size_t count = batches.size();
    for (std::size_t i = 0; i < count; ++i) {
        BatchFlags& flags = batches.flags(i);
        flags.outdated = bits(refresh(batches.begin()[i], batches.anchors(i), inputs)) & flags.occupied;
    }
}

SPACETOW_INLINE void refreshBoth(ContactBatches& batches, const RefreshInputs& inputs) {
    refreshAll(inputs, batches.circles);
    refreshAll(inputs, batches.general);
}

#if defined(__x86_64__)
__attribute__((target("avx2"))) void refreshWide(ContactBatches& batches, const RefreshInputs& inputs) {
    refreshBoth(batches, inputs);
}
#endif

} // namespace

void refreshContacts(ContactBatches& batches, const BodyViews& bodies, double perSecond, [[maybe_unused]] bool wide) {
#if defined(__x86_64__)
    if (wide) {
        refreshWide(batches, {bodies, perSecond});
        return;
    }
#endif
    refreshBoth(batches, {bodies, perSecond});
}

} // namespace spacetow
