#include "core/physics/contacts/update_manifold.h"

#include "core/geometry/collide.h"
#include "core/geometry/moved.h"
#include "core/physics/contacts/constraint_list.h"
#include "core/physics/contacts/contact_pool.h"
#include "core/physics/contacts/contact_rules.h"
#include "core/physics/contacts/effective_mass.h"
#include "core/physics/contacts/open_walls.h"

#include <algorithm>

namespace spacetow {

namespace {

// The manifold tolerance between moving bodies, as a share of the smaller inner radius. A larger one saves manifolds; a
// kept point at the end of a face remains that much too long.
constexpr double toleranceShare = 0.08;
// The same against static bodies, as a share of the inner radius: with more a pyramid never comes to rest.
constexpr double toleranceShareAtStatics = 0.0002;

/// Replaces the points of the contact by those of the manifold. A point with the feature of an old point gets its
/// impulse; without any such point the tangent impulse becomes 0.
void matchPoints(Contact& contact, const Manifold& manifold) {
    const std::array<ContactPoint, 2> old = contact.points;
    const int oldCount = contact.count;
    bool any = false;
    contact.count = manifold.count;
    for (int i = 0; i < manifold.count; ++i) {
        ContactPoint& point = contact.points[static_cast<std::size_t>(i)];
        point = {manifold.points[static_cast<std::size_t>(i)].feature, 0};
        for (int k = 0; k < oldCount; ++k) {
            if (old[static_cast<std::size_t>(k)].feature == point.feature) {
                point = old[static_cast<std::size_t>(k)];
                any = true;
            }
        }
    }
    contact.tangentImpulse = any ? contact.tangentImpulse : 0;
}

/// The poses of the parts of a pair at the beginning of the iteration.
struct Poses {
    Transform a, b; // b is the identity for static bodies, whose parts are in world coordinates
};

Poses posesOf(const Bodies& bodies, const Pair& pair) {
    return {bodies.plannedMotions[pair.bodyA].pose(),
            pair.staticB ? Transform{} : bodies.plannedMotions[pair.bodyB].pose()};
}

/// The pose of the first part relative to the second.
Transform relativePose(const Poses& poses, const Pair& pair) {
    return pair.staticB ? poses.a : relative(poses.a, poses.b);
}

/// See toleranceLeftOf().
double toleranceLeft(const KeptManifold& kept, const Transform& now, double outerRadius) {
    if (kept.tolerance < 0) {
        return -1;
    }
    const Vec2 turned(now.rotation.c - kept.relative.rotation.c, now.rotation.s - kept.relative.rotation.s);
    const double moved = std::sqrt((now.position - kept.relative.position).squaredNorm());
    return kept.tolerance - moved - std::sqrt(turned.squaredNorm()) * outerRadius; // by the chord of the turn
}

/// Stores the manifold in local coordinates.
void keep(const Poses& poses, const Manifold& manifold, KeptManifold& kept) {
    kept.normalOnA = manifold.normalOf == NormalOf::FirstFace;
    const Transform& owner = kept.normalOnA ? poses.a : poses.b;
    kept.normal = owner.rotation.inverse() * manifold.normal;
    for (std::size_t i = 0; i < static_cast<std::size_t>(manifold.count); ++i) {
        const ManifoldPoint& from = manifold.points[i];
        KeptManifold::Point& point = kept.points[i];
        const Vec2 half = 0.5 * from.separation * manifold.normal;
        point.onA = poses.a.toLocal(from.point - half);
        point.onB = poses.b.toLocal(from.point + half);
    }
}

/// The manifold of the pair. If its one-way wall is open for the body, only the free ends of the wall collide.
Manifold manifoldOf(const ContactStage& stage, std::uint32_t index, const Poses& poses, double margin) {
    PairTable& table = stage.contacts.table;
    const Pair& pair = table.pairs[index];
    if (!isOpenFor(stage.bodies, table, index)) {
        Manifold manifold = collide(*pair.shapeA, poses.a, *pair.shapeB, poses.b, margin);
        manifold.apart = isChanging(table.flags[index].passage) ? 0 : manifold.apart;
        const bool isNew = manifold.count > 0 && stage.contacts.pool[pair.contact].count == 0;
        if (!isNew || !opensAtContact(stage.bodies, table, index, manifold)) {
            return manifold;
        }
    }
    Manifold manifold = collideOpenWall(*pair.shapeA, poses.a, *pair.shapeB, poses.b, margin);
    manifold.apart = 0; // the wall may close at any time
    return manifold;
}

/// Makes a new manifold and its tolerance. Without a point the tolerance is the distance of the parts.
void makeManifold(const ContactStage& stage, std::uint32_t index, const Poses& poses, double margin) {
    const Pair& pair = stage.contacts.table.pairs[index];
    Contact& contact = stage.contacts.pool[pair.contact];
    KeptManifold& kept = contact.manifold;
    const PlannedMotion& a = stage.bodies.plannedMotions[pair.bodyA];
    const PlannedMotion& b = stage.bodies.plannedMotions[pair.bodyB];
    kept.tolerance =
        margin + (pair.staticB ? toleranceShareAtStatics * a.innerRadius
                               : std::max(toleranceShare * std::min(a.innerRadius, b.innerRadius), linearSlop));
    const Manifold manifold = manifoldOf(stage, index, poses, kept.tolerance);
    matchPoints(contact, manifold);
    kept.relative = relativePose(poses, pair);
    if (manifold.count == 0) {
        kept.tolerance =
            manifold.apart > 0 ? manifold.apart : -1; // 0: that they do not touch has another reason, which may end
    } else {
        keep(poses, manifold, kept);
        // A normal between two corners changes with any motion, and a bounce needs the normal at the moment of impact.
        if (manifold.normalOf == NormalOf::Corners || contact.restitution > 0 ||
            isChanging(stage.contacts.table.flags[index].passage)) {
            kept.tolerance = -1;
        }
    }
}

/// A pair without points gets a separation bound: its bodies have to move by `left` metres before it is updated.
void boundSeparation(const Bodies& bodies, Contacts& contacts, std::uint32_t index, double left) {
    const Pair& pair = contacts.table.pairs[index];
    if (contacts.pool[pair.contact].count == 0) {
        PairBound& bound = contacts.table.bounds[index];
        bound.separationBound = bodies.motionOf(bound) + left;
    }
}

/// Sets the target of a point. Returns false if the point will bounce at its time of impact instead.
bool setTarget(const ContactStage& stage, const Constraint& c, ConstraintPoint& p, double perSecond) {
    p.bounces = false;
    p.target = formulas::targetVelocity(p.separation, perSecond);
    if (c.restitution > 0) {
        const Approach approach = approachOf(stage.bodies, c.a, c.b, c.normal, {p.leverA, p.leverB});
        const Target target = targetOf(approach, p.separation, c.restitution, perSecond);
        if (target.bounce == Bounce::AtImpact) {
            stage.contacts.table.pairs[p.pair].sweep = true;
            stage.flags.anySweep = true;
            stage.bodies.steps[c.a].bouncing = stage.bodies.steps[c.b].bouncing = true;
            return false;
        }
        p.target = target.velocity;
        p.bounces = target.bounce == Bounce::Now;
    }
    return true;
}

/// Appends a constraint from the kept manifold. Returns false, and appends none, if all points will bounce.
bool prepareConstraint(const ContactStage& stage, std::uint32_t index, double perSecond) {
    Pair& pair = stage.contacts.table.pairs[index];
    const Poses poses = posesOf(stage.bodies, pair);
    const Contact& contact = stage.contacts.pool[pair.contact];
    const KeptManifold& kept = contact.manifold;
    Constraint& c = stage.narrow.constraints.emplace_back();
    c.a = pair.bodyA;
    c.b = pair.bodyB;
    c.unmergeable = pair.unmergeable;
    c.friction = contact.friction;
    c.restitution = contact.restitution;
    c.tangentImpulse = contact.tangentImpulse;
    c.normal = (kept.normalOnA ? poses.a : poses.b).rotation * kept.normal;
    for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(contact.count); ++i) {
        const KeptManifold::Point& from = kept.points[i];
        const Vec2 onA = poses.a.toWorld(from.onA);
        const Vec2 onB = poses.b.toWorld(from.onB);
        ConstraintPoint& p = c.points[static_cast<std::size_t>(c.count)];
        p.separation = (onB - onA).dot(c.normal);
        p.armA = 0.5 * (onA + onB) - poses.a.position;
        setLevers(stage.bodies, c, p);
        p.normalImpulse = contact.points[i].normalImpulse;
        p.pair = index;
        p.contact = pair.contact;
        p.index = i;
        c.count += setTarget(stage, c, p, perSecond) ? 1 : 0;
    }
    if (c.count == 0) {
        stage.narrow.constraints.pop_back();
        return false;
    }
    setCouplingAndFriction(stage.bodies, c);
    return true;
}

double marginOf(const Bodies& bodies, const Pair& pair) {
    const PlannedMotion& a = bodies.plannedMotions[pair.bodyA];
    return pair.staticB ? speculativeMargin(a) : speculativeMargin(a, bodies.plannedMotions[pair.bodyB]);
}

/// Makes a new manifold unless the kept one is still valid.
void updateKeptManifold(const ContactStage& stage, std::uint32_t index) {
    const Pair& pair = stage.contacts.table.pairs[index];
    const KeptManifold& kept = stage.contacts.pool[pair.contact].manifold;
    const double margin = marginOf(stage.bodies, pair);
    const Poses poses = posesOf(stage.bodies, pair);
    double left = toleranceLeft(kept, relativePose(poses, pair), stage.bodies.extents[pair.bodyA].outerRadius);
    if (left < margin) {
        makeManifold(stage, index, poses, margin);
        left = kept.tolerance;
    }
    boundSeparation(stage.bodies, stage.contacts, index, left);
}

} // namespace

double toleranceLeftOf(const Bodies& bodies, const Contacts& contacts, const Pair& pair) {
    const KeptManifold& kept = contacts.pool[pair.contact].manifold;
    return toleranceLeft(kept, relativePose(posesOf(bodies, pair), pair), bodies.extents[pair.bodyA].outerRadius);
}

double separationBoundOf(const Bodies& bodies, const Contacts& contacts, const Pair& pair) {
    if (pair.kind != PairKind::General || pair.contact == Pair::none || contacts.pool[pair.contact].count > 0) {
        return 0;
    }
    return std::max(toleranceLeftOf(bodies, contacts, pair), 0.0);
}

void updateManifold(const ContactStage& stage, std::uint32_t index, double perSecond) {
    Pair& pair = stage.contacts.table.pairs[index];
    // listCandidates() has tested the circles of pairs without a contact.
    if (pair.contact != Pair::none && stage.contacts.pool[pair.contact].count == 0 && !pair.staticB) {
        PairBound& bound = stage.contacts.table.bounds[index];
        const BoundingCircles circles = boundingCirclesOf(stage.bodies, bound);
        if (circles.areApart()) {
            freeContact(stage.contacts, stage.narrow, pair);
            bound.separationBound = stage.bodies.motionOf(bound) + circles.separation();
            return;
        }
    }
    const Contact& contact = contactOf(stage.bodies, stage.contacts, pair);
    updateKeptManifold(stage, index);
    if (contact.count > 0) {
        prepareConstraint(stage, index, perSecond);
    }
}

void remakeManifold(const ContactStage& stage, std::uint32_t index, double perSecond) {
    Pair& pair = stage.contacts.table.pairs[index];
    const Contact& contact = stage.contacts.pool[pair.contact];
    pair.sweep = false;
    saveImpulses(stage.contacts, stage.constraints, stage.constraints.generalContacts[contact.constraintIndex]);
    makeManifold(stage, index, posesOf(stage.bodies, pair), marginOf(stage.bodies, pair));
    if (contact.count > 0 && prepareConstraint(stage, index, perSecond)) {
        rewriteConstraint(stage, stage.narrow.constraints.back(), perSecond);
        stage.narrow.constraints.pop_back();
    } else {
        removeConstraint(stage.contacts, stage.constraints, index);
        boundSeparation(stage.bodies, stage.contacts, index, contact.manifold.tolerance);
    }
}

} // namespace spacetow
