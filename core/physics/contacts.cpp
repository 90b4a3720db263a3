#include "core/physics/contacts.h"

#include "core/geometry/collide.h"
#include "core/geometry/overlaps.h"
#include "core/physics/contact_pool.h"
#include "core/physics/contact_rules.h"
#include "core/physics/general_contacts.h"
#include "core/physics/merge_contacts.h"

#include <cmath>

namespace spacetow {

namespace {

Transform poseOfB(const WorldData& data, const Pair& pair) {
    return pair.staticB ? Transform{} : data.pose(pair.bodyB);
}

Lane roundLane(WorldData& data, const Pair& pair) {
    return data.batches.round.open(pair.bodyA, data.motions[pair.bodyA].yields(), pair.bodyB,
                                   !pair.staticB && data.motions[pair.bodyB].yields());
}

/// A round contact's surfaces.
struct Touch {
    Vec2 normal; // from a to b
    double separation;
    double radiusA, radiusB; // from the centres of mass to the surfaces along the normal; of static bodies 0
    std::uint32_t feature;
};

/// Without a look at them until they may have met.
void letGo(WorldData& data, std::uint32_t index, double separation) {
    Pair& pair = data.table.pairs[index];
    forgetContact(data, pair);
    data.table.gates[index].apartUntil =
        data.steps[pair.bodyA].travelled + data.steps[pair.bodyB].travelled + separation;
}

Approach approach(const WorldData& data, const Pair& pair, const Vec2& normal) {
    const Vec2 before = data.steps[pair.bodyB].startVelocity - data.steps[pair.bodyA].startVelocity;
    const Vec2 after = data.motions[pair.bodyB].velocity - data.motions[pair.bodyA].velocity;
    return {-before.dot(normal), -after.dot(normal)};
}

void addRoundContact(WorldData& data, std::uint32_t index, const Touch& touch, double perSecond) {
    Pair& pair = data.table.pairs[index];
    Contact& kept = contactOf(data, pair);
    if (kept.count == 0 || kept.points[0].feature != touch.feature) {
        kept.count = 1;
        kept.points[0] = {touch.feature, 0};
        kept.tangentImpulse = 0;
    }
    Target target;
    target.velocity = touch.separation > 0 ? -touch.separation * perSecond : 0;
    if (kept.restitution > 0) {
        target = targetOf(approach(data, pair, touch.normal), touch.separation, kept.restitution, perSecond);
        if (target.meeting == Meeting::WillBounce) {
            pair.sweep = true;
            data.anySweep = true;
            data.steps[pair.bodyA].bouncing = data.steps[pair.bodyB].bouncing = true;
            return;
        }
    }
    const BodyMotion& a = data.motions[pair.bodyA];
    const BodyMotion& b = data.motions[pair.bodyB];
    const Lane lane = roundLane(data, pair);
    data.roundContacts.push_back(
        {pair.bodyA, pair.bodyB, index, pair.contact, lane, target.meeting == Meeting::Bounces, touch.separation});
    const double leverA = touch.radiusA + 0.5 * touch.separation;
    const double leverB = -touch.radiusB - 0.5 * touch.separation;
    const double inverseMass = a.inverseMass + b.inverseMass;
    RoundBatch& batch = data.batches.round[lane.batch];
    const std::uint32_t i = lane.lane;
    batch.normalX[i] = touch.normal.x();
    batch.normalY[i] = touch.normal.y();
    batch.massA[i] = a.inverseMass;
    batch.massB[i] = b.inverseMass;
    batch.inertiaA[i] = a.inverseInertia;
    batch.inertiaB[i] = b.inverseInertia;
    batch.leverA[i] = leverA;
    batch.leverB[i] = leverB;
    batch.normalMass[i] = inverseMass > 0 ? 1 / inverseMass : 0;
    batch.tangentMass[i] = 1 / (inverseMass + a.inverseInertia * leverA * leverA + b.inverseInertia * leverB * leverB);
    batch.friction[i] = kept.friction;
    batch.target[i] = target.velocity;
    batch.closing[i] = -perSecond * roomToClose(touch.separation);
    batch.normalImpulse[i] = kept.points[0].normalImpulse;
    batch.tangentImpulse[i] = kept.tangentImpulse;
}

void meetRound(WorldData& data, std::uint32_t index, double perSecond) {
    const Pair& pair = data.table.pairs[index];
    const double radiusA = data.steps[pair.bodyA].outerRadius;
    const double radiusB = data.steps[pair.bodyB].outerRadius;
    const Vec2 apart = data.motions[pair.bodyB].center - data.motions[pair.bodyA].center;
    const double margin = contactMargin(data.steps[pair.bodyA], data.steps[pair.bodyB]);
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
    const BodyStep& s = data.steps[pair.bodyA];
    const Circle circle{data.motions[pair.bodyA].center, std::get<Circle>(*pair.shapeA).radius};
    const double margin = contactMargin(s);
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

/// What is known of contacts lies in the order in which they came about, so the processor has to be told early.
void fetchAhead(const WorldData& data, std::uint32_t index) {
    constexpr std::uint32_t ahead = 8;
    const PairTable& table = data.table;
    if (index + 2 * ahead < table.size() && table.pairs[index + 2 * ahead].contact != Pair::none) {
        __builtin_prefetch(&data.contacts[table.pairs[index + 2 * ahead].contact]);
    }
    if (index + ahead >= table.size() || table.pairs[index + ahead].contact == Pair::none) {
        return;
    }
    const std::uint32_t manifold = data.contacts[table.pairs[index + ahead].contact].manifold;
    if (manifold != Pair::none) {
        const auto* address = reinterpret_cast<const char*>(&data.manifolds[manifold]);
        for (std::size_t line = 0; line < sizeof(KeptManifold); line += 64) {
            __builtin_prefetch(address + line);
        }
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

} // namespace

void findContacts(WorldData& data, const IterationStep& step) {
    data.roundContacts.clear();
    data.constraints.clear();
    data.batches.round.reset(data.motions.size());
    data.anySweep = false;
    const double perSecond = 1 / step.dt;
    const auto count = static_cast<std::uint32_t>(data.table.size());
    for (std::uint32_t i = 0; i < count; ++i) {
        fetchAhead(data, i);
        if (!data.isGateOpen(i)) {
            continue;
        }
        Pair& pair = data.table.pairs[i];
        if (pair.kind == PairKind::Felt) {
            continue;
        }
        data.table.marks[i].now = false;
        pair.sweep = false;
        if (pair.kind == PairKind::RoundRound) {
            meetRound(data, i, perSecond);
        } else if (pair.kind == PairKind::RoundEdge || pair.kind == PairKind::RoundStatic) {
            meetStatic(data, i, perSecond);
        } else {
            meetGeneral(data, i, perSecond);
        }
    }
    mergeContacts(data);
}

void findOverlaps(WorldData& data) {
    for (const std::uint32_t i : data.felt) {
        data.table.marks[i].now = haveMet(data, data.table.pairs[i]);
    }
}

} // namespace spacetow
