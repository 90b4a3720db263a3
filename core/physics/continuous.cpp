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

/// Where the solver has not converged, bodies in contact would still go into each other: they go as far as the slop.
bool limitClosing(WorldData& data, double dt) {
    bool limited = false;
    for (const Constraint& c : data.constraints) {
        const BodyMotion& a = data.motions[c.a];
        const BodyMotion& b = data.motions[c.b];
        for (int i = 0; i < c.count; ++i) {
            const ConstraintPoint& p = c.points[static_cast<std::size_t>(i)];
            const Vec2 velocity =
                b.velocity + cross(b.angularVelocity, p.armB) - a.velocity - cross(a.angularVelocity, p.armA);
            const double closing = -velocity.dot(c.normal) * dt;
            const double room = std::max(p.separation, 0.0) + linearSlop;
            if (closing > room) {
                for (const Slot slot : {c.a, c.b}) {
                    if (data.motions[slot].inverseMass > 0) {
                        data.steps[slot].fraction = std::min(data.steps[slot].fraction, room / closing);
                        limited = true;
                    }
                }
            }
        }
    }
    return limited;
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
    const bool limited = limitClosing(data, step.dt);
    const bool any = limited ||
                     std::any_of(data.moving.begin(), data.moving.end(), [&](Slot s) { return isFast(data, s); }) ||
                     std::any_of(data.pairs.begin(), data.pairs.end(), [](const Pair& p) { return p.sweep; });
    if (!any) {
        return;
    }
    for (int round = 0; round < maxRounds; ++round) {
        bool changed = false;
        for (const Pair& pair : data.pairs) {
            if (!pair.solid || (pair.count > 0 && !pair.sweep)) { // the solver keeps those from closing their gap
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
    takeBackAcceleration(data, step.dt);
}

} // namespace spacetow
