#include "core/physics/contacts.h"

#include "core/geometry/collide.h"
#include "core/geometry/overlaps.h"

#include <algorithm>
#include <cmath>

namespace spacetow {

namespace {

// Slower impacts come to rest, m/s.
constexpr double bounceThreshold = 0.02;

Transform poseOfB(const WorldData& data, const Pair& pair) {
    return pair.staticB ? Transform{} : data.pose(pair.bodyB);
}

/// Bodies that are out of each other's reach need no manifold.
bool farApart(const WorldData& data, const Pair& pair, double margin) {
    if (pair.staticB) {
        return false;
    }
    const double r = data.records[pair.bodyA].outerRadius + data.records[pair.bodyB].outerRadius + margin;
    return (data.motions[pair.bodyA].center - data.motions[pair.bodyB].center).squaredNorm() > r * r;
}

/// Anticipation is limited to half the inner radius: beyond it the sweep of fast bodies takes over, whose normal is
/// that of the impact and not that of the start.
double anticipation(const WorldData& data, Slot slot) {
    return std::min(data.steps[slot].reach, 0.5 * data.records[slot].innerRadius);
}

Vec2 pointVelocity(const BodyMotion& m, const Vec2& arm) { return m.velocity + cross(m.angularVelocity, arm); }

/// The speed with which a gap closes, taking into account that the bodies accelerate on the way: v² = v₀² + 2 a s.
double impactSpeed(const WorldData& data, const Constraint& c, const ConstraintPoint& p, double dt) {
    const BodyStep& sa = data.steps[c.a];
    const BodyStep& sb = data.steps[c.b];
    const Vec2 before = sb.startVelocity + cross(sb.startAngularVelocity, p.armB) - sa.startVelocity -
                        cross(sa.startAngularVelocity, p.armA);
    const double approach = -before.dot(c.normal);
    if (p.separation <= 0) {
        return approach;
    }
    const Vec2 after = pointVelocity(data.motions[c.b], p.armB) - pointVelocity(data.motions[c.a], p.armA);
    const double end = -after.dot(c.normal);
    const double acceleration = (end - approach) / dt;
    const double square = approach * std::abs(approach) + 2 * acceleration * p.separation;
    return square > 0 ? std::sqrt(square) : 0;
}

void preparePoint(const WorldData& data, const Constraint& c, ConstraintPoint& p, double dt) {
    p.target = p.separation > 0 ? -p.separation / dt : 0;
    const double speed = c.restitution > 0 ? impactSpeed(data, c, p, dt) : 0;
    p.impactSpeed = speed > bounceThreshold ? speed : 0;
}

/// A body that may only turn cannot yield to a push through its centre.
double inverseOrZero(double x) { return x > 0 ? 1 / x : 0; }

double massAlong(const Vec2& direction, const ConstraintPoint& p, const BodyMotion& a, const BodyMotion& b) {
    const double leverA = cross(p.armA, direction);
    const double leverB = cross(p.armB, direction);
    return inverseOrZero(a.inverseMass + b.inverseMass + a.inverseInertia * leverA * leverA +
                         b.inverseInertia * leverB * leverB);
}

/// Two points with nearly the same effect make the system singular; they are then solved one after the other.
void prepareBlock(const BodyMotion& a, const BodyMotion& b, Constraint& c) {
    c.block = false;
    const ConstraintPoint& p1 = c.points[0];
    const ConstraintPoint& p2 = c.points[1];
    if (p1.normalMass == 0 || p2.normalMass == 0) {
        return;
    }
    const double k11 = 1 / p1.normalMass;
    const double k22 = 1 / p2.normalMass;
    c.coupling = a.inverseMass + b.inverseMass +
                 a.inverseInertia * cross(p1.armA, c.normal) * cross(p2.armA, c.normal) +
                 b.inverseInertia * cross(p1.armB, c.normal) * cross(p2.armB, c.normal);
    c.determinant = k11 * k22 - c.coupling * c.coupling;
    c.block = std::max(k11, k22) * std::max(k11, k22) < 1000 * c.determinant;
}

void addConstraint(WorldData& data, std::uint32_t index, const Manifold& manifold, const IterationStep& step) {
    const Pair& pair = data.pairs[index];
    const BodyRecord& ra = data.records[pair.bodyA];
    const BodyRecord& rb = data.records[pair.bodyB];
    Constraint& c = data.constraints.emplace_back();
    c.a = pair.bodyA;
    c.b = pair.bodyB;
    c.pair = index;
    c.count = manifold.count;
    c.normal = manifold.normal;
    c.friction = std::sqrt(ra.friction * rb.friction);
    c.restitution = std::clamp(0.5 * (ra.restitution + rb.restitution), 0.0, 1.0);
    for (int i = 0; i < manifold.count; ++i) {
        const auto k = static_cast<std::size_t>(i);
        ConstraintPoint& p = c.points[k];
        const ContactPoint& kept = pair.points[k];
        p.armA = manifold.points[k].point - data.motions[pair.bodyA].center;
        p.armB = manifold.points[k].point - data.motions[pair.bodyB].center;
        p.separation = manifold.points[k].separation;
        p.normalImpulse = kept.normalImpulse;
        p.tangentImpulse = kept.tangentImpulse;
        preparePoint(data, c, p, step.dt);
    }
    prepareMasses(data, c);
}

/// Points of the last iteration hand their impulses to those that bring the same corners and faces together.
void matchPoints(Pair& pair, const Manifold& manifold) {
    const std::array<ContactPoint, 2> old = pair.points;
    const int oldCount = pair.count;
    pair.count = manifold.count;
    for (int i = 0; i < manifold.count; ++i) {
        ContactPoint& point = pair.points[static_cast<std::size_t>(i)];
        point = {manifold.points[static_cast<std::size_t>(i)].feature, 0, 0, true};
        for (int k = 0; k < oldCount; ++k) {
            if (old[static_cast<std::size_t>(k)].feature == point.feature) {
                point = old[static_cast<std::size_t>(k)];
            }
        }
    }
}

bool movable(const BodyMotion& a, const BodyMotion& b) {
    return a.inverseMass + b.inverseMass + a.inverseInertia + b.inverseInertia > 0;
}

} // namespace

void prepareMasses(const WorldData& data, Constraint& c) {
    const BodyMotion& a = data.motions[c.a];
    const BodyMotion& b = data.motions[c.b];
    for (int i = 0; i < c.count; ++i) {
        ConstraintPoint& p = c.points[static_cast<std::size_t>(i)];
        p.normalMass = massAlong(c.normal, p, a, b);
        p.tangentMass = massAlong(leftOf(c.normal), p, a, b);
    }
    if (c.count == 2) {
        prepareBlock(a, b, c);
    }
}

void findContacts(WorldData& data, const IterationStep& step) {
    data.constraints.clear();
    for (std::uint32_t i = 0; i < data.pairs.size(); ++i) {
        Pair& pair = data.pairs[i];
        if (!pair.solid || !movable(data.motions[pair.bodyA], data.motions[pair.bodyB])) {
            continue;
        }
        pair.touching = false;
        const double ahead = anticipation(data, pair.bodyA) + (pair.staticB ? 0 : anticipation(data, pair.bodyB));
        const double margin = linearSlop + ahead;
        if (farApart(data, pair, margin)) {
            pair.count = 0;
            continue;
        }
        const Manifold manifold =
            collide(*pair.shapeA, data.pose(pair.bodyA), *pair.shapeB, poseOfB(data, pair), margin);
        matchPoints(pair, manifold);
        if (manifold.count > 0) {
            addConstraint(data, i, manifold, step);
        }
    }
}

void findOverlaps(WorldData& data) {
    for (Pair& pair : data.pairs) {
        if (!pair.solid || !movable(data.motions[pair.bodyA], data.motions[pair.bodyB])) {
            pair.touching = overlaps(*pair.shapeA, data.pose(pair.bodyA), *pair.shapeB, poseOfB(data, pair));
        }
    }
}

} // namespace spacetow
