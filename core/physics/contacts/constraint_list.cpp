#include "core/physics/contacts/constraint_list.h"

#include "core/base/prefetch.h"
#include "core/physics/contacts/contact_rules.h"
#include "core/physics/contacts/effective_mass.h"
#include "core/physics/contacts/pack_constraint.h"

#include <algorithm>

namespace spacetow {

namespace {

template <class Batch>
Lane openLane(const Bodies& bodies, Batches<Batch>& batches, Slot a, Slot b) {
    const Lane lane = batches.open(a, bodies.motions[a].isMovable(), b, bodies.motions[b].isMovable());
    typename Batch::Anchors& anchors = batches.anchors(lane.batch);
    anchors.a[lane.lane] = a;
    anchors.b[lane.lane] = b;
    Batch& batch = batches[lane.batch];
    batch.massA[lane.lane] = bodies.motions[a].inverseMass;
    batch.massB[lane.lane] = bodies.motions[b].inverseMass;
    batch.inertiaA[lane.lane] = bodies.motions[a].inverseInertia;
    batch.inertiaB[lane.lane] = bodies.motions[b].inverseInertia;
    return lane;
}

CircleContact& openCircleLane(const ContactStage& stage, std::uint32_t index) {
    const Pair& pair = stage.contacts.table.pairs[index];
    Contact& kept = stage.contacts.pool[pair.contact];
    Batches<CircleBatch>& batches = stage.constraints.batches.circles;
    const Lane lane = openLane(stage.bodies, batches, pair.bodyA, pair.bodyB);
    kept.constraintIndex = static_cast<std::uint32_t>(stage.constraints.circleContacts.size());
    stage.contacts.table.flags[index].inSolver = true;
    stage.contacts.table.bounds[index].exclude();
    CircleContact& c = stage.constraints.circleContacts.emplace_back();
    c = {pair.bodyA, pair.bodyB, index, pair.contact, lane, pair.staticB || kept.restitution > 0, false};
    CircleAnchors& anchors = batches.anchors(lane.batch);
    anchors.owner[lane.lane] = kept.constraintIndex;
    anchors.radiusA[lane.lane] = stage.bodies.steps[c.a].outerRadius;
    anchors.radiusB[lane.lane] = stage.bodies.steps[c.b].outerRadius;
    setLane(anchors.wideUpdate, lane.lane, !pair.staticB);
    CircleBatch& batch = batches[lane.batch];
    const double inverseMass = stage.bodies.motions[c.a].inverseMass + stage.bodies.motions[c.b].inverseMass;
    batch.normalMass[lane.lane] = inverseMass > 0 ? 1 / inverseMass : 0;
    batch.friction[lane.lane] = kept.friction;
    batch.normalImpulse[lane.lane] = kept.points[0].normalImpulse;
    batch.tangentImpulse[lane.lane] = kept.tangentImpulse;
    stage.flags.anyScalarUpdate |= c.scalarUpdate;
    ++stage.constraints.constraintChanges;
    return c;
}

void noteMergeCandidate(const Bodies& bodies, Constraints& constraints, const GeneralContact& c,
                        const GeneralContact& d) {
    if (c.mergeable && d.mergeable && mayShareSurface(bodies, c.b, d.b)) {
        constraints.mergeCandidates.emplace_back(c.points[0].contact, d.points[0].contact);
    }
}

std::uint32_t poolIndexOf(const CircleContact& c) {
    return c.contact;
}
std::uint32_t poolIndexOf(const GeneralContact& c) {
    return c.points[0].contact;
}

template <class Kind>
void saveAll(Contacts& contacts, const Constraints& constraints, const std::vector<Kind>& list) {
    constexpr std::size_t ahead = 8;
    for (std::size_t i = 0; i < list.size(); ++i) {
        if (i + ahead < list.size()) {
            prefetch(contacts.pool[poolIndexOf(list[i + ahead])].points);
        }
        saveImpulses(contacts, constraints, list[i]);
    }
}

/// Closes the lane and removes the contact from the list. The last contact of the list takes its place.
template <class Kind, class Batch>
void closeLane(Contacts& contacts, std::vector<Kind>& list, Batches<Batch>& batches, std::uint32_t place) {
    batches.close(list[place].lane);
    if (place + 1 < list.size()) {
        list[place] = list.back();
        const Lane lane = list[place].lane;
        batches.anchors(lane.batch).owner[lane.lane] = place;
        contacts.pool[contacts.table.pairs[pairOf(list[place])].contact].constraintIndex = place;
    }
    list.pop_back();
}

/// Remaps the pairs at the indices `begin` … `end` − 1.
void remapPairs(const ContactStage& stage, std::uint32_t begin, std::uint32_t end) {
    constexpr std::uint32_t ahead = 8;
    for (std::uint32_t i = begin; i < end; ++i) {
        if (i + ahead < end && stage.contacts.table.flags[i + ahead].inSolver) {
            prefetch(stage.contacts.pool[stage.contacts.table.pairs[i + ahead].contact].constraintIndex);
        }
        if (!stage.contacts.table.flags[i].inSolver) {
            continue;
        }
        const Pair& pair = stage.contacts.table.pairs[i];
        const std::uint32_t place = stage.contacts.pool[pair.contact].constraintIndex;
        if (pair.kind == PairKind::General) {
            stage.constraints.generalContacts[place].points[0].pair =
                stage.constraints.generalContacts[place].points[1].pair = i;
        } else {
            stage.constraints.circleContacts[place].pair = i;
        }
    }
}

} // namespace

void addCircleConstraint(const ContactStage& stage, std::uint32_t pair, const CircleManifold& touch,
                         const CircleTarget& target) {
    Contact& kept = stage.contacts.pool[stage.contacts.table.pairs[pair].contact];
    const bool listed = stage.contacts.table.flags[pair].inSolver;
    CircleContact& c = listed ? stage.constraints.circleContacts[kept.constraintIndex] : openCircleLane(stage, pair);
    const BodyMotion& a = stage.bodies.motions[c.a];
    const BodyMotion& b = stage.bodies.motions[c.b];
    CircleBatch& batch = stage.constraints.batches.circles[c.lane.batch];
    const std::uint32_t i = c.lane.lane;
    const double leverA = touch.radiusA + 0.5 * touch.separation;
    const double leverB = -touch.radiusB - 0.5 * touch.separation;
    batch.normalX[i] = touch.normal.x();
    batch.normalY[i] = touch.normal.y();
    batch.leverA[i] = leverA;
    batch.leverB[i] = leverB;
    batch.tangentMass[i] = 1 / formulas::inverseMass(massesOf(a, b), Levers{leverA, leverB});
    batch.separation[i] = touch.separation;
    batch.target[i] = target.velocity;
    batch.closingLimit[i] = target.closing;
    if (matchFeature(kept, touch.feature)) {
        batch.normalImpulse[i] = batch.tangentImpulse[i] = 0;
    }
    c.bounces = target.bounces;
    stage.flags.anyBounce |= c.bounces;
}

void addManifoldConstraint(const ContactStage& stage, const Constraint& constraint, double perSecond) {
    const ConstraintPoint& p = constraint.points[0];
    stage.contacts.table.flags[p.pair].inSolver = true;
    stage.contacts.table.bounds[p.pair].exclude();
    stage.contacts.pool[p.contact].constraintIndex =
        static_cast<std::uint32_t>(stage.constraints.generalContacts.size());
    GeneralContact& c = stage.constraints.generalContacts.emplace_back();
    c.a = constraint.a;
    c.b = constraint.b;
    c.mergeable = !constraint.unmergeable;
    ++stage.constraints.constraintChanges;
    stage.constraints.mergeableContacts[c.a] += c.mergeable ? 1 : 0;
    c.lane = openLane(stage.bodies, stage.constraints.batches.general, c.a, c.b);
    stage.constraints.batches.general.anchors(c.lane.batch).owner[c.lane.lane] =
        stage.contacts.pool[p.contact].constraintIndex;
    pack(stage, constraint, c, perSecond);
}

void rewriteConstraint(const ContactStage& stage, const Constraint& constraint, double perSecond) {
    pack(stage, constraint,
         stage.constraints.generalContacts[stage.contacts.pool[constraint.points[0].contact].constraintIndex],
         perSecond);
}

void updateSingular(Constraints& constraints) {
    for (const GeneralContact& c : constraints.generalContacts) {
        if (c.singular) {
            keepDeeperPoint(constraints.batches.general[c.lane.batch], c.lane.lane);
        }
    }
}

bool matchFeature(Contact& contact, std::uint32_t feature) {
    if (contact.count > 0 && contact.points[0].feature == feature) {
        return false;
    }
    contact.count = 1;
    contact.points[0] = {feature, 0};
    contact.tangentImpulse = 0;
    return true;
}

void removeConstraint(Contacts& contacts, Constraints& constraints, std::uint32_t pair) {
    const PairKind kind = contacts.table.pairs[pair].kind;
    const std::uint32_t place = contacts.pool[contacts.table.pairs[pair].contact].constraintIndex;
    contacts.table.flags[pair].inSolver = contacts.table.flags[pair].touching = false;
    contacts.table.bounds[pair].reset();
    ++constraints.constraintChanges;
    if (kind != PairKind::General) {
        closeLane(contacts, constraints.circleContacts, constraints.batches.circles, place);
        return;
    }
    const GeneralContact& c = constraints.generalContacts[place];
    if (c.mergeable) {
        --constraints.mergeableContacts[c.a];
        const std::uint32_t gone = c.points[0].contact;
        std::erase_if(constraints.mergeCandidates,
                      [&](const auto& both) { return both.first == gone || both.second == gone; });
    }
    closeLane(contacts, constraints.generalContacts, constraints.batches.general, place);
}

void findMergeCandidates(const Bodies& bodies, Constraints& constraints) {
    const std::vector<GeneralContact>& all = constraints.generalContacts;
    constraints.mergeCandidates.clear();
    constraints.mergeCandidates.reserve(
        all.capacity()); // more than there are, so that a steady update allocates nothing
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (!all[i].mergeable || constraints.mergeableContacts[all[i].a] < 2) {
            continue;
        }
        for (std::size_t j = i + 1; j < all.size() && all[j].a == all[i].a; ++j) {
            noteMergeCandidate(bodies, constraints, all[i], all[j]);
        }
    }
}

void findMergeCandidatesOfLast(const Bodies& bodies, Constraints& constraints) {
    const GeneralContact& last = constraints.generalContacts.back();
    if (!last.mergeable || constraints.mergeableContacts[last.a] < 2) {
        return;
    }
    for (const GeneralContact& other : constraints.generalContacts) {
        if (other.a == last.a && &other != &last) {
            noteMergeCandidate(bodies, constraints, other, last);
        }
    }
}

bool anyInOnePlane(const Contacts& contacts, const Constraints& constraints) {
    const auto normal = [&](std::uint32_t contact) {
        const Lane lane = constraints.generalContacts[contacts.pool[contact].constraintIndex].lane;
        const ConstraintBatch& batch = constraints.batches.general[lane.batch];
        return Vec2(batch.normalX[lane.lane], batch.normalY[lane.lane]);
    };
    return std::any_of(constraints.mergeCandidates.begin(), constraints.mergeCandidates.end(),
                       [&](const auto& both) { return areParallelNormals(normal(both.first), normal(both.second)); });
}

void saveImpulses(Contacts& contacts, const Constraints& constraints, const CircleContact& contact) {
    const CircleBatch& batch = constraints.batches.circles[contact.lane.batch];
    Contact& kept = contacts.pool[contact.contact];
    kept.points[0].normalImpulse = batch.normalImpulse[contact.lane.lane];
    kept.tangentImpulse = batch.tangentImpulse[contact.lane.lane];
}

void saveImpulses(Contacts& contacts, const Constraints& constraints, const GeneralContact& contact) {
    const ConstraintBatch& batch = constraints.batches.general[contact.lane.batch];
    const std::uint32_t i = contact.lane.lane;
    const std::array<double, 2> impulses{batch.impulse1[i], batch.impulse2[i]};
    for (std::size_t k = 0; k < contact.count; ++k) {
        const GeneralContact::Point& p = contact.points[k];
        contacts.pool[p.contact].points[p.index].normalImpulse = impulses[k];
    }
    contacts.pool[contact.points[0].contact].tangentImpulse = batch.tangentImpulse[i];
}

void saveAllImpulses(Contacts& contacts, const Constraints& constraints, const StepFlags& flags) {
    if (flags.constraintsValid) {
        saveAll(contacts, constraints, constraints.circleContacts);
        saveAll(contacts, constraints, constraints.generalContacts);
    }
}

void remapPairs(const ContactStage& stage) {
    if (!stage.flags.constraintsValid) {
        return;
    }
    for (const Run& s : stage.changes.runs) {
        if (s.to != s.begin) {
            remapPairs(stage, s.to, s.to + s.end - s.begin);
        }
    }
}

void releaseConstraints(Contacts& contacts, Constraints& constraints, StepFlags& flags) {
    if (!flags.constraintsValid) {
        return;
    }
    saveAllImpulses(contacts, constraints, flags);
    const auto release = [&](const auto& c) {
        contacts.table.flags[pairOf(c)].inSolver = false;
        contacts.table.bounds[pairOf(c)].reset();
    };
    std::for_each(constraints.circleContacts.begin(), constraints.circleContacts.end(), release);
    std::for_each(constraints.generalContacts.begin(), constraints.generalContacts.end(), release);
    for (const std::uint32_t pair : constraints.mergedPairs) {
        contacts.table.bounds[pair].reset();
    }
    constraints.mergedPairs.clear();
    flags.constraintsValid = false;
}

void resetConstraints(const Bodies& bodies, Constraints& constraints, StepFlags& flags, NarrowPhase& narrow) {
    for (const GeneralContact& c : constraints.generalContacts) {
        constraints.mergeableContacts[c.a] = 0;
    }
    constraints.circleContacts.clear();
    constraints.generalContacts.clear();
    narrow.constraints.clear();
    constraints.batches.circles.reset(bodies.motions.size());
    constraints.batches.general.reset(bodies.motions.size());
    flags.anyScalarUpdate = flags.anySingular = flags.anyBounce = flags.mergeStale = false;
    flags.constraintsValid = true;
}

} // namespace spacetow
