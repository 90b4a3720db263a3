#include "core/physics/contacts/contacts.h"

#include "core/base/prefetch.h"
#include "core/geometry/collide.h"
#include "core/geometry/overlaps.h"
#include "core/physics/contacts/contact_lanes.h"
#include "core/physics/contacts/contact_pool.h"
#include "core/physics/contacts/contact_rules.h"
#include "core/physics/contacts/general_contacts.h"
#include "core/physics/contacts/merge_contacts.h"
#include "core/physics/contacts/open_pairs.h"
#include "core/physics/contacts/order_contacts.h"
#include "core/physics/lanes/solver_kernels.h"

#include <algorithm>
#include <cmath>

namespace spacetow {

namespace {

Transform poseOfB(const WorldData& data, const Pair& pair) {
    return pair.staticB ? Transform{} : data.pose(pair.bodyB);
}

/// Without a look at them until they may have met.
void letGo(WorldData& data, std::uint32_t index, double separation) {
    Pair& pair = data.table.pairs[index];
    if (data.table.marks[index].listed) {
        unlist(data, index);
    }
    forgetContact(data, pair);
    PairGate& gate = data.table.gates[index];
    gate.apartUntil = data.milesOf(gate) + separation;
}

Approach approach(const WorldData& data, const Pair& pair, const Vec2& normal) {
    const Vec2 before = data.steps[pair.bodyB].startVelocity - data.steps[pair.bodyA].startVelocity;
    const Vec2 after = data.motions[pair.bodyB].velocity - data.motions[pair.bodyA].velocity;
    return {-before.dot(normal), -after.dot(normal)};
}

/// Parts that are to bounce where they meet have no contact until then.
void sweepRound(WorldData& data, std::uint32_t index, std::uint32_t feature) {
    Pair& pair = data.table.pairs[index];
    if (data.table.marks[index].listed) {
        saveImpulses(data, data.roundContacts[data.contacts[pair.contact].place]);
        unlist(data, index);
    }
    beginAt(data.contacts[pair.contact], feature);
    pair.sweep = true;
    data.anySweep = true;
    data.steps[pair.bodyA].bouncing = data.steps[pair.bodyB].bouncing = true;
}

void addRoundContact(WorldData& data, std::uint32_t index, const Touch& touch, double perSecond) {
    Pair& pair = data.table.pairs[index];
    const Contact& kept = contactOf(data, pair);
    const double closing = -perSecond * roomToClose(touch.separation);
    RoundTarget aim{touch.separation > 0 ? -touch.separation * perSecond : 0, closing, false};
    if (kept.restitution > 0) {
        const Target target =
            targetOf(approach(data, pair, touch.normal), touch.separation, kept.restitution, perSecond);
        if (target.meeting == Meeting::WillBounce) {
            sweepRound(data, index, touch.feature);
            return;
        }
        aim = {target.velocity, closing, target.meeting == Meeting::Bounces};
    }
    listRound(data, index, touch, aim);
}

void meetRound(WorldData& data, std::uint32_t index, double perSecond) {
    const Pair& pair = data.table.pairs[index];
    const BodyWay& a = data.ways[pair.bodyA + 1];
    const BodyWay& b = data.ways[pair.bodyB + 1];
    const double radiusA = data.reaches[pair.bodyA + 1].outerRadius;
    const double radiusB = data.reaches[pair.bodyB + 1].outerRadius;
    const Vec2 apart = b.center - a.center;
    const double margin = contactMargin(a, b);
    const double reach = radiusA + radiusB + margin;
    const double squared = apart.squaredNorm();
    const double distance = std::sqrt(squared);
    if (squared > reach * reach) {
        letGo(data, index, distance - radiusA - radiusB);
        return;
    }
    const Vec2 normal = distance > 0 ? Vec2(apart / distance) : Vec2(0, 1);
    addRoundContact(data, index, {normal, distance - radiusA - radiusB, radiusA, radiusB, 0}, perSecond);
}

void meetStatic(WorldData& data, std::uint32_t index, double perSecond) {
    Pair& pair = data.table.pairs[index];
    const BodyWay& way = data.ways[pair.bodyA + 1];
    const Circle circle{way.center, std::get<Circle>(*pair.shapeA).radius};
    const double margin = contactMargin(way);
    const Manifold manifold = pair.kind == PairKind::RoundEdge
                                  ? sideAgainstCircle(data.statics->colliders[pair.collider].side, circle, margin)
                                  : collideCircle(*pair.shapeB, circle, margin);
    if (manifold.count == 0) {
        letGo(data, index, manifold.apart);
        return;
    }
    const ManifoldPoint& point = manifold.points[0];
    addRoundContact(data, index, {-manifold.normal, point.separation, circle.radius, 0, point.feature}, perSecond);
}

SPACETOW_FETCHES void fetchWall(const WorldData& data, const Pair& pair) {
    if (pair.kind == PairKind::RoundEdge) {
        fetch(data.statics->colliders[pair.collider].side);
    }
}

/// What is known of contacts lies in the order in which they came about, so the processor has to be told early what
/// will be looked at: first the pair, then its contact, then its manifold.
SPACETOW_FETCHES void fetchAhead(const WorldData& data, const std::vector<std::uint32_t>& open, std::size_t at) {
    constexpr std::size_t ahead = 6;
    const std::vector<Pair>& pairs = data.table.pairs;
    if (at + 3 * ahead < open.size()) {
        __builtin_prefetch(&pairs[open[at + 3 * ahead]]);
    }
    const auto contactAt = [&](std::size_t index) {
        return index < open.size() ? pairs[open[index]].contact : Pair::none;
    };
    if (const std::uint32_t contact = contactAt(at + 2 * ahead); contact != Pair::none) {
        __builtin_prefetch(&data.contacts[contact]);
    }
    const std::uint32_t contact = contactAt(at + ahead);
    if (contact != Pair::none && data.contacts[contact].manifold != Pair::none) {
        fetch(data.manifolds[data.contacts[contact].manifold]);
    }
}

/// The same for the surfaces of pairs whose manifolds are made anew.
SPACETOW_FETCHES void fetchShapes(const WorldData& data, const std::vector<std::uint32_t>& open, std::size_t at) {
    constexpr std::size_t ahead = 3;
    if (at + ahead < open.size() && data.table.pairs[open[at + ahead]].kind == PairKind::General) {
        const Pair& pair = data.table.pairs[open[at + ahead]];
        fetch(*pair.shapeA);
        fetch(*pair.shapeB);
        fetch(data.motions[pair.bodyA]);
        fetch(data.motions[pair.bodyB]);
    }
}

/// Where a body was when it had gone this part of its way.
Transform poseAt(const WorldData& data, Slot slot, double fraction) {
    const BodyMotion& m = data.motions[slot];
    const BodyStep& s = data.steps[slot];
    const double left = fraction - 1;
    return {m.center + left * s.shift, turned(m.rotation, left * s.turn)};
}

// So often at most what is felt is looked for on the way of an iteration.
constexpr int maxLooks = 64;

/// Whether the parts meet at the end of the iteration, or did on the way where that is longer than the bodies are wide.
bool haveMet(const WorldData& data, const Pair& pair) {
    if (overlaps(*pair.shapeA, data.pose(pair.bodyA), *pair.shapeB, poseOfB(data, pair))) {
        return true;
    }
    const BodyStep& a = data.steps[pair.bodyA];
    const BodyStep& b = data.steps[pair.bodyB];
    const double way = a.reach() + (pair.staticB ? 0 : b.reach());
    const double wide = a.innerRadius + (pair.staticB ? 0 : b.innerRadius);
    const int looks = way <= wide ? 1 : way < maxLooks * wide ? static_cast<int>(std::ceil(way / wide)) : maxLooks;
    for (int look = 1; look < looks; ++look) {
        const double fraction = static_cast<double>(look) / looks;
        const Transform poseB = pair.staticB ? Transform{} : poseAt(data, pair.bodyB, fraction);
        if (overlaps(*pair.shapeA, poseAt(data, pair.bodyA, fraction), *pair.shapeB, poseB)) {
            return true;
        }
    }
    return false;
}

/// After that the contacts are listed anew, in the order of their pairs: bodies that are near each other are so in
/// memory, too, and piles converge better.
std::size_t mostChanges(const WorldData& data) {
    return (data.roundContacts.size() + data.generalContacts.size()) / 8;
}

void meet(WorldData& data, std::uint32_t index, double perSecond) {
    const PairKind kind = data.table.pairs[index].kind;
    if (kind == PairKind::RoundRound) {
        meetRound(data, index, perSecond);
    } else if (kind == PairKind::RoundEdge || kind == PairKind::RoundStatic) {
        meetStatic(data, index, perSecond);
    } else {
        meetGeneral(data, index, perSecond);
    }
}

void beginAnew(WorldData& data, std::uint32_t index) {
    data.table.marks[index].now = false;
    data.table.pairs[index].sweep = false;
}

/// Looks at all pairs that are not listed and may have come into contact.
void meetOpen(WorldData& data, double perSecond) {
    listOpen(data);
    for (std::size_t k = 0; k < data.open.size(); ++k) {
        fetchAhead(data, data.open, k);
        const std::uint32_t i = data.open[k];
        if (data.table.pairs[i].kind != PairKind::Felt) {
            beginAnew(data, i);
            meet(data, i, perSecond);
        }
    }
}

void listContacts(WorldData& data, double perSecond) {
    dropContacts(data);
    clearContacts(data);
    data.anySweep = false;
    meetOpen(data, perSecond);
    mergeContacts(data);
    orderContacts(data);
    for (const Constraint& constraint : data.constraints) {
        listGeneral(data, constraint, perSecond);
    }
    findNeighbours(data);
    data.listChanges = 0;
    data.justListed = true;
}

/// Those that the batches cannot renew by themselves.
void renewSingle(WorldData& data, double perSecond) {
    constexpr std::size_t ahead = 8;
    for (std::size_t i = data.roundContacts.size(); data.anySingle && i-- > 0;) {
        if (i >= 2 * ahead) {
            __builtin_prefetch(&data.table.pairs[data.roundContacts[i - 2 * ahead].pair]);
        }
        if (i >= ahead) {
            fetchWall(data, data.table.pairs[data.roundContacts[i - ahead].pair]);
        }
        if (data.roundContacts[i].single) {
            meet(data, data.roundContacts[i].pair, perSecond);
        }
    }
}

/// Adds the pairs of outdated contacts to those that are to be looked at.
template <class Kind, class Batch>
void openOutdated(WorldData& data, const std::vector<Kind>& list, const Batches<Batch>& batches) {
    forLanes(batches, &BatchNotes::outdated,
             [&](Lane at) { data.open.push_back(pairOf(list[batches.shapes(at.batch).owner[at.lane]])); });
}

void meetOutdated(WorldData& data, double perSecond) {
    data.open.clear();
    openOutdated(data, data.roundContacts, data.batches.round);
    openOutdated(data, data.generalContacts, data.batches.general);
    for (std::size_t k = 0; k < data.open.size(); ++k) {
        fetchAhead(data, data.open, k);
        fetchShapes(data, data.open, k);
        const std::uint32_t pair = data.open[k];
        if (data.table.pairs[pair].kind == PairKind::General) {
            renewManifold(data, pair, perSecond);
        } else {
            meetRound(data, pair, perSecond);
        }
    }
}

bool anyMergedOutdated(const WorldData& data) {
    return std::any_of(data.generalContacts.begin(), data.generalContacts.end(), [&](const GeneralContact& c) {
        return c.merged && (data.batches.general.notes(c.lane.batch).outdated >> c.lane.lane & 1) != 0;
    });
}

/// The contacts that there are, from where the bodies are now; then what may have come or gone. False when there are
/// too many changes, or contacts may lie in one plane in another way than before.
bool renewContacts(WorldData& data, double perSecond) {
    if (!data.contactsListed || data.mergeDoubt) {
        return false;
    }
    data.anySweep = data.anyBounce = data.justListed = false;
    data.constraints.clear();
    const BodyWay* first = data.ways.data() + 1;
    refreshContacts(data.batches, {{&first->center, sizeof(BodyWay)}, {&first->shift, sizeof(BodyWay)}}, perSecond);
    if (!data.absorbed.empty() && anyMergedOutdated(data)) {
        return false;
    }
    meetOutdated(data, perSecond);
    renewSingle(data, perSecond);
    meetOpen(data, perSecond);
    if (data.anySingular) {
        renewSingular(data);
    }
    for (const Constraint& constraint : data.constraints) {
        listGeneral(data, constraint, perSecond);
        findNeighboursOfLast(data);
    }
    return data.listChanges <= mostChanges(data) && !anyInOnePlane(data);
}

} // namespace

void findContacts(WorldData& data, const IterationStep& step) {
    const double perSecond = 1 / step.dt;
    if (!renewContacts(data, perSecond)) {
        listContacts(data, perSecond);
    }
}

void findOverlaps(WorldData& data) {
    for (const std::uint32_t i : data.felt) {
        data.table.marks[i].now = haveMet(data, data.table.pairs[i]);
    }
}

} // namespace spacetow
