#include "core/physics/general_contacts.h"

#include "core/geometry/collide.h"
#include "core/geometry/moved.h"
#include "core/physics/contact_pool.h"
#include "core/physics/contact_rules.h"

#include <algorithm>

namespace spacetow {

namespace {

// How far parts may move against each other, as a share of the smaller inner radius, before their manifold is made
// anew.
constexpr double keptShare = 0.02;
// Against walls: on which side of one something is may be a matter of little.
constexpr double keptShareAtWalls = 0.0002;
// Points of merged contacts that are no further apart are one, m.
constexpr double coincident = 1e-9;

/// A body that may only turn cannot yield to a push through its centre.
double inverseOrZero(double x) {
    return x > 0 ? 1 / x : 0;
}

struct Levers {
    double a, b;
};

double massOf(const BodyMotion& a, const BodyMotion& b, const Levers& levers) {
    return inverseOrZero(a.inverseMass + b.inverseMass + a.inverseInertia * levers.a * levers.a +
                         b.inverseInertia * levers.b * levers.b);
}

double couplingOf(const BodyMotion& a, const BodyMotion& b, const Levers& l1, const Levers& l2) {
    return a.inverseMass + b.inverseMass + a.inverseInertia * l1.a * l2.a + b.inverseInertia * l1.b * l2.b;
}

/// Points of the last iteration hand their impulses to those that bring the same corners and faces together.
void matchPoints(Contact& contact, const Manifold& manifold) {
    const std::array<ContactPoint, 2> old = contact.points;
    const int oldCount = contact.count;
    bool any = false;
    contact.count = manifold.count;
    for (int i = 0; i < manifold.count; ++i) {
        ContactPoint& point = contact.points[static_cast<std::size_t>(i)];
        point = {manifold.points[static_cast<std::size_t>(i)].feature, true, 0};
        for (int k = 0; k < oldCount; ++k) {
            if (old[static_cast<std::size_t>(k)].feature == point.feature) {
                point = old[static_cast<std::size_t>(k)];
                any = true;
            }
        }
    }
    contact.tangentImpulse = any ? contact.tangentImpulse : 0;
}

struct Poses {
    Transform a, b; // b is the identity for static bodies, whose parts are in world coordinates
    Transform relative;
};

Poses posesOf(const WorldData& data, const Pair& pair) {
    const Transform a = data.pose(pair.bodyA);
    if (pair.staticB) {
        return {a, {}, a};
    }
    const Transform b = data.pose(pair.bodyB);
    return {a, b, relative(a, b)};
}

/// How much nearer the points of A may still come to B, m, before the manifold may lack something.
double roomLeft(const KeptManifold& kept, const Transform& now, double outerRadius) {
    if (kept.room < 0) {
        return -1;
    }
    const Vec2 turned(now.rotation.c - kept.relative.rotation.c, now.rotation.s - kept.relative.rotation.s);
    const double moved = std::sqrt((now.position - kept.relative.position).squaredNorm());
    return kept.room - moved - std::sqrt(turned.squaredNorm()) * outerRadius; // by the chord of the turn
}

void keep(const WorldData& data, const Pair& pair, const Poses& poses, const Manifold& manifold, KeptManifold& kept) {
    const BodyMotion& a = data.motions[pair.bodyA];
    const BodyMotion& b = data.motions[pair.bodyB];
    kept.relative = poses.relative;
    kept.normalOfA = manifold.normalOf == NormalOf::FirstFace;
    const Transform& owner = kept.normalOfA ? poses.a : poses.b;
    kept.normal = owner.rotation.inverse() * manifold.normal;
    const Vec2 tangent = leftOf(manifold.normal);
    for (std::size_t i = 0; i < static_cast<std::size_t>(manifold.count); ++i) {
        const ManifoldPoint& from = manifold.points[i];
        KeptManifold::Point& point = kept.points[i];
        const Vec2 half = 0.5 * from.separation * manifold.normal;
        point.onA = poses.a.toLocal(from.point - half);
        point.onB = poses.b.toLocal(from.point + half);
        const Vec2 armA = from.point - a.center;
        const Vec2 armB = from.point - b.center;
        point.leverA = cross(armA, manifold.normal);
        point.leverB = cross(armB, manifold.normal);
        point.tangentLeverA = cross(armA, tangent);
        point.tangentLeverB = cross(armB, tangent);
        point.normalMass = massOf(a, b, {point.leverA, point.leverB});
    }
    if (manifold.count == 2) {
        const KeptManifold::Point& p = kept.points[0];
        const KeptManifold::Point& q = kept.points[1];
        kept.coupling = couplingOf(a, b, {p.leverA, p.leverB}, {q.leverA, q.leverB});
    }
}

/// A new manifold; without a point in it the parts are let go until they may have met.
void makeManifold(WorldData& data, std::uint32_t index, const Poses& poses, double margin) {
    const Pair& pair = data.table.pairs[index];
    Contact& contact = data.contacts[pair.contact];
    KeptManifold& kept = data.manifolds[contact.manifold];
    const BodyStep& a = data.steps[pair.bodyA];
    const BodyStep& b = data.steps[pair.bodyB];
    kept.room = margin + (pair.staticB ? keptShareAtWalls * a.innerRadius
                                       : std::max(keptShare * std::min(a.innerRadius, b.innerRadius), linearSlop));
    const Manifold manifold = collide(*pair.shapeA, poses.a, *pair.shapeB, poses.b, kept.room);
    matchPoints(contact, manifold);
    if (manifold.count == 0) {
        kept.relative = poses.relative;
        kept.room = manifold.apart > 0 ? manifold.apart : -1; // what is not a matter of distance may change at once
    } else {
        keep(data, pair, poses, manifold, kept);
        // The normal between two corners turns with every move, and a bounce wants the normal of its moment.
        if (manifold.normalOf == NormalOf::Corners || contact.restitution > 0) {
            kept.room = -1;
        }
    }
}

/// Until its bodies have travelled as far as is left of its room, a manifold need not be looked at; and without a
/// point in it, nor need the pair.
void postpone(WorldData& data, std::uint32_t index, double left) {
    const Pair& pair = data.table.pairs[index];
    const Contact& contact = data.contacts[pair.contact];
    const double until = data.steps[pair.bodyA].travelled + data.steps[pair.bodyB].travelled + left;
    data.manifolds[contact.manifold].holdsUntil = until;
    if (contact.count == 0) {
        data.table.gates[index].apartUntil = until;
    }
}

Approach approach(const WorldData& data, const Constraint& c, const ConstraintPoint& p) {
    const BodyStep& sa = data.steps[c.a];
    const BodyStep& sb = data.steps[c.b];
    const BodyMotion& ma = data.motions[c.a];
    const BodyMotion& mb = data.motions[c.b];
    const double before = (sb.startVelocity - sa.startVelocity).dot(c.normal) + sb.startAngularVelocity * p.leverB -
                          sa.startAngularVelocity * p.leverA;
    const double after =
        (mb.velocity - ma.velocity).dot(c.normal) + mb.angularVelocity * p.leverB - ma.angularVelocity * p.leverA;
    return {-before, -after};
}

/// Sets what the normal velocity at a point is to be; false when it is to be swept instead.
bool setTarget(WorldData& data, Pair& pair, const Constraint& c, ConstraintPoint& p, double perSecond) {
    p.bounces = false;
    p.target = p.separation > 0 ? -p.separation * perSecond : 0;
    if (c.restitution > 0) {
        const Target target = targetOf(approach(data, c, p), p.separation, c.restitution, perSecond);
        if (target.meeting == Meeting::WillBounce) {
            pair.sweep = true;
            data.anySweep = true;
            return false;
        }
        p.target = target.velocity;
        p.bounces = target.meeting == Meeting::Bounces;
    }
    return true;
}

/// Friction acts half way between the points.
void setTangent(const WorldData& data, Constraint& c) {
    const ConstraintPoint& p = c.points[0];
    const ConstraintPoint& q = c.points[c.count == 2 ? 1 : 0];
    c.tangentLeverA = 0.5 * (p.tangentLeverA + q.tangentLeverA);
    c.tangentLeverB = 0.5 * (p.tangentLeverB + q.tangentLeverB);
    c.tangentMass = massOf(data.motions[c.a], data.motions[c.b], {c.tangentLeverA, c.tangentLeverB});
}

/// Whether the discs around the bodies tell already that they are apart.
bool outOfReach(const WorldData& data, const Pair& pair) {
    const BodyStep& a = data.steps[pair.bodyA];
    const BodyStep& b = data.steps[pair.bodyB];
    const double reach = a.outerRadius + b.outerRadius + contactMargin(a, b);
    return (data.motions[pair.bodyB].center - data.motions[pair.bodyA].center).squaredNorm() > reach * reach;
}

void addConstraint(WorldData& data, std::uint32_t index, const Transform& poseA, const Transform& poseB,
                   double perSecond) {
    Pair& pair = data.table.pairs[index];
    const Contact& contact = data.contacts[pair.contact];
    const KeptManifold& kept = data.manifolds[contact.manifold];
    Constraint& c = data.constraints.emplace_back();
    c.a = pair.bodyA;
    c.b = pair.bodyB;
    c.alone = pair.alone;
    c.friction = contact.friction;
    c.restitution = contact.restitution;
    c.tangentImpulse = contact.tangentImpulse;
    c.normal = (kept.normalOfA ? poseA : poseB).rotation * kept.normal;
    for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(contact.count); ++i) {
        const KeptManifold::Point& from = kept.points[i];
        const Vec2 onA = poseA.toWorld(from.onA);
        const Vec2 onB = poseB.toWorld(from.onB);
        ConstraintPoint& p = c.points[static_cast<std::size_t>(c.count)];
        p.separation = (onB - onA).dot(c.normal);
        p.armA = 0.5 * (onA + onB) - poseA.position;
        p.leverA = from.leverA;
        p.leverB = from.leverB;
        p.tangentLeverA = from.tangentLeverA;
        p.tangentLeverB = from.tangentLeverB;
        p.normalMass = from.normalMass;
        p.normalImpulse = contact.points[i].normalImpulse;
        p.pair = index;
        p.contact = pair.contact;
        p.index = i;
        c.count += setTarget(data, pair, c, p, perSecond) ? 1 : 0;
    }
    if (c.count == 0) {
        data.constraints.pop_back();
        return;
    }
    c.coupling = kept.coupling;
    setTangent(data, c);
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

/// Whether the outermost two points of both stand for all: none between them is deeper than they are.
bool isFlat(const Constraint& c, const Constraint& d) {
    const Vec2 tangent = leftOf(c.normal);
    std::array<Vec2, 4> points; // along the plane, and above it
    std::size_t count = 0;
    for (const Constraint* from : {&c, &d}) {
        for (std::size_t i = 0; i < static_cast<std::size_t>(from->count); ++i) {
            points[count++] = {from->points[i].armA.dot(tangent), from->points[i].separation};
        }
    }
    const auto byPlace = [](const Vec2& p, const Vec2& q) { return p.x() < q.x(); };
    const auto [first, last] = std::minmax_element(points.begin(), points.begin() + count, byPlace);
    const Vec2 along = *last - *first;
    return std::all_of(points.begin(), points.begin() + count, [&](const Vec2& p) {
        const double share = along.x() > 0 ? (p.x() - first->x()) / along.x() : 0;
        return p.y() >= first->y() + share * along.y() - linearSlop;
    });
}

/// Levers and masses from the arms.
void prepareAgain(const WorldData& data, Constraint& c) {
    const BodyMotion& a = data.motions[c.a];
    const BodyMotion& b = data.motions[c.b];
    const Vec2 tangent = leftOf(c.normal);
    for (std::size_t i = 0; i < static_cast<std::size_t>(c.count); ++i) {
        ConstraintPoint& p = c.points[i];
        const Vec2 armB = p.armA + a.center - b.center;
        p.leverA = cross(p.armA, c.normal);
        p.leverB = cross(armB, c.normal);
        p.tangentLeverA = cross(p.armA, tangent);
        p.tangentLeverB = cross(armB, tangent);
        p.normalMass = massOf(a, b, {p.leverA, p.leverB});
    }
    if (c.count == 2) {
        const ConstraintPoint& p = c.points[0];
        const ConstraintPoint& q = c.points[1];
        c.coupling = couplingOf(a, b, {p.leverA, p.leverB}, {q.leverA, q.leverB});
    }
    setTangent(data, c);
}

ContactPoint& keptPoint(WorldData& data, const ConstraintPoint& p) {
    return data.contacts[p.contact].points[p.index];
}

/// Of two points at one place: the first goes on with what the second carried.
void takeOver(WorldData& data, ConstraintPoint& p, const ConstraintPoint& gone) {
    p.normalImpulse += gone.normalImpulse;
    keptPoint(data, p).fresh &= keptPoint(data, gone).fresh;
    keptPoint(data, gone).fresh = true;
}

/// Keeps the outermost two of the points of both; where two coincide, that of the contact with more points, which will
/// still be there when the body has turned a little.
void absorb(WorldData& data, Constraint& c, Constraint& d) {
    const Vec2 tangent = leftOf(c.normal);
    std::array<ConstraintPoint, 4> all;
    std::array<double, 4> places;
    std::size_t count = 0;
    const bool cFirst = c.count >= d.count;
    for (const Constraint* from : {cFirst ? &c : &d, cFirst ? &d : &c}) {
        for (int i = 0; i < from->count; ++i) {
            all[count] = from->points[static_cast<std::size_t>(i)];
            places[count] = all[count].armA.dot(tangent);
            ++count;
        }
    }
    std::size_t least = 0;
    std::size_t most = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const ConstraintPoint& p = all[i];
        data.table.marks[p.pair].now |= p.separation <= linearSlop;
        keptPoint(data, p).normalImpulse = 0;
        data.contacts[p.contact].tangentImpulse = 0;
        least = places[i] < places[least] - coincident ? i : least;
        most = places[i] > places[most] + coincident ? i : most;
    }
    for (std::size_t i = 0; i < count; ++i) {
        if (i != least && places[i] <= places[least] + coincident) {
            takeOver(data, all[least], all[i]);
        } else if (i != most && places[i] >= places[most] - coincident) {
            takeOver(data, all[most], all[i]);
        }
    }
    c.points[0] = all[least];
    c.points[1] = all[most];
    c.count = 2;
    if (least == most) {
        c.count = 1;
        c.silenceSecond();
    }
    c.tangentImpulse += d.tangentImpulse;
    d.count = 0;
}

} // namespace

double roomBetween(const WorldData& data, const Pair& pair) {
    if (pair.kind != PairKind::General || pair.contact == Pair::none || data.contacts[pair.contact].count > 0) {
        return 0;
    }
    const KeptManifold& kept = data.manifolds[data.contacts[pair.contact].manifold];
    return std::max(roomLeft(kept, posesOf(data, pair).relative, data.steps[pair.bodyA].outerRadius), 0.0);
}

void meetGeneral(WorldData& data, std::uint32_t index, double perSecond) {
    Pair& pair = data.table.pairs[index];
    if (pair.contact == Pair::none && !pair.staticB && outOfReach(data, pair)) {
        return;
    }
    const Contact& contact = contactOf(data, pair);
    const PairGate& gate = data.table.gates[index];
    const double travelled = data.travelled[gate.moverA] + data.travelled[gate.moverB];
    if (travelled + linearSlop >= data.manifolds[contact.manifold].holdsUntil) {
        if (contact.count == 0 && !pair.staticB && outOfReach(data, pair)) {
            forgetContact(data, pair);
            return;
        }
        const BodyStep& a = data.steps[pair.bodyA];
        const double margin = pair.staticB ? contactMargin(a) : contactMargin(a, data.steps[pair.bodyB]);
        const Poses poses = posesOf(data, pair);
        const KeptManifold& kept = data.manifolds[contact.manifold];
        double left = roomLeft(kept, poses.relative, a.outerRadius);
        if (left < margin) {
            makeManifold(data, index, poses, margin);
            left = kept.room;
        }
        postpone(data, index, left);
    }
    if (contact.count > 0) {
        addConstraint(data, index, data.pose(pair.bodyA), pair.staticB ? Transform{} : data.pose(pair.bodyB),
                      perSecond);
    }
}

/// A flat face on several walls of one plane, or several parts of a body on one wall, is one contact: the solver then
/// finds its impulses at once, whatever the order of the walls and parts.
void finishGeneral(WorldData& data) {
    std::vector<Constraint>& all = data.constraints;
    bool merged = false;
    for (std::size_t first = 0, end = 0; first < all.size(); first = end) {
        for (end = first + 1; end < all.size() && all[end].a == all[first].a; ++end) {
            for (std::size_t i = first; i < end && !all[end].alone; ++i) {
                if (all[i].count > 0 && samePlane(data, all[i], all[end]) && isFlat(all[i], all[end])) {
                    absorb(data, all[i], all[end]);
                    prepareAgain(data, all[i]);
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

} // namespace spacetow
