#include "core/physics/contacts/narrow_phase.h"

#include "core/base/prefetch.h"
#include "core/geometry/collide.h"
#include "core/geometry/overlaps.h"
#include "core/physics/contacts/candidate_pairs.h"
#include "core/physics/contacts/constraint_list.h"
#include "core/physics/contacts/contact_pool.h"
#include "core/physics/contacts/contact_rules.h"
#include "core/physics/contacts/merge_contacts.h"
#include "core/physics/contacts/open_walls.h"
#include "core/physics/contacts/order_constraints.h"
#include "core/physics/contacts/update_manifold.h"
#include "core/physics/lanes/solver_kernels.h"

#include <algorithm>
#include <cmath>

namespace spacetow {

namespace {

/// The parts are apart: the pair gets a separation bound.
void separate(const ContactStage& stage, std::uint32_t index, double separation) {
    Pair& pair = stage.contacts.table.pairs[index];
    if (stage.contacts.table.flags[index].inSolver) {
        removeConstraint(stage.contacts, stage.constraints, index);
    }
    freeContact(stage.contacts, stage.narrow, pair);
    PairBound& bound = stage.contacts.table.bounds[index];
    bound.separationBound = stage.bodies.motionOf(bound) + separation;
}

/// The circles bounce at their time of impact, and have no constraint until then.
void sweepCircles(const ContactStage& stage, std::uint32_t index, std::uint32_t feature) {
    Pair& pair = stage.contacts.table.pairs[index];
    if (stage.contacts.table.flags[index].inSolver) {
        saveImpulses(stage.contacts, stage.constraints,
                     stage.constraints.circleContacts[stage.contacts.pool[pair.contact].constraintIndex]);
        removeConstraint(stage.contacts, stage.constraints, index);
    }
    matchFeature(stage.contacts.pool[pair.contact], feature);
    pair.sweep = true;
    stage.flags.anySweep = true;
    stage.bodies.steps[pair.bodyA].bouncing = stage.bodies.steps[pair.bodyB].bouncing = true;
}

void addCircleContact(const ContactStage& stage, std::uint32_t index, const CircleManifold& touch, double perSecond) {
    Pair& pair = stage.contacts.table.pairs[index];
    const Contact& kept = contactOf(stage.bodies, stage.contacts, pair);
    const double closing = formulas::closingLimit(touch.separation, perSecond);
    CircleTarget aim{formulas::targetVelocity(touch.separation, perSecond), closing, false};
    if (kept.restitution > 0) {
        const Approach approach = approachOf(stage.bodies, pair.bodyA, pair.bodyB, touch.normal, {0, 0});
        const Target target = targetOf(approach, touch.separation, kept.restitution, perSecond);
        if (target.bounce == Bounce::AtImpact) {
            sweepCircles(stage, index, touch.feature);
            return;
        }
        const double limit = closingLimit(touch.separation, target.velocity, kept.restitution, perSecond);
        aim = {target.velocity, limit, target.bounce == Bounce::Now};
    }
    addCircleConstraint(stage, index, touch, aim);
}

void updateCircles(const ContactStage& stage, std::uint32_t index, double perSecond) {
    const Pair& pair = stage.contacts.table.pairs[index];
    const PlannedMotion& a = stage.bodies.plannedMotions[pair.bodyA];
    const PlannedMotion& b = stage.bodies.plannedMotions[pair.bodyB];
    const double radiusA = stage.bodies.extents[pair.bodyA].outerRadius;
    const double radiusB = stage.bodies.extents[pair.bodyB].outerRadius;
    const Vec2 apart = b.center - a.center;
    const double margin = speculativeMargin(a, b);
    const double reach = radiusA + radiusB + margin;
    const double squared = apart.squaredNorm();
    const double distance = std::sqrt(squared);
    if (squared > reach * reach) {
        separate(stage, index, distance - radiusA - radiusB);
        return;
    }
    const Vec2 normal = distance > 0 ? Vec2(apart / distance) : Vec2(0, 1);
    addCircleContact(stage, index, {normal, distance - radiusA - radiusB, radiusA, radiusB, 0}, perSecond);
}

/// The manifold of a static edge and a circle. If the edge is open for the body, only its free ends collide.
Manifold edgeManifold(const ContactStage& stage, std::uint32_t index, const Circle& circle, double margin) {
    PairTable& table = stage.contacts.table;
    const Pair& pair = table.pairs[index];
    const WallSide& side = stage.broadPhase.staticCollider(pair.collider).side;
    if (!isOpenForCircle(stage.bodies, table, index, side)) {
        Manifold manifold = sideAgainstCircle(side, circle, margin);
        manifold.apart = isChanging(table.flags[index].passage) ? 0 : manifold.apart;
        const bool isNew = manifold.count > 0 && pair.contact == Pair::none;
        if (!isNew || !opensAtContact(stage.bodies, table, index, manifold)) {
            return manifold;
        }
    }
    Manifold manifold = collideOpenWall(*pair.shapeB, {}, circle, {}, margin);
    manifold.apart = 0; // the wall may close at any time
    return manifold;
}

void updateCircleAtStatic(const ContactStage& stage, std::uint32_t index, double perSecond) {
    Pair& pair = stage.contacts.table.pairs[index];
    const PlannedMotion& way = stage.bodies.plannedMotions[pair.bodyA];
    const Circle circle{way.center, std::get<Circle>(*pair.shapeA).radius};
    const double margin = speculativeMargin(way);
    const Manifold manifold = pair.kind == PairKind::CircleEdge ? edgeManifold(stage, index, circle, margin)
                                                                : collideCircle(*pair.shapeB, circle, margin);
    if (manifold.count == 0) {
        separate(stage, index, manifold.apart);
        return;
    }
    const ManifoldPoint& point = manifold.points[0];
    addCircleContact(stage, index, {-manifold.normal, point.separation, circle.radius, 0, point.feature}, perSecond);
}

SPACETOW_PREFETCHES void prefetchWall(const BroadPhase& broadPhase, const Pair& pair) {
    if (pair.kind == PairKind::CircleEdge) {
        prefetch(broadPhase.staticCollider(pair.collider).side);
    }
}

/// Prefetches a pair, and later its contact: contacts lie in memory in the order of their creation, not of their pairs.
SPACETOW_PREFETCHES void prefetchAhead(const Contacts& contacts, const std::vector<std::uint32_t>& candidates,
                                       std::size_t at) {
    constexpr std::size_t ahead = 6;
    const std::vector<Pair>& pairs = contacts.table.pairs;
    if (at + 3 * ahead < candidates.size()) {
        __builtin_prefetch(&pairs[candidates[at + 3 * ahead]]);
    }
    if (at + 2 * ahead >= candidates.size()) {
        return;
    }
    const Pair& pair = pairs[candidates[at + 2 * ahead]];
    if (pair.contact != Pair::none) {
        const Contact& contact = contacts.pool[pair.contact];
        pair.kind == PairKind::General ? prefetch(contact) : __builtin_prefetch(&contact);
    }
}

/// Prefetches the parts and bodies of a pair whose manifold is made anew.
SPACETOW_PREFETCHES void prefetchShapes(const Bodies& bodies, const Contacts& contacts,
                                        const std::vector<std::uint32_t>& candidates, std::size_t at) {
    constexpr std::size_t ahead = 3;
    if (at + ahead < candidates.size() && contacts.table.pairs[candidates[at + ahead]].kind == PairKind::General) {
        const Pair& pair = contacts.table.pairs[candidates[at + ahead]];
        prefetch(*pair.shapeA);
        prefetch(*pair.shapeB);
        prefetch(bodies.motions[pair.bodyA]);
        prefetch(bodies.motions[pair.bodyB]);
    }
}

/// The motion of the body in this iteration, from its planned start to its final pose.
ExactSweep sweepOf(const Bodies& bodies, Slot slot) {
    const Transform end = bodies.pose(slot);
    if (bodies.records[slot].asleep) {
        return ExactSweep(end);
    }
    const BodyStep& s = bodies.steps[slot];
    return {{.start = bodies.plannedMotions[slot].pose(), .translation = s.deltaPosition, .turn = s.deltaAngle}, end};
}

/// Sets `touching` and `passed` of a sensor pair.
void updateSensor(const Bodies& bodies, const Pair& pair, PairFlags& flags) {
    const ExactSweep a = sweepOf(bodies, pair.bodyA);
    const ExactSweep b = pair.staticB ? ExactSweep(Transform{}) : sweepOf(bodies, pair.bodyB);
    flags.touching = overlaps(*pair.shapeA, a.end, *pair.shapeB, b.end);
    flags.passed = !flags.touching && !flags.reported && overlapsDuring(*pair.shapeA, a, *pair.shapeB, b);
}

/// After more changes than this the constraints are rebuilt in the order of their pairs: the memory of neighbouring
/// bodies is near again, and piles converge better.
std::size_t mostConstraintChanges(const Constraints& constraints) {
    return (constraints.circleContacts.size() + constraints.generalContacts.size()) / 8;
}

void updatePair(const ContactStage& stage, std::uint32_t index, double perSecond) {
    const PairKind kind = stage.contacts.table.pairs[index].kind;
    if (kind == PairKind::CircleCircle) {
        updateCircles(stage, index, perSecond);
    } else if (kind == PairKind::CircleEdge || kind == PairKind::CircleStatic) {
        updateCircleAtStatic(stage, index, perSecond);
    } else {
        updateManifold(stage, index, perSecond);
    }
}

void resetPair(Contacts& contacts, std::uint32_t index) {
    contacts.table.flags[index].touching = false;
    contacts.table.pairs[index].sweep = false;
}

/// Updates the pairs that have no constraint and may have come into contact.
void updateCandidates(const ContactStage& stage, double perSecond) {
    listCandidates(stage.bodies, stage.contacts, stage.narrow);
    for (std::size_t k = 0; k < stage.narrow.candidates.size(); ++k) {
        prefetchAhead(stage.contacts, stage.narrow.candidates, k);
        const std::uint32_t i = stage.narrow.candidates[k];
        if (stage.contacts.table.pairs[i].kind != PairKind::Sensor) {
            resetPair(stage.contacts, i);
            updatePair(stage, i, perSecond);
        }
    }
}

void rebuildConstraints(const ContactStage& stage, double perSecond) {
    releaseConstraints(stage.contacts, stage.constraints, stage.flags);
    resetConstraints(stage.bodies, stage.constraints, stage.flags, stage.narrow);
    stage.flags.anySweep = false;
    updateCandidates(stage, perSecond);
    mergeContacts(stage);
    orderConstraints(stage.bodies, stage.narrow);
    for (const Constraint& constraint : stage.narrow.constraints) {
        addManifoldConstraint(stage, constraint, perSecond);
    }
    findMergeCandidates(stage.bodies, stage.constraints);
    stage.constraints.constraintChanges = 0;
    stage.flags.constraintsRebuilt = true;
}

/// Updates the circle contacts that the kernel does not update.
void updateScalar(const ContactStage& stage, double perSecond) {
    constexpr std::size_t ahead = 8;
    for (std::size_t i = stage.constraints.circleContacts.size(); stage.flags.anyScalarUpdate && i-- > 0;) {
        if (i >= 2 * ahead) {
            __builtin_prefetch(&stage.contacts.table.pairs[stage.constraints.circleContacts[i - 2 * ahead].pair]);
        }
        if (i >= ahead) {
            prefetchWall(stage.broadPhase,
                         stage.contacts.table.pairs[stage.constraints.circleContacts[i - ahead].pair]);
        }
        if (stage.constraints.circleContacts[i].scalarUpdate) {
            updatePair(stage, stage.constraints.circleContacts[i].pair, perSecond);
        }
    }
}

/// Adds the pairs of outdated contacts to the candidates.
template <class Kind, class Batch>
void listOutdated(NarrowPhase& narrow, const std::vector<Kind>& list, const Batches<Batch>& batches) {
    forLanes(batches, &BatchFlags::outdated,
             [&](Lane at) { narrow.candidates.push_back(pairOf(list[batches.anchors(at.batch).owner[at.lane]])); });
}

void updateOutdated(const ContactStage& stage, double perSecond) {
    stage.narrow.candidates.clear();
    listOutdated(stage.narrow, stage.constraints.circleContacts, stage.constraints.batches.circles);
    listOutdated(stage.narrow, stage.constraints.generalContacts, stage.constraints.batches.general);
    for (std::size_t k = 0; k < stage.narrow.candidates.size(); ++k) {
        prefetchAhead(stage.contacts, stage.narrow.candidates, k);
        prefetchShapes(stage.bodies, stage.contacts, stage.narrow.candidates, k);
        const std::uint32_t pair = stage.narrow.candidates[k];
        if (stage.contacts.table.pairs[pair].kind == PairKind::General) {
            remakeManifold(stage, pair, perSecond);
        } else {
            updateCircles(stage, pair, perSecond);
        }
    }
}

bool anyMergedOutdated(const Constraints& constraints) {
    return std::any_of(
        constraints.generalContacts.begin(), constraints.generalContacts.end(), [&](const GeneralContact& c) {
            return c.merged && (constraints.batches.general.flags(c.lane.batch).outdated >> c.lane.lane & 1) != 0;
        });
}

/// Updates all constraints, then opens and closes lanes. Returns false if the constraints have to be rebuilt: they are
/// not valid, too many have changed, or other contacts than before lie in one plane.
bool updateConstraints(const ContactStage& stage, double perSecond) {
    if (!stage.flags.constraintsValid || stage.flags.mergeStale) {
        return false;
    }
    stage.flags.anySweep = stage.flags.anyBounce = stage.flags.constraintsRebuilt = false;
    stage.narrow.constraints.clear();
    const PlannedMotion* first = stage.bodies.plannedMotions.bodies();
    refreshContacts(stage.constraints.batches,
                    {{&first->center, sizeof(PlannedMotion)}, {&first->deltaPosition, sizeof(PlannedMotion)}},
                    perSecond);
    if (!stage.constraints.mergedPairs.empty() && anyMergedOutdated(stage.constraints)) {
        return false;
    }
    updateOutdated(stage, perSecond);
    updateScalar(stage, perSecond);
    updateCandidates(stage, perSecond);
    if (stage.flags.anySingular) {
        updateSingular(stage.constraints);
    }
    for (const Constraint& constraint : stage.narrow.constraints) {
        addManifoldConstraint(stage, constraint, perSecond);
        findMergeCandidatesOfLast(stage.bodies, stage.constraints);
    }
    return stage.constraints.constraintChanges <= mostConstraintChanges(stage.constraints) &&
           !anyInOnePlane(stage.contacts, stage.constraints);
}

} // namespace

void findContacts(const ContactStage& stage, const IterationStep& step) {
    const double perSecond = 1 / step.dt;
    if (!updateConstraints(stage, perSecond)) {
        rebuildConstraints(stage, perSecond);
    }
}

void findOverlaps(const Bodies& bodies, Contacts& contacts) {
    for (const std::uint32_t i : contacts.sensors) {
        updateSensor(bodies, contacts.table.pairs[i], contacts.table.flags[i]);
    }
}

} // namespace spacetow
