#include "core/physics/contacts/contact_lanes.h"

#include "core/base/prefetch.h"
#include "core/physics/contacts/contact_rules.h"
#include "core/physics/contacts/pack_contacts.h"

#include <algorithm>
#include <limits>

namespace spacetow {

namespace {

template <class Batch>
Lane openLane(WorldData& data, Batches<Batch>& batches, Slot a, Slot b) {
    const Lane lane = batches.open(a, data.motions[a].yields(), b, data.motions[b].yields());
    typename Batch::Shapes& shapes = batches.shapes(lane.batch);
    shapes.a[lane.lane] = a;
    shapes.b[lane.lane] = b;
    Batch& batch = batches[lane.batch];
    batch.massA[lane.lane] = data.motions[a].inverseMass;
    batch.massB[lane.lane] = data.motions[b].inverseMass;
    batch.inertiaA[lane.lane] = data.motions[a].inverseInertia;
    batch.inertiaB[lane.lane] = data.motions[b].inverseInertia;
    return lane;
}

RoundContact& openRound(WorldData& data, std::uint32_t index) {
    const Pair& pair = data.table.pairs[index];
    Contact& kept = data.contacts[pair.contact];
    Batches<RoundBatch>& batches = data.batches.round;
    const Lane lane = openLane(data, batches, pair.bodyA, pair.bodyB);
    kept.place = static_cast<std::uint32_t>(data.roundContacts.size());
    data.table.marks[index].listed = true;
    data.table.gates[index].apartUntil = std::numeric_limits<double>::infinity();
    RoundContact& c = data.roundContacts.emplace_back();
    c = {pair.bodyA, pair.bodyB, index, pair.contact, lane, pair.staticB || kept.restitution > 0, false};
    RoundShapes& shapes = batches.shapes(lane.batch);
    shapes.owner[lane.lane] = kept.place;
    shapes.radiusA[lane.lane] = data.steps[c.a].outerRadius;
    shapes.radiusB[lane.lane] = data.steps[c.b].outerRadius;
    setLane(shapes.here, lane.lane, !pair.staticB);
    RoundBatch& batch = batches[lane.batch];
    const double inverseMass = data.motions[c.a].inverseMass + data.motions[c.b].inverseMass;
    batch.normalMass[lane.lane] = inverseMass > 0 ? 1 / inverseMass : 0;
    batch.friction[lane.lane] = kept.friction;
    batch.normalImpulse[lane.lane] = kept.points[0].normalImpulse;
    batch.tangentImpulse[lane.lane] = kept.tangentImpulse;
    data.anySingle |= c.single;
    ++data.listChanges;
    return c;
}

void noteNeighbours(WorldData& data, const GeneralContact& c, const GeneralContact& d) {
    const auto isStatic = [&](Slot slot) { return data.records[slot].kind == BodyKind::Static; };
    if (c.atWall && d.atWall && (c.b == d.b || (isStatic(c.b) && isStatic(d.b)))) {
        data.neighbours.emplace_back(c.points[0].contact, d.points[0].contact);
    }
}

std::uint32_t keptIn(const RoundContact& c) {
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
            fetch(data.contacts[keptIn(list[i + ahead])]);
        }
        saveImpulses(data, list[i]);
    }
}

/// Fills the gap with the last of the list.
template <class Kind, class Batch>
void strike(WorldData& data, std::vector<Kind>& list, Batches<Batch>& batches, std::uint32_t place) {
    batches.close(list[place].lane);
    if (place + 1 < list.size()) {
        list[place] = list.back();
        const Lane lane = list[place].lane;
        batches.shapes(lane.batch).owner[lane.lane] = place;
        data.contacts[data.table.pairs[pairOf(list[place])].contact].place = place;
    }
    list.pop_back();
}

void followPairs(WorldData& data, std::uint32_t begin, std::uint32_t end) {
    constexpr std::uint32_t ahead = 8;
    for (std::uint32_t i = begin; i < end; ++i) {
        if (i + ahead < end && data.table.marks[i + ahead].listed) {
            fetch(data.contacts[data.table.pairs[i + ahead].contact].place);
        }
        if (!data.table.marks[i].listed) {
            continue;
        }
        const Pair& pair = data.table.pairs[i];
        const std::uint32_t place = data.contacts[pair.contact].place;
        if (pair.kind == PairKind::General) {
            data.generalContacts[place].points[0].pair = data.generalContacts[place].points[1].pair = i;
        } else {
            data.roundContacts[place].pair = i;
        }
    }
}

} // namespace

void listRound(WorldData& data, std::uint32_t pair, const Touch& touch, const RoundTarget& target) {
    Contact& kept = data.contacts[data.table.pairs[pair].contact];
    const bool listed = data.table.marks[pair].listed;
    RoundContact& c = listed ? data.roundContacts[kept.place] : openRound(data, pair);
    const BodyMotion& a = data.motions[c.a];
    const BodyMotion& b = data.motions[c.b];
    RoundBatch& batch = data.batches.round[c.lane.batch];
    const std::uint32_t i = c.lane.lane;
    const double leverA = touch.radiusA + 0.5 * touch.separation;
    const double leverB = -touch.radiusB - 0.5 * touch.separation;
    const double inverseMass = a.inverseMass + b.inverseMass;
    batch.normalX[i] = touch.normal.x();
    batch.normalY[i] = touch.normal.y();
    batch.leverA[i] = leverA;
    batch.leverB[i] = leverB;
    batch.tangentMass[i] = 1 / (inverseMass + a.inverseInertia * leverA * leverA + b.inverseInertia * leverB * leverB);
    batch.separation[i] = touch.separation;
    batch.target[i] = target.velocity;
    batch.closing[i] = target.closing;
    if (beginAt(kept, touch.feature)) {
        batch.normalImpulse[i] = batch.tangentImpulse[i] = 0;
    }
    c.bounces = target.bounces;
    data.anyBounce |= c.bounces;
}

void listGeneral(WorldData& data, const Constraint& constraint, double perSecond) {
    const ConstraintPoint& p = constraint.points[0];
    data.table.marks[p.pair].listed = true;
    data.table.gates[p.pair].apartUntil = std::numeric_limits<double>::infinity();
    data.contacts[p.contact].place = static_cast<std::uint32_t>(data.generalContacts.size());
    GeneralContact& c = data.generalContacts.emplace_back();
    c.a = constraint.a;
    c.b = constraint.b;
    c.atWall = !constraint.alone;
    ++data.listChanges;
    data.wallContacts[c.a] += c.atWall ? 1 : 0;
    c.lane = openLane(data, data.batches.general, c.a, c.b);
    data.batches.general.shapes(c.lane.batch).owner[c.lane.lane] = data.contacts[p.contact].place;
    pack(data, constraint, c, perSecond);
}

void renewGeneral(WorldData& data, const Constraint& constraint, double perSecond) {
    pack(data, constraint, data.generalContacts[data.contacts[constraint.points[0].contact].place], perSecond);
}

void renewSingular(WorldData& data) {
    for (const GeneralContact& c : data.generalContacts) {
        if (c.singular) {
            actForBoth(data.batches.general[c.lane.batch], c.lane.lane);
        }
    }
}

bool beginAt(Contact& contact, std::uint32_t feature) {
    if (contact.count > 0 && contact.points[0].feature == feature) {
        return false;
    }
    contact.count = 1;
    contact.points[0] = {feature, 0};
    contact.tangentImpulse = 0;
    return true;
}

void unlist(WorldData& data, std::uint32_t pair) {
    const Contact& kept = data.contacts[data.table.pairs[pair].contact];
    data.table.marks[pair].listed = data.table.marks[pair].now = false;
    data.table.gates[pair].apartUntil = 0;
    ++data.listChanges;
    if (kept.manifold == Pair::none) {
        strike(data, data.roundContacts, data.batches.round, kept.place);
        return;
    }
    const GeneralContact& c = data.generalContacts[kept.place];
    if (c.atWall) {
        --data.wallContacts[c.a];
        const std::uint32_t gone = c.points[0].contact;
        std::erase_if(data.neighbours, [&](const auto& both) { return both.first == gone || both.second == gone; });
    }
    strike(data, data.generalContacts, data.batches.general, kept.place);
}

void findNeighbours(WorldData& data) {
    const std::vector<GeneralContact>& all = data.generalContacts;
    data.neighbours.clear();
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (!all[i].atWall || data.wallContacts[all[i].a] < 2) {
            continue;
        }
        for (std::size_t j = i + 1; j < all.size() && all[j].a == all[i].a; ++j) {
            noteNeighbours(data, all[i], all[j]);
        }
    }
}

void findNeighboursOfLast(WorldData& data) {
    const GeneralContact& last = data.generalContacts.back();
    if (!last.atWall || data.wallContacts[last.a] < 2) {
        return;
    }
    for (const GeneralContact& other : data.generalContacts) {
        if (other.a == last.a && &other != &last) {
            noteNeighbours(data, other, last);
        }
    }
}

bool anyInOnePlane(const WorldData& data) {
    const auto normal = [&](std::uint32_t contact) {
        const Lane lane = data.generalContacts[data.contacts[contact].place].lane;
        const ConstraintBatch& batch = data.batches.general[lane.batch];
        return Vec2(batch.normalX[lane.lane], batch.normalY[lane.lane]);
    };
    return std::any_of(data.neighbours.begin(), data.neighbours.end(),
                       [&](const auto& both) { return areParallel(normal(both.first), normal(both.second)); });
}

void saveImpulses(WorldData& data, const RoundContact& contact) {
    const RoundBatch& batch = data.batches.round[contact.lane.batch];
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
    if (data.contactsListed) {
        saveAll(data, data.roundContacts);
        saveAll(data, data.generalContacts);
    }
}

void followPairs(WorldData& data) {
    if (!data.contactsListed) {
        return;
    }
    for (const Stretch& s : data.stretches) {
        if (s.to != s.begin) {
            followPairs(data, s.to, s.to + s.end - s.begin);
        }
    }
}

void dropContacts(WorldData& data) {
    if (!data.contactsListed) {
        return;
    }
    saveImpulses(data);
    const auto strikeOut = [&](const auto& c) {
        data.table.marks[pairOf(c)].listed = false;
        data.table.gates[pairOf(c)].apartUntil = 0;
    };
    std::for_each(data.roundContacts.begin(), data.roundContacts.end(), strikeOut);
    std::for_each(data.generalContacts.begin(), data.generalContacts.end(), strikeOut);
    for (const std::uint32_t pair : data.absorbed) {
        data.table.gates[pair].apartUntil = 0;
    }
    data.absorbed.clear();
    data.contactsListed = false;
}

void clearContacts(WorldData& data) {
    data.roundContacts.clear();
    data.generalContacts.clear();
    data.constraints.clear();
    data.batches.round.reset(data.motions.size());
    data.batches.general.reset(data.motions.size());
    data.wallContacts.assign(data.motions.size(), 0);
    data.anySingle = data.anySingular = data.anyBounce = data.mergeDoubt = false;
    data.contactsListed = true;
}

} // namespace spacetow
