#include "core/physics/contacts/narrow_phase.h"

#include "core/base/prefetch.h"
#include "core/geometry/collide.h"
#include "core/geometry/overlaps.h"
#include "core/physics/contacts/candidate_pairs.h"
#include "core/physics/contacts/constraint_list.h"
#include "core/physics/contacts/contact_pool.h"
#include "core/physics/contacts/contact_rules.h"
#include "core/physics/contacts/merge_contacts.h"
#include "core/physics/contacts/order_constraints.h"
#include "core/physics/contacts/update_manifold.h"
#include "core/physics/lanes/solver_kernels.h"

#include <algorithm>
#include <cmath>

namespace spacetow {

namespace {

/// The parts are apart: the pair gets a separation bound.
void separate(WorldData& data, std::uint32_t index, double separation) {
    Pair& pair = data.contacts.table.pairs[index];
    if (data.contacts.table.flags[index].inSolver) {
        removeConstraint(data.contacts, data.constraints, index);
    }
    freeContact(data.contacts, data.scratch.narrow, pair);
    PairBound& bound = data.contacts.table.bounds[index];
    bound.separationBound = data.bodies.motionOf(bound) + separation;
}

Approach approach(const Bodies& bodies, const Pair& pair, const Vec2& normal) {
    const Vec2 before = bodies.steps[pair.bodyB].startVelocity - bodies.steps[pair.bodyA].startVelocity;
    const Vec2 after = bodies.motions[pair.bodyB].velocity - bodies.motions[pair.bodyA].velocity;
    return {-before.dot(normal), -after.dot(normal)};
}

/// Parts that are to bounce where they meet have no contact until then.
void sweepCircles(WorldData& data, std::uint32_t index, std::uint32_t feature) {
    Pair& pair = data.contacts.table.pairs[index];
    if (data.contacts.table.flags[index].inSolver) {
        saveImpulses(data.contacts, data.constraints,
                     data.constraints.circleContacts[data.contacts.pool[pair.contact].constraintIndex]);
        removeConstraint(data.contacts, data.constraints, index);
    }
    matchFeature(data.contacts.pool[pair.contact], feature);
    pair.sweep = true;
    data.flags.anySweep = true;
    data.bodies.steps[pair.bodyA].bouncing = data.bodies.steps[pair.bodyB].bouncing = true;
}

void addCircleContact(WorldData& data, std::uint32_t index, const CircleTouch& touch, double perSecond) {
    Pair& pair = data.contacts.table.pairs[index];
    const Contact& kept = contactOf(data.bodies, data.contacts, pair);
    const double closing = formulas::closingLimit(touch.separation, perSecond);
    CircleTarget aim{formulas::targetVelocity(touch.separation, perSecond), closing, false};
    if (kept.restitution > 0) {
        const Target target =
            targetOf(approach(data.bodies, pair, touch.normal), touch.separation, kept.restitution, perSecond);
        if (target.meeting == Meeting::WillBounce) {
            sweepCircles(data, index, touch.feature);
            return;
        }
        const double limit = closingLimit(touch.separation, target.velocity, kept.restitution, perSecond);
        aim = {target.velocity, limit, target.meeting == Meeting::Bounces};
    }
    addCircleConstraint(data, index, touch, aim);
}

void updateCircles(WorldData& data, std::uint32_t index, double perSecond) {
    const Pair& pair = data.contacts.table.pairs[index];
    const PlannedMotion& a = data.bodies.plannedMotions[pair.bodyA];
    const PlannedMotion& b = data.bodies.plannedMotions[pair.bodyB];
    const double radiusA = data.bodies.extents[pair.bodyA].outerRadius;
    const double radiusB = data.bodies.extents[pair.bodyB].outerRadius;
    const Vec2 apart = b.center - a.center;
    const double margin = speculativeMargin(a, b);
    const double reach = radiusA + radiusB + margin;
    const double squared = apart.squaredNorm();
    const double distance = std::sqrt(squared);
    if (squared > reach * reach) {
        separate(data, index, distance - radiusA - radiusB);
        return;
    }
    const Vec2 normal = distance > 0 ? Vec2(apart / distance) : Vec2(0, 1);
    addCircleContact(data, index, {normal, distance - radiusA - radiusB, radiusA, radiusB, 0}, perSecond);
}

/// Of a static edge and a circle; notes the passage, and of an open edge only the ends count.
Manifold edgeManifold(WorldData& data, std::uint32_t index, const Circle& circle, double margin) {
    const Pair& pair = data.contacts.table.pairs[index];
    const WallSide& side = data.broadPhase.staticCollider(pair.collider).side;
    Passage& passage = data.contacts.table.flags[index].passage;
    passage = nextPassage(passage, side, circle);
    if (passage != Passage::Between) {
        return sideAgainstCircle(side, circle, margin);
    }
    Manifold manifold = collideOpenWall(*pair.shapeB, {}, circle, {}, margin);
    manifold.apart = 0; // the wall may close at any time
    return manifold;
}

void updateCircleAtStatic(WorldData& data, std::uint32_t index, double perSecond) {
    Pair& pair = data.contacts.table.pairs[index];
    const PlannedMotion& way = data.bodies.plannedMotions[pair.bodyA];
    const Circle circle{way.center, std::get<Circle>(*pair.shapeA).radius};
    const double margin = speculativeMargin(way);
    const Manifold manifold = pair.kind == PairKind::CircleEdge ? edgeManifold(data, index, circle, margin)
                                                                : collideCircle(*pair.shapeB, circle, margin);
    if (manifold.count == 0) {
        separate(data, index, manifold.apart);
        return;
    }
    const ManifoldPoint& point = manifold.points[0];
    addCircleContact(data, index, {-manifold.normal, point.separation, circle.radius, 0, point.feature}, perSecond);
}

SPACETOW_PREFETCHES void prefetchWall(const BroadPhase& broadPhase, const Pair& pair) {
    if (pair.kind == PairKind::CircleEdge) {
        prefetch(broadPhase.staticCollider(pair.collider).side);
    }
}

/// What is known of contacts lies in the order in which they came about, so the processor has to be told early what
/// will be looked at: first the pair, then its contact, then its manifold.
SPACETOW_PREFETCHES void prefetchAhead(const Contacts& contacts, const std::vector<std::uint32_t>& candidates,
                                       std::size_t at) {
    constexpr std::size_t ahead = 6;
    const std::vector<Pair>& pairs = contacts.table.pairs;
    if (at + 3 * ahead < candidates.size()) {
        __builtin_prefetch(&pairs[candidates[at + 3 * ahead]]);
    }
    const auto contactAt = [&](std::size_t index) {
        return index < candidates.size() ? pairs[candidates[index]].contact : Pair::none;
    };
    if (const std::uint32_t contact = contactAt(at + 2 * ahead); contact != Pair::none) {
        __builtin_prefetch(&contacts.pool[contact]);
    }
    const std::uint32_t contact = contactAt(at + ahead);
    if (contact != Pair::none && contacts.pool[contact].manifold != Pair::none) {
        prefetch(contacts.manifolds[contacts.pool[contact].manifold]);
    }
}

/// The same for the surfaces of pairs whose manifolds are made anew.
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

/// The way that the body has gone in this iteration, about its centre of mass.
Way wayOf(const Bodies& bodies, Slot slot) {
    const Transform end = bodies.pose(slot);
    if (bodies.records[slot].asleep) {
        return Way(end);
    }
    const BodyStep& s = bodies.steps[slot];
    return {{.start = bodies.plannedMotions[slot].pose(), .translation = s.deltaPosition, .turn = s.deltaAngle}, end};
}

/// Whether the sensor and the other meet at the end of the iteration, or did on the way.
void updateSensor(const Bodies& bodies, const Pair& pair, PairFlags& flags) {
    const Way a = wayOf(bodies, pair.bodyA);
    const Way b = pair.staticB ? Way(Transform{}) : wayOf(bodies, pair.bodyB);
    flags.touching = overlaps(*pair.shapeA, a.end, *pair.shapeB, b.end);
    flags.passed = !flags.touching && !flags.reported && overlapsOnWay(*pair.shapeA, a, *pair.shapeB, b);
}

/// After more changes the constraints are rebuilt in the order of their pairs: bodies that are near each other are so
/// in memory, too, and piles converge better.
std::size_t mostConstraintChanges(const Constraints& constraints) {
    return (constraints.circleContacts.size() + constraints.generalContacts.size()) / 8;
}

void updatePair(WorldData& data, std::uint32_t index, double perSecond) {
    const PairKind kind = data.contacts.table.pairs[index].kind;
    if (kind == PairKind::CircleCircle) {
        updateCircles(data, index, perSecond);
    } else if (kind == PairKind::CircleEdge || kind == PairKind::CircleStatic) {
        updateCircleAtStatic(data, index, perSecond);
    } else {
        updateManifold(data, index, perSecond);
    }
}

void resetPair(Contacts& contacts, std::uint32_t index) {
    contacts.table.flags[index].touching = false;
    contacts.table.pairs[index].sweep = false;
}

/// Updates the pairs that have no constraint and may have come into contact.
void updateCandidates(WorldData& data, double perSecond) {
    listCandidates(data.bodies, data.contacts, data.scratch.narrow);
    for (std::size_t k = 0; k < data.scratch.narrow.candidates.size(); ++k) {
        prefetchAhead(data.contacts, data.scratch.narrow.candidates, k);
        const std::uint32_t i = data.scratch.narrow.candidates[k];
        if (data.contacts.table.pairs[i].kind != PairKind::Sensor) {
            resetPair(data.contacts, i);
            updatePair(data, i, perSecond);
        }
    }
}

void rebuildConstraints(WorldData& data, double perSecond) {
    releaseConstraints(data.contacts, data.constraints, data.flags);
    resetConstraints(data.bodies, data.constraints, data.flags, data.scratch.narrow);
    data.flags.anySweep = false;
    updateCandidates(data, perSecond);
    mergeContacts(data);
    orderConstraints(data.bodies, data.scratch.narrow);
    for (const Constraint& constraint : data.scratch.narrow.constraints) {
        addManifoldConstraint(data, constraint, perSecond);
    }
    findMergeCandidates(data.bodies, data.constraints);
    data.constraints.constraintChanges = 0;
    data.flags.constraintsRebuilt = true;
}

/// Contacts that the kernels do not update.
void updateScalar(WorldData& data, double perSecond) {
    constexpr std::size_t ahead = 8;
    for (std::size_t i = data.constraints.circleContacts.size(); data.flags.anyScalarUpdate && i-- > 0;) {
        if (i >= 2 * ahead) {
            __builtin_prefetch(&data.contacts.table.pairs[data.constraints.circleContacts[i - 2 * ahead].pair]);
        }
        if (i >= ahead) {
            prefetchWall(data.broadPhase, data.contacts.table.pairs[data.constraints.circleContacts[i - ahead].pair]);
        }
        if (data.constraints.circleContacts[i].scalarUpdate) {
            updatePair(data, data.constraints.circleContacts[i].pair, perSecond);
        }
    }
}

/// Adds the pairs of outdated contacts to the candidates.
template <class Kind, class Batch>
void listOutdated(NarrowPhase& narrow, const std::vector<Kind>& list, const Batches<Batch>& batches) {
    forLanes(batches, &BatchFlags::outdated,
             [&](Lane at) { narrow.candidates.push_back(pairOf(list[batches.anchors(at.batch).owner[at.lane]])); });
}

void updateOutdated(WorldData& data, double perSecond) {
    data.scratch.narrow.candidates.clear();
    listOutdated(data.scratch.narrow, data.constraints.circleContacts, data.constraints.batches.circles);
    listOutdated(data.scratch.narrow, data.constraints.generalContacts, data.constraints.batches.general);
    for (std::size_t k = 0; k < data.scratch.narrow.candidates.size(); ++k) {
        prefetchAhead(data.contacts, data.scratch.narrow.candidates, k);
        prefetchShapes(data.bodies, data.contacts, data.scratch.narrow.candidates, k);
        const std::uint32_t pair = data.scratch.narrow.candidates[k];
        if (data.contacts.table.pairs[pair].kind == PairKind::General) {
            remakeManifold(data, pair, perSecond);
        } else {
            updateCircles(data, pair, perSecond);
        }
    }
}

bool anyMergedOutdated(const Constraints& constraints) {
    return std::any_of(
        constraints.generalContacts.begin(), constraints.generalContacts.end(), [&](const GeneralContact& c) {
            return c.merged && (constraints.batches.general.flags(c.lane.batch).outdated >> c.lane.lane & 1) != 0;
        });
}

/// The contacts that there are, from where the bodies are now; then what may have come or gone. False when there are
/// too many changes, or contacts may lie in one plane in another way than before.
bool updateConstraints(WorldData& data, double perSecond) {
    if (!data.flags.constraintsValid || data.flags.mergeStale) {
        return false;
    }
    data.flags.anySweep = data.flags.anyBounce = data.flags.constraintsRebuilt = false;
    data.scratch.narrow.constraints.clear();
    const PlannedMotion* first = data.bodies.plannedMotions.bodies();
    refreshContacts(data.constraints.batches,
                    {{&first->center, sizeof(PlannedMotion)}, {&first->deltaPosition, sizeof(PlannedMotion)}},
                    perSecond);
    if (!data.constraints.mergedPairs.empty() && anyMergedOutdated(data.constraints)) {
        return false;
    }
    updateOutdated(data, perSecond);
    updateScalar(data, perSecond);
    updateCandidates(data, perSecond);
    if (data.flags.anySingular) {
        updateSingular(data.constraints);
    }
    for (const Constraint& constraint : data.scratch.narrow.constraints) {
        addManifoldConstraint(data, constraint, perSecond);
        findMergeCandidatesOfLast(data.bodies, data.constraints);
    }
    return data.constraints.constraintChanges <= mostConstraintChanges(data.constraints) &&
           !anyInOnePlane(data.contacts, data.constraints);
}

} // namespace

void findContacts(WorldData& data, const IterationStep& step) {
    const double perSecond = 1 / step.dt;
    if (!updateConstraints(data, perSecond)) {
        rebuildConstraints(data, perSecond);
    }
}

void findOverlaps(const Bodies& bodies, Contacts& contacts) {
    for (const std::uint32_t i : contacts.sensors) {
        updateSensor(bodies, contacts.table.pairs[i], contacts.table.flags[i]);
    }
}

} // namespace spacetow
