#include "core/physics/contacts/constraint_list.h"

#include "core/base/prefetch.h"
#include "core/physics/contacts/contact_rules.h"
#include "core/physics/contacts/effective_mass.h"
#include "core/physics/contacts/pack_constraint.h"

#include <algorithm>

namespace spacetow {

namespace {

template <class Batch>
Lane openLane(WorldData& data, Batches<Batch>& batches, Slot a, Slot b) {
    const Lane lane = batches.open(a, data.motions[a].isMovable(), b, data.motions[b].isMovable());
    typename Batch::Anchors& anchors = batches.anchors(lane.batch);
    anchors.a[lane.lane] = a;
    anchors.b[lane.lane] = b;
    Batch& batch = batches[lane.batch];
    batch.massA[lane.lane] = data.motions[a].inverseMass;
    batch.massB[lane.lane] = data.motions[b].inverseMass;
    batch.inertiaA[lane.lane] = data.motions[a].inverseInertia;
    batch.inertiaB[lane.lane] = data.motions[b].inverseInertia;
    return lane;
}

CircleContact& openCircleLane(WorldData& data, std::uint32_t index) {
    const Pair& pair = data.table.pairs[index];
    Contact& kept = data.contacts[pair.contact];
    Batches<CircleBatch>& batches = data.batches.circles;
    const Lane lane = openLane(data, batches, pair.bodyA, pair.bodyB);
    kept.constraintIndex = static_cast<std::uint32_t>(data.circleContacts.size());
    data.table.flags[index].inSolver = true;
    data.table.bounds[index].exclude();
    CircleContact& c = data.circleContacts.emplace_back();
    c = {pair.bodyA, pair.bodyB, index, pair.contact, lane, pair.staticB || kept.restitution > 0, false};
    CircleAnchors& anchors = batches.anchors(lane.batch);
    anchors.owner[lane.lane] = kept.constraintIndex;
    anchors.radiusA[lane.lane] = data.steps[c.a].outerRadius;
    anchors.radiusB[lane.lane] = data.steps[c.b].outerRadius;
    setLane(anchors.wideUpdate, lane.lane, !pair.staticB);
    CircleBatch& batch = batches[lane.batch];
    const double inverseMass = data.motions[c.a].inverseMass + data.motions[c.b].inverseMass;
    batch.normalMass[lane.lane] = inverseMass > 0 ? 1 / inverseMass : 0;
    batch.friction[lane.lane] = kept.friction;
    batch.normalImpulse[lane.lane] = kept.points[0].normalImpulse;
    batch.tangentImpulse[lane.lane] = kept.tangentImpulse;
    data.flags.anyScalarUpdate |= c.scalarUpdate;
    ++data.constraintChanges;
    return c;
}

void noteMergeCandidate(WorldData& data, const GeneralContact& c, const GeneralContact& d) {
    const auto isStatic = [&](Slot slot) { return data.records[slot].kind == BodyKind::Static; };
    if (c.mergeable && d.mergeable && (c.b == d.b || (isStatic(c.b) && isStatic(d.b)))) {
        data.mergeCandidates.emplace_back(c.points[0].contact, d.points[0].contact);
    }
}

std::uint32_t keptIn(const CircleContact& c) {
    return c.contact;
}
std::uint32_t keptIn(const GeneralContact& c) {
    return c.points[0].contact;
}

template <class Kind>
void saveAll(WorldData& data, const std::vector<Kind>& list) {
    constexpr std::size_t ahead = 8;
    for (std::size_t i = 0; i < list.size(); ++i) {
        if (i + ahead < list.size()) {
            prefetch(data.contacts[keptIn(list[i + ahead])]);
        }
        saveImpulses(data, list[i]);
    }
}

/// Fills the gap with the last of the list.
template <class Kind, class Batch>
void closeLane(WorldData& data, std::vector<Kind>& list, Batches<Batch>& batches, std::uint32_t place) {
    batches.close(list[place].lane);
    if (place + 1 < list.size()) {
        list[place] = list.back();
        const Lane lane = list[place].lane;
        batches.anchors(lane.batch).owner[lane.lane] = place;
        data.contacts[data.table.pairs[pairOf(list[place])].contact].constraintIndex = place;
    }
    list.pop_back();
}

void remapPairs(WorldData& data, std::uint32_t begin, std::uint32_t end) {
    constexpr std::uint32_t ahead = 8;
    for (std::uint32_t i = begin; i < end; ++i) {
        if (i + ahead < end && data.table.flags[i + ahead].inSolver) {
            prefetch(data.contacts[data.table.pairs[i + ahead].contact].constraintIndex);
        }
        if (!data.table.flags[i].inSolver) {
            continue;
        }
        const Pair& pair = data.table.pairs[i];
        const std::uint32_t place = data.contacts[pair.contact].constraintIndex;
        if (pair.kind == PairKind::General) {
            data.generalContacts[place].points[0].pair = data.generalContacts[place].points[1].pair = i;
        } else {
            data.circleContacts[place].pair = i;
        }
    }
}

} // namespace

void addCircleConstraint(WorldData& data, std::uint32_t pair, const CircleTouch& touch, const CircleTarget& target) {
    Contact& kept = data.contacts[data.table.pairs[pair].contact];
    const bool listed = data.table.flags[pair].inSolver;
    CircleContact& c = listed ? data.circleContacts[kept.constraintIndex] : openCircleLane(data, pair);
    const BodyMotion& a = data.motions[c.a];
    const BodyMotion& b = data.motions[c.b];
    CircleBatch& batch = data.batches.circles[c.lane.batch];
    const std::uint32_t i = c.lane.lane;
    const double leverA = touch.radiusA + 0.5 * touch.separation;
    const double leverB = -touch.radiusB - 0.5 * touch.separation;
    batch.normalX[i] = touch.normal.x();
    batch.normalY[i] = touch.normal.y();
    batch.leverA[i] = leverA;
    batch.leverB[i] = leverB;
    batch.tangentMass[i] = 1 / formulas::inverseMass(massesOf(a, b), Levers{leverA, leverB}, Levers{leverA, leverB});
    batch.separation[i] = touch.separation;
    batch.target[i] = target.velocity;
    batch.closingLimit[i] = target.closing;
    if (matchFeature(kept, touch.feature)) {
        batch.normalImpulse[i] = batch.tangentImpulse[i] = 0;
    }
    c.bounces = target.bounces;
    data.flags.anyBounce |= c.bounces;
}

void addManifoldConstraint(WorldData& data, const Constraint& constraint, double perSecond) {
    const ConstraintPoint& p = constraint.points[0];
    data.table.flags[p.pair].inSolver = true;
    data.table.bounds[p.pair].exclude();
    data.contacts[p.contact].constraintIndex = static_cast<std::uint32_t>(data.generalContacts.size());
    GeneralContact& c = data.generalContacts.emplace_back();
    c.a = constraint.a;
    c.b = constraint.b;
    c.mergeable = !constraint.unmergeable;
    ++data.constraintChanges;
    data.mergeableContacts[c.a] += c.mergeable ? 1 : 0;
    c.lane = openLane(data, data.batches.general, c.a, c.b);
    data.batches.general.anchors(c.lane.batch).owner[c.lane.lane] = data.contacts[p.contact].constraintIndex;
    pack(data, constraint, c, perSecond);
}

void rewriteConstraint(WorldData& data, const Constraint& constraint, double perSecond) {
    pack(data, constraint, data.generalContacts[data.contacts[constraint.points[0].contact].constraintIndex],
         perSecond);
}

void updateSingular(WorldData& data) {
    for (const GeneralContact& c : data.generalContacts) {
        if (c.singular) {
            keepDeeperPoint(data.batches.general[c.lane.batch], c.lane.lane);
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

void removeConstraint(WorldData& data, std::uint32_t pair) {
    const Contact& kept = data.contacts[data.table.pairs[pair].contact];
    data.table.flags[pair].inSolver = data.table.flags[pair].touching = false;
    data.table.bounds[pair].reset();
    ++data.constraintChanges;
    if (kept.manifold == Pair::none) {
        closeLane(data, data.circleContacts, data.batches.circles, kept.constraintIndex);
        return;
    }
    const GeneralContact& c = data.generalContacts[kept.constraintIndex];
    if (c.mergeable) {
        --data.mergeableContacts[c.a];
        const std::uint32_t gone = c.points[0].contact;
        std::erase_if(data.mergeCandidates,
                      [&](const auto& both) { return both.first == gone || both.second == gone; });
    }
    closeLane(data, data.generalContacts, data.batches.general, kept.constraintIndex);
}

void findMergeCandidates(WorldData& data) {
    const std::vector<GeneralContact>& all = data.generalContacts;
    data.mergeCandidates.clear();
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (!all[i].mergeable || data.mergeableContacts[all[i].a] < 2) {
            continue;
        }
        for (std::size_t j = i + 1; j < all.size() && all[j].a == all[i].a; ++j) {
            noteMergeCandidate(data, all[i], all[j]);
        }
    }
}

void findMergeCandidatesOfLast(WorldData& data) {
    const GeneralContact& last = data.generalContacts.back();
    if (!last.mergeable || data.mergeableContacts[last.a] < 2) {
        return;
    }
    for (const GeneralContact& other : data.generalContacts) {
        if (other.a == last.a && &other != &last) {
            noteMergeCandidate(data, other, last);
        }
    }
}

bool anyInOnePlane(const WorldData& data) {
    const auto normal = [&](std::uint32_t contact) {
        const Lane lane = data.generalContacts[data.contacts[contact].constraintIndex].lane;
        const ConstraintBatch& batch = data.batches.general[lane.batch];
        return Vec2(batch.normalX[lane.lane], batch.normalY[lane.lane]);
    };
    return std::any_of(data.mergeCandidates.begin(), data.mergeCandidates.end(),
                       [&](const auto& both) { return areParallelNormals(normal(both.first), normal(both.second)); });
}

void saveImpulses(WorldData& data, const CircleContact& contact) {
    const CircleBatch& batch = data.batches.circles[contact.lane.batch];
    Contact& kept = data.contacts[contact.contact];
    kept.points[0].normalImpulse = batch.normalImpulse[contact.lane.lane];
    kept.tangentImpulse = batch.tangentImpulse[contact.lane.lane];
}

void saveImpulses(WorldData& data, const GeneralContact& contact) {
    const ConstraintBatch& batch = data.batches.general[contact.lane.batch];
    const std::uint32_t i = contact.lane.lane;
    const std::array<double, 2> impulses{batch.impulse1[i], batch.impulse2[i]};
    for (std::size_t k = 0; k < contact.count; ++k) {
        const GeneralContact::Point& p = contact.points[k];
        data.contacts[p.contact].points[p.index].normalImpulse = impulses[k];
    }
    data.contacts[contact.points[0].contact].tangentImpulse = batch.tangentImpulse[i];
}

void saveImpulses(WorldData& data) {
    if (data.flags.constraintsValid) {
        saveAll(data, data.circleContacts);
        saveAll(data, data.generalContacts);
    }
}

void remapPairs(WorldData& data) {
    if (!data.flags.constraintsValid) {
        return;
    }
    for (const Run& s : data.scratch.changes.runs) {
        if (s.to != s.begin) {
            remapPairs(data, s.to, s.to + s.end - s.begin);
        }
    }
}

void releaseConstraints(WorldData& data) {
    if (!data.flags.constraintsValid) {
        return;
    }
    saveImpulses(data);
    const auto release = [&](const auto& c) {
        data.table.flags[pairOf(c)].inSolver = false;
        data.table.bounds[pairOf(c)].reset();
    };
    std::for_each(data.circleContacts.begin(), data.circleContacts.end(), release);
    std::for_each(data.generalContacts.begin(), data.generalContacts.end(), release);
    for (const std::uint32_t pair : data.mergedPairs) {
        data.table.bounds[pair].reset();
    }
    data.mergedPairs.clear();
    data.flags.constraintsValid = false;
}

void resetConstraints(WorldData& data) {
    for (const GeneralContact& c : data.generalContacts) {
        data.mergeableContacts[c.a] = 0;
    }
    data.circleContacts.clear();
    data.generalContacts.clear();
    data.scratch.narrow.constraints.clear();
    data.batches.circles.reset(data.motions.size());
    data.batches.general.reset(data.motions.size());
    data.flags.anyScalarUpdate = data.flags.anySingular = data.flags.anyBounce = data.flags.mergeStale = false;
    data.flags.constraintsValid = true;
}

} // namespace spacetow
