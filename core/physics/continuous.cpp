#include "core/physics/continuous.h"

#include "core/geometry/cast.h"
#include "core/physics/general_contacts.h"

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

bool hasContact(const WorldData& data, const Pair& pair) {
    return pair.contact != Pair::none && data.contacts[pair.contact].count > 0;
}

double turnedWay(const BodyStep& s) {
    return s.round ? 0 : std::abs(s.turn) * s.outerRadius;
}

/// What anticipation covers of the way of one body to the other.
double coveredWay(const BodyStep& a, const BodyStep& b, bool staticB) {
    return std::max(0.5 * (a.innerRadius + (staticB ? 0 : b.innerRadius)), linearSlop);
}

/// Bodies that touch at one end may meet at the other. How much of their turn is covered, 1 or more when all is.
double coveredTurn(const WorldData& data, const Pair& pair) {
    const BodyStep& a = data.steps[pair.bodyA];
    const BodyStep& b = data.steps[pair.bodyB];
    const double way = turnedWay(a) + (pair.staticB ? 0 : turnedWay(b));
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
    const double way = std::sqrt((a.shift - b.shift).squaredNorm()) + turnedWay(a) + turnedWay(b);
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

/// True when the motion of either body was cut short.
bool stop(WorldData& data, const Pair& pair, const Stoppable& which, double fractionA, double fractionB) {
    bool changed = false;
    if (which.a) {
        changed |= shorten(data.steps[pair.bodyA], fractionA, which.carrierOfA);
    }
    if (which.b) {
        changed |= shorten(data.steps[pair.bodyB], fractionB, which.carrierOfB);
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
    return std::sqrt((a.shift - b.shift).squaredNorm()) + turnedWay(a) + std::abs(b.turn) * (b.outerRadius + room) >=
           room;
}

/// Likewise.
bool sweepPair(WorldData& data, std::uint32_t index) {
    const Pair& pair = data.table.pairs[index];
    Stoppable which = stoppable(data, pair);
    const bool all = pair.sweep || isRunInto(data, pair) || isDiverted(data, index);
    which.a = which.a && (all || isFast(data, pair.bodyA));
    which.b = which.b && (all || isFast(data, pair.bodyB));
    if (!which.a && !which.b) {
        return false;
    }
    const std::optional<double> hit = impactOf(data, pair);
    // What is near from the start and yet no contact is a corner that another part or wall answers for.
    if (!hit || *hit <= 0 || *hit >= 1) {
        return false;
    }
    return stop(data, pair, which, data.steps[pair.bodyA].fraction * *hit, data.steps[pair.bodyB].fraction * *hit);
}

/// Likewise.
bool limitTurn(WorldData& data, const Pair& pair) {
    const double covered = coveredTurn(data, pair);
    return covered < 1 && stop(data, pair, stoppable(data, pair), covered, covered);
}

void findCarrier(WorldData& data, Slot a, Slot b, std::uint32_t pair) {
    if (!data.table.marks[pair].now || data.table.pairs[pair].staticB) {
        return;
    }
    if (!data.motions[a].yields()) {
        data.steps[b].carrier = a;
    } else if (!data.motions[b].yields()) {
        data.steps[a].carrier = b;
    }
}

bool anyKinematic(const WorldData& data) {
    return !data.moving.empty() && data.records[data.moving.front()].kind == BodyKind::Kinematic;
}

void carry(WorldData& data, Slot slot) {
    BodyStep& s = data.steps[slot];
    const BodyStep& by = data.steps[s.carrier];
    const double rest = 1 - s.fraction;
    const Vec2 start = data.motions[slot].center + s.fraction * s.shift;
    const Vec2 arm = start - data.motions[s.carrier].center - s.fraction * by.shift;
    s.push += rest * by.shift;
    if (by.turn != 0) {
        s.push += turned(Rot{}, rest * by.turn) * arm - arm;
        s.pushTurn += s.round ? 0 : rest * by.turn;
    }
}

} // namespace

double coveredShare(const WorldData& data, double least) {
    double share = 1;
    double impact = 1;
    for (const Pair& pair : data.table.pairs) {
        if (pair.kind == PairKind::Felt) {
            continue;
        }
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
    data.onWays.clear();
    for (std::uint32_t i = 0; i < data.table.size(); ++i) {
        const PairGate& gate = data.table.gates[i];
        if ((data.alert[gate.moverA] | data.alert[gate.moverB]) != 0 && data.table.pairs[i].kind != PairKind::Felt) {
            data.onWays.push_back(i);
        }
    }
    bool changed = true;
    for (int round = 0; changed && round < maxRounds; ++round) {
        changed = false;
        for (const std::uint32_t i : data.onWays) {
            const Pair& pair = data.table.pairs[i];
            // The solver keeps those that have a contact from closing their gap.
            if (pair.sweep || !hasContact(data, pair)) {
                changed |= sweepPair(data, i);
            } else if (data.anyFast && pair.kind == PairKind::General) {
                changed |= limitTurn(data, pair);
            }
        }
    }
}

void findCarriers(WorldData& data) {
    if (!anyKinematic(data)) {
        return;
    }
    for (const RoundContact& c : data.roundContacts) {
        findCarrier(data, c.a, c.b, c.pair);
    }
    for (const GeneralContact& c : data.generalContacts) {
        findCarrier(data, c.a, c.b, c.points[0].pair);
    }
}

void carryStopped(WorldData& data) {
    if (!anyKinematic(data)) {
        return;
    }
    for (const Slot slot : data.moving) {
        if (data.steps[slot].fraction < 1 && data.steps[slot].carrier != noSlot) {
            carry(data, slot);
        }
    }
}

} // namespace spacetow
