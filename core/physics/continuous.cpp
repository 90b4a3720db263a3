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
    return travelsFar(data.steps[slot]);
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

bool hasContact(const WorldData& data, const Pair& pair) {
    return pair.contact != Pair::none && data.contacts[pair.contact].count > 0;
}

/// True when the motion of either body was cut short.
bool sweepPair(WorldData& data, const Pair& pair, bool stopA, bool stopB) {
    const Motion a = plannedMotion(data, pair.bodyA);
    const Motion b = pair.staticB ? Motion{} : plannedMotion(data, pair.bodyB);
    const std::optional<double> hit = timeOfImpact(*pair.shapeA, a, *pair.shapeB, b, gap);
    // What is near from the start and yet no contact is a corner that another part or wall answers for.
    if (!hit || *hit <= 0 || *hit >= 1) {
        return false;
    }
    bool changed = false;
    if (stopA) {
        changed |= shorten(data.steps[pair.bodyA], *hit);
    }
    if (stopB) {
        changed |= shorten(data.steps[pair.bodyB], *hit);
    }
    return changed;
}

} // namespace

void stopAtImpacts(WorldData& data) {
    for (int round = 0; round < maxRounds; ++round) {
        bool changed = false;
        for (const Pair& pair : data.table.pairs) {
            // The solver keeps those that have a contact from closing their gap.
            if (pair.kind == PairKind::Felt || (hasContact(data, pair) && !pair.sweep)) {
                continue;
            }
            const bool stopA = data.motions[pair.bodyA].inverseMass > 0 && (pair.sweep || isFast(data, pair.bodyA));
            const bool stopB =
                !pair.staticB && data.motions[pair.bodyB].inverseMass > 0 && (pair.sweep || isFast(data, pair.bodyB));
            if (stopA || stopB) {
                changed |= sweepPair(data, pair, stopA, stopB);
            }
        }
        if (!changed) {
            break;
        }
    }
}

} // namespace spacetow
