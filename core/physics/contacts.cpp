#include "core/physics/contacts.h"

#include "core/geometry/collide.h"
#include "core/geometry/overlaps.h"

#include <algorithm>
#include <cmath>

namespace spacetow {

namespace {

// Slower impacts come to rest, m/s.
constexpr double bounceThreshold = 0.005;

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

Vec2 pointVelocity(const BodyMotion& m, const Vec2& arm) {
    return m.velocity + cross(m.angularVelocity, arm);
}

struct Approach {
    double before; // m/s along the normal at the beginning of the iteration, positive when closing
    double after;  // with this iteration's forces
};

Approach approachAt(const WorldData& data, const Constraint& c, const ConstraintPoint& p) {
    const BodyStep& sa = data.steps[c.a];
    const BodyStep& sb = data.steps[c.b];
    const Vec2 before = sb.startVelocity + cross(sb.startAngularVelocity, p.armB) - sa.startVelocity -
                        cross(sa.startAngularVelocity, p.armA);
    const Vec2 after = pointVelocity(data.motions[c.b], p.armB) - pointVelocity(data.motions[c.a], p.armA);
    return {-before.dot(c.normal), -after.dot(c.normal)};
}

enum class Contact : std::uint8_t { Rests, Bounces, WillBounce };

/// Sets what the normal velocity is to be. Surfaces that touch bounce at once, and fall back under this iteration's
/// forces; those still apart are to be stopped where they meet.
Contact setTarget(const WorldData& data, const Constraint& c, ConstraintPoint& p, double dt) {
    p.target = p.separation > 0 ? -p.separation / dt : 0;
    p.bounces = false;
    if (c.restitution == 0) {
        return Contact::Rests;
    }
    const Approach approach = approachAt(data, c, p);
    if (p.separation > linearSlop) {
        const bool meets = std::max(approach.before, approach.after) * dt > p.separation - linearSlop;
        return meets && approach.after > bounceThreshold ? Contact::WillBounce : Contact::Rests;
    }
    const double rebound = c.restitution * approach.before - (approach.after - approach.before);
    if (approach.before > bounceThreshold && rebound > 0) {
        p.target = rebound;
        p.bounces = true;
        return Contact::Bounces;
    }
    return Contact::Rests;
}

/// A body that may only turn cannot yield to a push through its centre.
double inverseOrZero(double x) {
    return x > 0 ? 1 / x : 0;
}

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

void addConstraint(WorldData& data, std::uint32_t index, const Manifold& manifold, const IterationStep& step) {
    Pair& pair = data.pairs[index];
    const BodyRecord& ra = data.records[pair.bodyA];
    const BodyRecord& rb = data.records[pair.bodyB];
    Constraint c;
    c.a = pair.bodyA;
    c.b = pair.bodyB;
    c.normal = manifold.normal;
    c.friction = std::sqrt(ra.friction * rb.friction);
    c.restitution = std::clamp(0.5 * (ra.restitution + rb.restitution), 0.0, 1.0);
    for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(manifold.count); ++i) {
        ConstraintPoint& p = c.points[static_cast<std::size_t>(c.count)];
        p.armA = manifold.points[i].point - data.motions[pair.bodyA].center;
        p.armB = manifold.points[i].point - data.motions[pair.bodyB].center;
        p.separation = manifold.points[i].separation;
        p.normalImpulse = pair.points[i].normalImpulse;
        p.tangentImpulse = pair.points[i].tangentImpulse;
        p.pair = index;
        p.index = i;
        if (setTarget(data, c, p, step.dt) == Contact::WillBounce) {
            pair.sweep = true;
        } else {
            ++c.count;
        }
    }
    if (c.count > 0) {
        data.constraints.push_back(c);
    }
}

bool samePlane(const WorldData& data, const Constraint& c, const Constraint& d) {
    const bool sameBodies =
        c.b == d.b || (data.records[c.b].kind == BodyKind::Static && data.records[d.b].kind == BodyKind::Static);
    if (!sameBodies || c.friction != d.friction || c.restitution != d.restitution ||
        c.normal.dot(d.normal) < 1 - 1e-9) {
        return false;
    }
    // Points lie half way between the surfaces; half the separation further on is the surface of b.
    const double planeC = c.points[0].armA.dot(c.normal) + 0.5 * c.points[0].separation;
    const double planeD = d.points[0].armA.dot(c.normal) + 0.5 * d.points[0].separation;
    return std::abs(planeC - planeD) < 1e-6;
}

/// Keeps the outermost two of the points of both.
void absorb(WorldData& data, Constraint& c, Constraint& d) {
    const Vec2 tangent = leftOf(c.normal);
    std::array<ConstraintPoint, 4> all;
    std::size_t count = 0;
    for (const Constraint* from : {&c, &d}) {
        for (int i = 0; i < from->count; ++i) {
            all[count++] = from->points[static_cast<std::size_t>(i)];
        }
    }
    std::size_t least = 0;
    std::size_t most = 0;
    for (std::size_t i = 0; i < count; ++i) {
        ConstraintPoint& p = all[i];
        p.armB = p.armA + data.motions[c.a].center - data.motions[c.b].center;
        data.pairs[p.pair].touching |= p.separation <= linearSlop;
        const double t = p.armA.dot(tangent);
        least = t < all[least].armA.dot(tangent) ? i : least;
        most = t > all[most].armA.dot(tangent) ? i : most;
    }
    c.points[0] = all[least];
    c.points[1] = all[most];
    c.count = least == most ? 1 : 2;
    d.count = 0;
}

/// A flat face on several walls of one plane, or several parts of a body on one wall, is one contact: the solver then
/// finds its impulses at once, whatever the order of the walls and parts.
void mergePlanes(WorldData& data) {
    std::vector<Constraint>& all = data.constraints;
    bool merged = false;
    for (std::size_t first = 0, end = 0; first < all.size(); first = end) {
        for (end = first + 1; end < all.size() && all[end].a == all[first].a; ++end) {
            for (std::size_t i = first; i < end; ++i) {
                if (all[i].count > 0 && samePlane(data, all[i], all[end])) {
                    absorb(data, all[i], all[end]);
                    merged = true;
                    break;
                }
            }
        }
    }
    if (merged) {
        std::erase_if(all, [](const Constraint& c) { return c.count == 0; });
    }
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

void findContacts(WorldData& data, const IterationStep& step) {
    data.constraints.clear();
    for (std::uint32_t i = 0; i < data.pairs.size(); ++i) {
        Pair& pair = data.pairs[i];
        if (!pair.solid || !movable(data.motions[pair.bodyA], data.motions[pair.bodyB])) {
            continue;
        }
        pair.touching = false;
        pair.sweep = false;
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
    mergePlanes(data);
    for (Constraint& c : data.constraints) {
        prepareMasses(data, c);
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
