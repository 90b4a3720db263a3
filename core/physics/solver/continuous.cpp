#include "core/physics/solver/continuous.h"

#include "core/geometry/cast.h"
#include "core/physics/contacts/general_contacts.h"

#include <algorithm>
#include <cmath>

namespace spacetow {

namespace {

// What was shortened by one hit may now be hit by something else: rounds of looking again.
constexpr int maxRounds = 4;
// A swept body stops this far before the surface, m.
constexpr double gap = 0.5 * linearSlop;
// Long bodies in contact may turn by this much, however thin they are, rad.
constexpr double smallTurn = 0.0125;
// No part of an iteration is shorter than this share of what is left of it.
constexpr double leastShare = 1e-3;

/// Whether anticipation does not cover the motion; see contacts.
bool isFast(const WorldData& data, Slot slot) {
    return travelsFar(data.steps[slot]);
}

Motion plannedMotion(const WorldData& data, Slot slot, double fraction) {
    const BodyStep& s = data.steps[slot];
    return {.start = data.pose(slot), .translation = fraction * s.shift, .turn = fraction * s.turn};
}

bool shorten(BodyStep& s, double fraction, Slot carrier) {
    if (fraction >= s.fraction) {
        return false;
    }
    s.fraction = fraction;
    s.carrier = carrier != noSlot ? carrier : s.carrier;
    return true;
}

/// Of circles nothing is known but of contacts, so that there is no need to look.
bool hasContact(const WorldData& data, const Pair& pair) {
    return pair.contact != Pair::none && (pair.kind != PairKind::General || data.contacts[pair.contact].count > 0);
}

/// What anticipation covers of the way of one body to the other.
double coveredWay(const BodyStep& a, const BodyStep& b, bool staticB) {
    return std::max(0.5 * (a.innerRadius + (staticB ? 0 : b.innerRadius)), linearSlop);
}

/// Bodies that touch at one end may meet at the other. How much of their turn is covered, 1 or more when all is.
double coveredTurn(const WorldData& data, const Pair& pair) {
    const BodyStep& a = data.steps[pair.bodyA];
    const BodyStep& b = data.steps[pair.bodyB];
    const double way = a.turnedWay() + (pair.staticB ? 0 : b.turnedWay());
    const double longest = std::max(a.outerRadius, pair.staticB ? 0 : b.outerRadius);
    const double covered = std::max(coveredWay(a, b, pair.staticB), smallTurn * longest);
    return way > covered ? covered / way : 1;
}

/// Whether one of them, which nothing can stop, comes to the other further than anticipation covers.
bool isRunInto(const WorldData& data, const Pair& pair) {
    if (pair.staticB || (data.motions[pair.bodyA].yields() && data.motions[pair.bodyB].yields())) {
        return false;
    }
    const BodyStep& a = data.steps[pair.bodyA];
    const BodyStep& b = data.steps[pair.bodyB];
    const double way = std::sqrt((a.shift - b.shift).squaredNorm()) + a.turnedWay() + b.turnedWay();
    return way > coveredWay(a, b, false);
}

/// What is stopped is taken along by what cannot be: until then both move.
std::optional<double> impactOf(const WorldData& data, const Pair& pair) {
    const double fractionA = data.steps[pair.bodyA].fraction;
    const double fractionB = pair.staticB ? 1 : data.steps[pair.bodyB].fraction;
    const bool bothYield = pair.staticB || (data.motions[pair.bodyA].yields() && data.motions[pair.bodyB].yields());
    const double both = std::min(fractionA, fractionB);
    const Motion a = plannedMotion(data, pair.bodyA, bothYield ? fractionA : both);
    const Motion b = pair.staticB ? Motion{} : plannedMotion(data, pair.bodyB, bothYield ? fractionB : both);
    if (!pair.staticB) { // what falls side by side is fast, but not towards each other
        const double reach = data.steps[pair.bodyA].outerRadius + data.steps[pair.bodyB].outerRadius + gap +
                             std::sqrt((a.translation - b.translation).squaredNorm());
        if ((a.start.position - b.start.position).squaredNorm() > reach * reach) {
            return std::nullopt;
        }
    }
    return timeOfImpact(*pair.shapeA, a, *pair.shapeB, b, gap);
}

/// Who may be stopped of a pair, and by whom what is stopped is then taken along.
struct Stoppable {
    bool a, b;
    Slot carrierOfA, carrierOfB;
};

Stoppable stoppable(const WorldData& data, const Pair& pair) {
    const bool a = data.motions[pair.bodyA].yields();
    const bool b = !pair.staticB && data.motions[pair.bodyB].yields();
    return {a, b, b || pair.staticB ? noSlot : pair.bodyB, a ? noSlot : pair.bodyA};
}

/// What is left of the ways of a pair.
struct Fractions {
    double a, b;
};

/// True when the motion of either body was cut short.
bool stop(WorldData& data, const Pair& pair, const Stoppable& which, const Fractions& left) {
    bool changed = false;
    if (which.a && shorten(data.steps[pair.bodyA], left.a, which.carrierOfA)) {
        data.shortenedAt[pair.bodyA] = data.looks;
        changed = true;
    }
    if (which.b && shorten(data.steps[pair.bodyB], left.b, which.carrierOfB)) {
        data.shortenedAt[pair.bodyB] = data.looks;
        changed = true;
    }
    return changed;
}

/// Whether contacts have sent one of them where it may meet the other.
bool isDiverted(const WorldData& data, std::uint32_t index) {
    const Pair& pair = data.table.pairs[index];
    const BodyStep& a = data.steps[pair.bodyA];
    const BodyStep& b = data.steps[pair.bodyB];
    if (!(a.diverted || b.diverted) || !data.isGateOpen(index)) {
        return false;
    }
    const double room = roomBetween(data, pair);
    return std::sqrt((a.shift - b.shift).squaredNorm()) + a.turnedWay() + std::abs(b.turn) * (b.outerRadius + room) >=
           room;
}

/// Who is to be stopped where the parts of the pair meet.
Stoppable sweptOf(const WorldData& data, std::uint32_t index) {
    const Pair& pair = data.table.pairs[index];
    Stoppable which = stoppable(data, pair);
    const bool all = pair.sweep || isRunInto(data, pair) || isDiverted(data, index);
    which.a = which.a && (all || isFast(data, pair.bodyA));
    which.b = which.b && (all || isFast(data, pair.bodyB));
    return which;
}

/// True when the motion of either body was cut short.
bool sweepPair(WorldData& data, const Pair& pair, const Stoppable& which) {
    const std::optional<double> hit = impactOf(data, pair);
    // What is near from the start and yet no contact is a corner that another part or wall answers for.
    if (!hit || *hit <= 0 || *hit >= 1) {
        return false;
    }
    return stop(data, pair, which, {data.steps[pair.bodyA].fraction * *hit, data.steps[pair.bodyB].fraction * *hit});
}

/// Likewise.
bool limitTurn(WorldData& data, const Pair& pair) {
    const double covered = coveredTurn(data, pair);
    return covered < 1 && stop(data, pair, stoppable(data, pair), {covered, covered});
}

/// Whether the bodies come near each other however much of their ways they go.
bool waysMeet(const WorldData& data, const Pair& pair) {
    const BodyStep& a = data.steps[pair.bodyA];
    const Vec2& centerA = data.motions[pair.bodyA].center;
    if (pair.staticB) {
        const double reach = a.outerRadius + 2 * gap;
        const Aabb& wall = data.statics->colliders[pair.collider].bounds;
        Aabb way{centerA, centerA};
        way.include(centerA + a.shift);
        return way.grown(reach).overlaps(wall);
    }
    const BodyStep& b = data.steps[pair.bodyB];
    const double wayA = std::abs(a.shift.x()) + std::abs(a.shift.y()); // no less than the length, and cheaper
    const double wayB = std::abs(b.shift.x()) + std::abs(b.shift.y());
    const double both = std::abs(a.shift.x() - b.shift.x()) + std::abs(a.shift.y() - b.shift.y());
    const double reach = a.outerRadius + b.outerRadius + 2 * gap + std::max(both, std::max(wayA, wayB));
    return !((data.motions[pair.bodyB].center - centerA).squaredNorm() > reach * reach);
}

/// Whether the pair is far apart or has a contact, while nothing is fast or bounces.
bool isHarmless(const WorldData& data, std::uint32_t index) {
    const PairGate& gate = data.table.gates[index];
    const bool yield = gate.moverB == 0 || (data.yields[gate.moverA] & data.yields[gate.moverB]) != 0;
    return data.table.marks[index].listed || (yield && !data.isGateOpen(index));
}

/// The pairs whose bodies may have to be stopped, with all that does not change while they are.
void listOnWays(WorldData& data) {
    data.onWays.clear();
    const bool onlyDiverted = !data.anyFast && !data.anySweep;
    for (std::uint32_t i = 0; i < data.table.size(); ++i) {
        const PairGate& gate = data.table.gates[i];
        if ((data.alert[gate.moverA] | data.alert[gate.moverB]) == 0 || (onlyDiverted && isHarmless(data, i))) {
            continue;
        }
        const Pair& pair = data.table.pairs[i];
        if (pair.kind == PairKind::Felt) {
            continue;
        }
        // The solver keeps those that have a contact from closing their gap.
        if (!pair.sweep && hasContact(data, pair)) {
            if (data.anyFast && pair.kind == PairKind::General) {
                data.onWays.push_back({i, pair.bodyA, pair.bodyB, 0, true});
            }
        } else if (waysMeet(data, pair)) {
            const Stoppable which = sweptOf(data, i);
            if (which.a || which.b) {
                data.onWays.push_back({i, pair.bodyA, pair.bodyB, 0, false, which.a, which.b});
            }
        }
    }
}

/// True when a motion was cut short.
bool lookAgain(WorldData& data, OnWay& onWay) {
    const std::uint32_t changed = std::max(data.shortenedAt[onWay.bodyA], data.shortenedAt[onWay.bodyB]);
    if (changed < onWay.lookedAt) {
        return false; // and would find the same
    }
    onWay.lookedAt = ++data.looks;
    const Pair& pair = data.table.pairs[onWay.pair];
    if (onWay.touches) {
        return limitTurn(data, pair);
    }
    Stoppable which = stoppable(data, pair);
    which.a = onWay.stopsA;
    which.b = onWay.stopsB;
    return sweepPair(data, pair, which);
}

} // namespace

double coveredShare(const WorldData& data, double least) {
    double share = 1;
    double impact = 1;
    for (std::size_t i = 0; i < data.table.size(); ++i) {
        if (!data.table.marks[i].covered) {
            continue;
        }
        const Pair& pair = data.table.pairs[i];
        bool touches = hasContact(data, pair);
        if (!touches && isRunInto(data, pair)) {
            const double hit = impactOf(data, pair).value_or(1);
            touches = hit <= 0;
            impact = touches ? impact : std::min(impact, std::max(hit, leastShare));
        }
        if (touches && pair.kind == PairKind::General) {
            share = std::min(share, coveredTurn(data, pair));
        }
    }
    return std::min(std::max(share, least), impact);
}

void stopAtImpacts(WorldData& data) {
    listOnWays(data);
    if (data.onWays.empty()) {
        return;
    }
    data.shortenedAt.assign(data.steps.size(), 0);
    data.looks = 0;
    bool changed = true;
    for (int round = 0; changed && round < maxRounds; ++round) {
        changed = false;
        for (OnWay& onWay : data.onWays) {
            changed |= lookAgain(data, onWay);
        }
    }
}

} // namespace spacetow
