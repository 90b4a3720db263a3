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
    Pair& pair = data.table.pairs[index];
    if (data.table.flags[index].inSolver) {
        removeConstraint(data, index);
    }
    freeContact(data, pair);
    PairBound& bound = data.table.bounds[index];
    bound.separationBound = data.motionOf(bound) + separation;
}

Approach approach(const WorldData& data, const Pair& pair, const Vec2& normal) {
    const Vec2 before = data.steps[pair.bodyB].startVelocity - data.steps[pair.bodyA].startVelocity;
    const Vec2 after = data.motions[pair.bodyB].velocity - data.motions[pair.bodyA].velocity;
    return {-before.dot(normal), -after.dot(normal)};
}

/// Parts that are to bounce where they meet have no contact until then.
void sweepCircles(WorldData& data, std::uint32_t index, std::uint32_t feature) {
    Pair& pair = data.table.pairs[index];
    if (data.table.flags[index].inSolver) {
        saveImpulses(data, data.circleContacts[data.contacts[pair.contact].constraintIndex]);
        removeConstraint(data, index);
    }
    matchFeature(data.contacts[pair.contact], feature);
    pair.sweep = true;
    data.flags.anySweep = true;
    data.steps[pair.bodyA].bouncing = data.steps[pair.bodyB].bouncing = true;
}

void addCircleContact(WorldData& data, std::uint32_t index, const CircleTouch& touch, double perSecond) {
    Pair& pair = data.table.pairs[index];
    const Contact& kept = contactOf(data, pair);
    const double closing = formulas::closingLimit(touch.separation, perSecond);
    CircleTarget aim{formulas::targetVelocity(touch.separation, perSecond), closing, false};
    if (kept.restitution > 0) {
        const Target target =
            targetOf(approach(data, pair, touch.normal), touch.separation, kept.restitution, perSecond);
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
    const Pair& pair = data.table.pairs[index];
    const PlannedMotion& a = data.plannedMotions[pair.bodyA];
    const PlannedMotion& b = data.plannedMotions[pair.bodyB];
    const double radiusA = data.extents[pair.bodyA].outerRadius;
    const double radiusB = data.extents[pair.bodyB].outerRadius;
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

void updateCircleAtStatic(WorldData& data, std::uint32_t index, double perSecond) {
    Pair& pair = data.table.pairs[index];
    const PlannedMotion& way = data.plannedMotions[pair.bodyA];
    const Circle circle{way.center, std::get<Circle>(*pair.shapeA).radius};
    const double margin = speculativeMargin(way);
    const Manifold manifold = pair.kind == PairKind::CircleEdge
                                  ? sideAgainstCircle(data.staticCollider(pair.collider).side, circle, margin)
                                  : collideCircle(*pair.shapeB, circle, margin);
    if (manifold.count == 0) {
        separate(data, index, manifold.apart);
        return;
    }
    const ManifoldPoint& point = manifold.points[0];
    addCircleContact(data, index, {-manifold.normal, point.separation, circle.radius, 0, point.feature}, perSecond);
}

SPACETOW_PREFETCHES void prefetchWall(const WorldData& data, const Pair& pair) {
    if (pair.kind == PairKind::CircleEdge) {
        prefetch(data.staticCollider(pair.collider).side);
    }
}

/// What is known of contacts lies in the order in which they came about, so the processor has to be told early what
/// will be looked at: first the pair, then its contact, then its manifold.
SPACETOW_PREFETCHES void prefetchAhead(const WorldData& data, const std::vector<std::uint32_t>& candidates,
                                       std::size_t at) {
    constexpr std::size_t ahead = 6;
    const std::vector<Pair>& pairs = data.table.pairs;
    if (at + 3 * ahead < candidates.size()) {
        __builtin_prefetch(&pairs[candidates[at + 3 * ahead]]);
    }
    const auto contactAt = [&](std::size_t index) {
        return index < candidates.size() ? pairs[candidates[index]].contact : Pair::none;
    };
    if (const std::uint32_t contact = contactAt(at + 2 * ahead); contact != Pair::none) {
        __builtin_prefetch(&data.contacts[contact]);
    }
    const std::uint32_t contact = contactAt(at + ahead);
    if (contact != Pair::none && data.contacts[contact].manifold != Pair::none) {
        prefetch(data.manifolds[data.contacts[contact].manifold]);
    }
}

/// The same for the surfaces of pairs whose manifolds are made anew.
SPACETOW_PREFETCHES void prefetchShapes(const WorldData& data, const std::vector<std::uint32_t>& candidates,
                                        std::size_t at) {
    constexpr std::size_t ahead = 3;
    if (at + ahead < candidates.size() && data.table.pairs[candidates[at + ahead]].kind == PairKind::General) {
        const Pair& pair = data.table.pairs[candidates[at + ahead]];
        prefetch(*pair.shapeA);
        prefetch(*pair.shapeB);
        prefetch(data.motions[pair.bodyA]);
        prefetch(data.motions[pair.bodyB]);
    }
}

/// The way that the body has gone in this iteration, about its centre of mass.
Way wayOf(const WorldData& data, Slot slot) {
    const Transform end = data.pose(slot);
    if (data.records[slot].asleep) {
        return Way(end);
    }
    const BodyStep& s = data.steps[slot];
    return {{.start = data.plannedMotions[slot].pose(), .translation = s.deltaPosition, .turn = s.deltaAngle}, end};
}

/// Whether the sensor and the other meet at the end of the iteration, or did on the way.
void updateSensor(const WorldData& data, const Pair& pair, PairFlags& flags) {
    const Way a = wayOf(data, pair.bodyA);
    const Way b = pair.staticB ? Way(Transform{}) : wayOf(data, pair.bodyB);
    flags.touching = overlaps(*pair.shapeA, a.end, *pair.shapeB, b.end);
    flags.passed = !flags.touching && !flags.reported && overlapsOnWay(*pair.shapeA, a, *pair.shapeB, b);
}

/// After more changes the constraints are rebuilt in the order of their pairs: bodies that are near each other are so
/// in memory, too, and piles converge better.
std::size_t mostConstraintChanges(const WorldData& data) {
    return (data.circleContacts.size() + data.generalContacts.size()) / 8;
}

void updatePair(WorldData& data, std::uint32_t index, double perSecond) {
    const PairKind kind = data.table.pairs[index].kind;
    if (kind == PairKind::CircleCircle) {
        updateCircles(data, index, perSecond);
    } else if (kind == PairKind::CircleEdge || kind == PairKind::CircleStatic) {
        updateCircleAtStatic(data, index, perSecond);
    } else {
        updateManifold(data, index, perSecond);
    }
}

void resetPair(WorldData& data, std::uint32_t index) {
    data.table.flags[index].touching = false;
    data.table.pairs[index].sweep = false;
}

/// Updates the pairs that have no constraint and may have come into contact.
void updateCandidates(WorldData& data, double perSecond) {
    listCandidates(data);
    for (std::size_t k = 0; k < data.scratch.narrow.candidates.size(); ++k) {
        prefetchAhead(data, data.scratch.narrow.candidates, k);
        const std::uint32_t i = data.scratch.narrow.candidates[k];
        if (data.table.pairs[i].kind != PairKind::Sensor) {
            resetPair(data, i);
            updatePair(data, i, perSecond);
        }
    }
}

void rebuildConstraints(WorldData& data, double perSecond) {
    releaseConstraints(data);
    resetConstraints(data);
    data.flags.anySweep = false;
    updateCandidates(data, perSecond);
    mergeContacts(data);
    orderConstraints(data);
    for (const Constraint& constraint : data.scratch.narrow.constraints) {
        addManifoldConstraint(data, constraint, perSecond);
    }
    findMergeCandidates(data);
    data.constraintChanges = 0;
    data.flags.constraintsRebuilt = true;
}

/// Contacts that the kernels do not update.
void updateScalar(WorldData& data, double perSecond) {
    constexpr std::size_t ahead = 8;
    for (std::size_t i = data.circleContacts.size(); data.flags.anyScalarUpdate && i-- > 0;) {
        if (i >= 2 * ahead) {
            __builtin_prefetch(&data.table.pairs[data.circleContacts[i - 2 * ahead].pair]);
        }
        if (i >= ahead) {
            prefetchWall(data, data.table.pairs[data.circleContacts[i - ahead].pair]);
        }
        if (data.circleContacts[i].scalarUpdate) {
            updatePair(data, data.circleContacts[i].pair, perSecond);
        }
    }
}

/// Adds the pairs of outdated contacts to the candidates.
template <class Kind, class Batch>
void listOutdated(WorldData& data, const std::vector<Kind>& list, const Batches<Batch>& batches) {
    forLanes(batches, &BatchFlags::outdated, [&](Lane at) {
        data.scratch.narrow.candidates.push_back(pairOf(list[batches.anchors(at.batch).owner[at.lane]]));
    });
}

void updateOutdated(WorldData& data, double perSecond) {
    data.scratch.narrow.candidates.clear();
    listOutdated(data, data.circleContacts, data.batches.circles);
    listOutdated(data, data.generalContacts, data.batches.general);
    for (std::size_t k = 0; k < data.scratch.narrow.candidates.size(); ++k) {
        prefetchAhead(data, data.scratch.narrow.candidates, k);
        prefetchShapes(data, data.scratch.narrow.candidates, k);
        const std::uint32_t pair = data.scratch.narrow.candidates[k];
        if (data.table.pairs[pair].kind == PairKind::General) {
            remakeManifold(data, pair, perSecond);
        } else {
            updateCircles(data, pair, perSecond);
        }
    }
}

bool anyMergedOutdated(const WorldData& data) {
    return std::any_of(data.generalContacts.begin(), data.generalContacts.end(), [&](const GeneralContact& c) {
        return c.merged && (data.batches.general.flags(c.lane.batch).outdated >> c.lane.lane & 1) != 0;
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
    const PlannedMotion* first = data.plannedMotions.bodies();
    refreshContacts(data.batches,
                    {{&first->center, sizeof(PlannedMotion)}, {&first->deltaPosition, sizeof(PlannedMotion)}},
                    perSecond);
    if (!data.mergedPairs.empty() && anyMergedOutdated(data)) {
        return false;
    }
    updateOutdated(data, perSecond);
    updateScalar(data, perSecond);
    updateCandidates(data, perSecond);
    if (data.flags.anySingular) {
        updateSingular(data);
    }
    for (const Constraint& constraint : data.scratch.narrow.constraints) {
        addManifoldConstraint(data, constraint, perSecond);
        findMergeCandidatesOfLast(data);
    }
    return data.constraintChanges <= mostConstraintChanges(data) && !anyInOnePlane(data);
}

} // namespace

void findContacts(WorldData& data, const IterationStep& step) {
    const double perSecond = 1 / step.dt;
    if (!updateConstraints(data, perSecond)) {
        rebuildConstraints(data, perSecond);
    }
}

void findOverlaps(WorldData& data) {
    for (const std::uint32_t i : data.sensors) {
        updateSensor(data, data.table.pairs[i], data.table.flags[i]);
    }
}

} // namespace spacetow
