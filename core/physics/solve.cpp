#include "core/physics/solve.h"

#include <algorithm>
#include <cmath>

namespace spacetow {

namespace {

// Overlap is reduced at this rate, 1/s, by at most this share an iteration and not faster than this, m/s.
constexpr double pushOutRate = 40;
constexpr double pushOutShare = 0.2;
constexpr double pushOutSpeed = 25;

struct Bodies {
    BodyMotion& a;
    BodyMotion& b;
};

Bodies bodiesOf(WorldData& data, const Constraint& c) {
    return {data.motions[c.a], data.motions[c.b]};
}

void applyImpulse(const Bodies& on, const ConstraintPoint& p, const Vec2& impulse) {
    on.a.velocity -= on.a.inverseMass * impulse;
    on.a.angularVelocity -= on.a.inverseInertia * cross(p.armA, impulse);
    on.b.velocity += on.b.inverseMass * impulse;
    on.b.angularVelocity += on.b.inverseInertia * cross(p.armB, impulse);
}

Vec2 relativeVelocity(const Bodies& of, const ConstraintPoint& p) {
    return of.b.velocity + cross(of.b.angularVelocity, p.armB) - of.a.velocity - cross(of.a.angularVelocity, p.armA);
}

/// Both points at once, from the same velocities, so that their order does not matter; on one plane they have nearly
/// the same effect, hence half of the change each.
void solveTangents(const Bodies& on, Constraint& c) {
    const Vec2 tangent = leftOf(c.normal);
    std::array<double, 2> change{};
    for (std::size_t i = 0; i < static_cast<std::size_t>(c.count); ++i) {
        const ConstraintPoint& p = c.points[i];
        const double limit = c.friction * p.normalImpulse;
        const double step = p.tangentMass * relativeVelocity(on, p).dot(tangent) / c.count;
        change[i] = std::clamp(p.tangentImpulse - step, -limit, limit) - p.tangentImpulse;
    }
    for (std::size_t i = 0; i < static_cast<std::size_t>(c.count); ++i) {
        applyImpulse(on, c.points[i], change[i] * tangent);
        c.points[i].tangentImpulse += change[i];
    }
}

void solvePoint(const Bodies& on, const Constraint& c, ConstraintPoint& p, double target) {
    const double excess = relativeVelocity(on, p).dot(c.normal) - target;
    const double impulse = std::max(p.normalImpulse - p.normalMass * excess, 0.0);
    applyImpulse(on, p, (impulse - p.normalImpulse) * c.normal);
    p.normalImpulse = impulse;
}

/// The impulses x ≥ 0 with K x + b ≥ 0 and x·(K x + b) = 0, found by trying which of them act. The order of the
/// points does not matter, so that mirrored scenes stay mirrored.
std::array<double, 2> complementary(const Constraint& c, double b1, double b2) {
    const double k11 = 1 / c.points[0].normalMass;
    const double k22 = 1 / c.points[1].normalMass;
    const double x1 = (c.coupling * b2 - k22 * b1) / c.determinant;
    const double x2 = (c.coupling * b1 - k11 * b2) / c.determinant;
    if (x1 >= 0 && x2 >= 0) {
        return {x1, x2};
    }
    const double only1 = -b1 / k11;
    if (only1 >= 0 && c.coupling * only1 + b2 >= 0) {
        return {only1, 0};
    }
    const double only2 = -b2 / k22;
    if (only2 >= 0 && c.coupling * only2 + b1 >= 0) {
        return {0, only2};
    }
    return {0, 0};
}

void solveBlock(const Bodies& on, Constraint& c, double target1, double target2) {
    ConstraintPoint& p1 = c.points[0];
    ConstraintPoint& p2 = c.points[1];
    const double k11 = 1 / p1.normalMass;
    const double k22 = 1 / p2.normalMass;
    const double b1 =
        relativeVelocity(on, p1).dot(c.normal) - target1 - k11 * p1.normalImpulse - c.coupling * p2.normalImpulse;
    const double b2 =
        relativeVelocity(on, p2).dot(c.normal) - target2 - c.coupling * p1.normalImpulse - k22 * p2.normalImpulse;
    const std::array<double, 2> x = complementary(c, b1, b2);
    applyImpulse(on, p1, (x[0] - p1.normalImpulse) * c.normal);
    applyImpulse(on, p2, (x[1] - p2.normalImpulse) * c.normal);
    p1.normalImpulse = x[0];
    p2.normalImpulse = x[1];
}

void solveNormals(const Bodies& on, Constraint& c, double target1, double target2) {
    if (c.block) {
        solveBlock(on, c, target1, target2);
        return;
    }
    solvePoint(on, c, c.points[0], target1);
    if (c.count == 2) {
        solvePoint(on, c, c.points[1], target2);
    }
}

void warmStart(WorldData& data) {
    for (Constraint& c : data.constraints) {
        const Bodies on = bodiesOf(data, c);
        for (int i = 0; i < c.count; ++i) {
            const ConstraintPoint& p = c.points[static_cast<std::size_t>(i)];
            applyImpulse(on, p, p.normalImpulse * c.normal + p.tangentImpulse * leftOf(c.normal));
        }
    }
}

void turn(WorldData& data, Slot slot, double angle) {
    data.motions[slot].rotation = turned(data.motions[slot].rotation, angle);
    data.records[slot].turnLeft -= std::abs(angle);
}

void markPushed(WorldData& data, double dt) {
    for (const Constraint& c : data.constraints) {
        for (int i = 0; i < c.count; ++i) {
            const ConstraintPoint& p = c.points[static_cast<std::size_t>(i)];
            for (BodyStep* s : {&data.steps[c.a], &data.steps[c.b]}) {
                s->pushed |= p.normalImpulse > 0;
                s->bounced |= p.normalImpulse > 0 && p.bounces;
            }
        }
    }
    for (const Slot slot : data.moving) {
        BodyStep& s = data.steps[slot];
        if (s.pushed) {
            s.shift = dt * data.motions[slot].velocity;
            s.turn = dt * data.motions[slot].angularVelocity;
        }
        if (s.bounced) { // flies freely from here on: the velocity is that at the end, the way is that of the mean
            s.shift -= 0.5 * dt * dt * s.acceleration;
        }
    }
}

} // namespace

void solveVelocities(WorldData& data, const IterationStep& step) {
    warmStart(data);
    for (int pass = 0; pass < step.passes; ++pass) {
        for (Constraint& c : data.constraints) {
            const Bodies on = bodiesOf(data, c);
            if (c.friction > 0) {
                solveTangents(on, c);
            }
            solveNormals(on, c, c.points[0].target, c.points[1].target);
        }
    }
    markPushed(data, step.dt);
}

void pushOut(WorldData& data, const IterationStep& step) {
    const double share = std::min(pushOutShare, pushOutRate * step.dt);
    for (const Constraint& c : data.constraints) {
        for (int i = 0; i < c.count; ++i) {
            const ConstraintPoint& p = c.points[static_cast<std::size_t>(i)];
            if (p.separation >= -linearSlop) {
                continue;
            }
            const Bodies on = bodiesOf(data, c);
            const double opened = step.dt * std::max(relativeVelocity(on, p).dot(c.normal), 0.0);
            const double excess = -linearSlop - p.separation - opened;
            if (excess <= 0) {
                continue;
            }
            const double push = std::min(share * excess, pushOutSpeed * step.dt) * p.normalMass;
            on.a.center -= push * on.a.inverseMass * c.normal;
            on.b.center += push * on.b.inverseMass * c.normal;
            turn(data, c.a, -push * on.a.inverseInertia * cross(p.armA, c.normal));
            turn(data, c.b, push * on.b.inverseInertia * cross(p.armB, c.normal));
        }
    }
}

void storeImpulses(WorldData& data) {
    for (const Constraint& c : data.constraints) {
        for (int i = 0; i < c.count; ++i) {
            const ConstraintPoint& p = c.points[static_cast<std::size_t>(i)];
            ContactPoint& kept = data.pairs[p.pair].points[p.index];
            const bool impact = kept.fresh || p.bounces;
            kept.normalImpulse = impact ? 0 : p.normalImpulse;
            kept.tangentImpulse = impact ? 0 : p.tangentImpulse;
            kept.fresh = p.normalImpulse == 0 || p.bounces;
            data.pairs[p.pair].touching |= p.normalImpulse > 0 || p.separation <= 0;
        }
    }
}

} // namespace spacetow
