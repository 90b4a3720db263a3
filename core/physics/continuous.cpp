#include "core/physics/continuous.h"

#include "core/geometry/cast.h"

#include <algorithm>
#include <cmath>

namespace spacetow {

namespace {

// What was shortened by one hit may now be hit by something else: rounds of looking again.
constexpr int maxRounds = 4;
// A swept body stops this far before the surface, m.
constexpr double gap = 0.5 * linearSlop;

/// Whether anticipation does not cover the motion; see contacts.
bool isFast(const WorldData& data, Slot slot) {
    const BodyStep& s = data.steps[slot];
    const double reach = std::sqrt(s.shift.squaredNorm()) + std::abs(s.turn) * data.records[slot].outerRadius;
    return reach > 0.5 * data.records[slot].innerRadius && reach > linearSlop;
}

Motion plannedMotion(const WorldData& data, Slot slot) {
    const BodyStep& s = data.steps[slot];
    return {.start = data.pose(slot), .translation = s.fraction * s.shift, .turn = s.fraction * s.turn};
}

bool shorten(BodyStep& s, double fraction) {
    const double shortened = s.fraction * fraction;
    const bool changed = shortened < s.fraction;
    s.fraction = std::min(s.fraction, shortened);
    return changed;
}

/// True when the motion of either body was cut short.
bool sweepPair(WorldData& data, const Pair& pair, bool fastA, bool fastB) {
    const Motion a = plannedMotion(data, pair.bodyA);
    const Motion b = pair.staticB ? Motion{} : plannedMotion(data, pair.bodyB);
    const std::optional<double> hit = timeOfImpact(*pair.shapeA, a, *pair.shapeB, b, gap);
    if (!hit || *hit >= 1) {
        return false;
    }
    bool changed = false;
    if (fastA) {
        changed |= shorten(data.steps[pair.bodyA], *hit);
    }
    if (fastB) {
        changed |= shorten(data.steps[pair.bodyB], *hit);
    }
    return changed;
}

/// What was not travelled was not accelerated either, so that a fall from rest arrives with the speed of the height.
void takeBackAcceleration(WorldData& data, double dt) {
    for (const Slot slot : data.moving) {
        const BodyStep& s = data.steps[slot];
        if (s.fraction < 1 && !s.pushed) {
            const double lost = (1 - s.fraction) * dt;
            data.motions[slot].velocity -= lost * s.acceleration;
            data.motions[slot].angularVelocity -= lost * s.angularAcceleration;
        }
    }
}

} // namespace

void stopAtImpacts(WorldData& data, const IterationStep& step) {
    bool any = false;
    for (const Slot slot : data.moving) {
        any |= isFast(data, slot);
    }
    if (!any) {
        return;
    }
    for (int round = 0; round < maxRounds; ++round) {
        bool changed = false;
        for (const Pair& pair : data.pairs) {
            if (!pair.solid || pair.count > 0) { // the solver keeps those in contact from closing their gap
                continue;
            }
            const bool fastA = isFast(data, pair.bodyA) && data.motions[pair.bodyA].inverseMass > 0;
            const bool fastB =
                !pair.staticB && isFast(data, pair.bodyB) && data.motions[pair.bodyB].inverseMass > 0;
            if (fastA || fastB) {
                changed |= sweepPair(data, pair, fastA, fastB);
            }
        }
        if (!changed) {
            break;
        }
    }
    takeBackAcceleration(data, step.dt);
}

} // namespace spacetow
