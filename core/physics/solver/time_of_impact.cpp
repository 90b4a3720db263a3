#include "core/physics/solver/time_of_impact.h"

#include "core/geometry/cast.h"
#include "core/geometry/collide.h"
#include "core/physics/contacts/open_walls.h"
#include "core/physics/contacts/update_manifold.h"
#include "core/physics/solver/contact_graph.h"

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
constexpr double leastFraction = 1e-3;

/// Whether the speculative margin does not cover the motion; see contact_rules.h.
bool isFast(const Bodies& bodies, Slot slot) {
    return isFast(bodies.steps[slot]);
}

Sweep plannedSweep(const Bodies& bodies, Slot slot, double fraction) {
    const BodyStep& s = bodies.steps[slot];
    return {.start = bodies.pose(slot), .translation = fraction * s.deltaPosition, .turn = fraction * s.deltaAngle};
}

bool shortenMotion(BodyStep& s, double fraction, Slot platform) {
    if (fraction >= s.fraction) {
        return false;
    }
    s.fraction = fraction;
    s.platform = platform != noSlot ? platform : s.platform;
    return true;
}

/// Of circles nothing is known but of contacts, so that there is no need to look.
bool hasContact(const Contacts& contacts, const Pair& pair) {
    return pair.contact != Pair::none && (pair.kind != PairKind::General || contacts.pool[pair.contact].count > 0);
}

/// The motion of one body towards the other that the speculative margin covers, m.
double speculativeDistance(const BodyStep& a, const BodyStep& b, bool staticB) {
    return std::max(0.5 * (a.innerRadius + (staticB ? 0 : b.innerRadius)), linearSlop);
}

/// Bodies that touch at one end may meet at the other. How much of their turn is covered, 1 or more when all is.
double safeTurnFraction(const Bodies& bodies, const Pair& pair) {
    const BodyStep& a = bodies.steps[pair.bodyA];
    const BodyStep& b = bodies.steps[pair.bodyB];
    // Each by its own length, too: what is small is not to turn further because the wall that it touches is long.
    const double least = speculativeDistance(a, b, pair.staticB);
    const auto share = [&](double way, double longest) {
        const double covered = std::max(least, smallTurn * longest);
        return way > covered ? covered / way : 1;
    };
    if (pair.staticB) {
        return share(a.maxTurnMotion(), a.outerRadius);
    }
    const double both = share(a.maxTurnMotion() + b.maxTurnMotion(), std::max(a.outerRadius, b.outerRadius));
    const double each = std::min(share(a.maxTurnMotion(), a.outerRadius), share(b.maxTurnMotion(), b.outerRadius));
    return std::min(both, each);
}

/// Whether one of them, which nothing can stop, moves towards the other by more than the speculative margin.
bool isHitByUnstoppable(const Bodies& bodies, const Pair& pair) {
    if (pair.staticB || (bodies.motions[pair.bodyA].isMovable() && bodies.motions[pair.bodyB].isMovable())) {
        return false;
    }
    const BodyStep& a = bodies.steps[pair.bodyA];
    const BodyStep& b = bodies.steps[pair.bodyB];
    const double way =
        std::sqrt((a.deltaPosition - b.deltaPosition).squaredNorm()) + a.maxTurnMotion() + b.maxTurnMotion();
    return way > speculativeDistance(a, b, false);
}

/// What is stopped is taken along by what cannot be: until then both move.
std::optional<double> timeOfImpactOf(const Bodies& bodies, const Contacts& contacts, std::uint32_t index) {
    const Pair& pair = contacts.table.pairs[index];
    const double fractionA = bodies.steps[pair.bodyA].fraction;
    const double fractionB = pair.staticB ? 1 : bodies.steps[pair.bodyB].fraction;
    const bool bothYield =
        pair.staticB || (bodies.motions[pair.bodyA].isMovable() && bodies.motions[pair.bodyB].isMovable());
    const double both = std::min(fractionA, fractionB);
    const Sweep a = plannedSweep(bodies, pair.bodyA, bothYield ? fractionA : both);
    const Sweep b = pair.staticB ? Sweep{} : plannedSweep(bodies, pair.bodyB, bothYield ? fractionB : both);
    if (!pair.staticB) { // what falls side by side is fast, but not towards each other
        const double reach = bodies.steps[pair.bodyA].outerRadius + bodies.steps[pair.bodyB].outerRadius + gap +
                             std::sqrt((a.translation - b.translation).squaredNorm());
        if ((a.start.position - b.start.position).squaredNorm() > reach * reach) {
            return std::nullopt;
        }
    }
    const auto atOpenWall = [&] { return timeOfImpactAtOpenWall(*pair.shapeA, a, *pair.shapeB, b, gap); };
    if (contacts.table.flags[index].passage == Passage::Passing) {
        return atOpenWall();
    }
    const std::optional<double> hit = timeOfImpact(*pair.shapeA, a, *pair.shapeB, b, gap);
    return hit && isPassedByBody(bodies, contacts.table, index) ? atOpenWall() : hit;
}

/// Who may be stopped of a pair, and by whom what is stopped is then taken along.
struct Stoppable {
    bool a, b;
    Slot platformOfA, platformOfB;
};

Stoppable stoppable(const Bodies& bodies, const Pair& pair) {
    const bool a = bodies.motions[pair.bodyA].isMovable();
    const bool b = !pair.staticB && bodies.motions[pair.bodyB].isMovable();
    return {a, b, b || pair.staticB ? noSlot : pair.bodyB, a ? noSlot : pair.bodyA};
}

/// Of the motions of a pair.
struct Fractions {
    double a, b;
};

/// True when the motion of either body was cut short.
bool stop(const ToiStage& stage, const Pair& pair, const Stoppable& which, const Fractions& left) {
    bool changed = false;
    if (which.a && shortenMotion(stage.bodies.steps[pair.bodyA], left.a, which.platformOfA)) {
        stage.toi.shortenedAt[pair.bodyA] = stage.toi.visits;
        changed = true;
    }
    if (which.b && shortenMotion(stage.bodies.steps[pair.bodyB], left.b, which.platformOfB)) {
        stage.toi.shortenedAt[pair.bodyB] = stage.toi.visits;
        changed = true;
    }
    return changed;
}

/// Whether in this iteration the parts come nearer each other by as much as this, m.
bool mayClose(const BodyStep& a, const BodyStep& b, double distance) {
    return std::sqrt((a.deltaPosition - b.deltaPosition).squaredNorm()) + a.maxTurnMotion() +
               std::abs(b.deltaAngle) * (b.outerRadius + distance) >=
           distance;
}

/// Whether contacts have sent one of them where it may meet the other.
bool isDeflected(const Bodies& bodies, const Contacts& contacts, std::uint32_t index) {
    const Pair& pair = contacts.table.pairs[index];
    const BodyStep& a = bodies.steps[pair.bodyA];
    const BodyStep& b = bodies.steps[pair.bodyB];
    return (a.deflected || b.deflected) && contacts.mayTouchNow(bodies, index) &&
           mayClose(a, b, separationBoundOf(bodies, contacts, pair));
}

/// Whether other contacts have sent one of them so far that it may meet the other at points that their manifold lacks:
/// the speculative margin in which these were looked for is that of the motion without contacts. A circle has one
/// point.
bool isDeflectedPastManifold(const Bodies& bodies, const Contacts& contacts, const Pair& pair) {
    const BodyStep& a = bodies.steps[pair.bodyA];
    const BodyStep& b = bodies.steps[pair.bodyB];
    return (a.deflected || b.deflected) && pair.kind == PairKind::General && hasContact(contacts, pair) &&
           !std::holds_alternative<Circle>(*pair.shapeA) && !std::holds_alternative<Circle>(*pair.shapeB) &&
           mayClose(a, b, std::max(toleranceLeftOf(bodies, contacts, pair), 0.0));
}

/// Who is to be stopped where the parts of the pair meet.
Stoppable sweptOf(const Bodies& bodies, const Contacts& contacts, std::uint32_t index) {
    const Pair& pair = contacts.table.pairs[index];
    Stoppable which = stoppable(bodies, pair);
    const bool all = pair.sweep || isHitByUnstoppable(bodies, pair) || isDeflected(bodies, contacts, index);
    which.a = which.a && (all || isFast(bodies, pair.bodyA));
    which.b = which.b && (all || isFast(bodies, pair.bodyB));
    return which;
}

/// True when the motion of either body was cut short.
bool limitTurn(const ToiStage& stage, const Pair& pair) {
    const double covered = safeTurnFraction(stage.bodies, pair);
    return covered < 1 && stop(stage, pair, stoppable(stage.bodies, pair), {covered, covered});
}

/// How deep the parts are in each other when they have gone this share of what is left of their ways, m.
double depthAt(const Bodies& bodies, const Pair& pair, double share) {
    const Transform a = plannedSweep(bodies, pair.bodyA, share * bodies.steps[pair.bodyA].fraction).at(1);
    const Transform b =
        pair.staticB ? Transform{} : plannedSweep(bodies, pair.bodyB, share * bodies.steps[pair.bodyB].fraction).at(1);
    const Manifold manifold = collide(*pair.shapeA, a, *pair.shapeB, b, 0);
    double depth = 0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(manifold.count); ++i) {
        depth = std::max(depth, -manifold.points[i].separation);
    }
    return depth;
}

/// Where one corner touches another may be about to bounce, or a hit elsewhere may turn it in: the solver does not know
/// of it, and a sweep sees the first alone. Looks where it goes in. True when the motion of either body was cut short.
bool stopDeepening(const ToiStage& stage, const Pair& pair) {
    constexpr int visits = 16;
    const double covered = safeTurnFraction(stage.bodies, pair);
    const double most = depthAt(stage.bodies, pair, 0) + linearSlop;
    int visit = 1; // who goes nowhere would look the same for ever
    while (visit < visits && depthAt(stage.bodies, pair, covered * (visit + 1) / visits) <= most) {
        ++visit;
    }
    const double share = covered * visit / visits;
    const Stoppable which = stoppable(stage.bodies, pair);
    return share < 1 &&
           stop(stage, pair, which,
                {stage.bodies.steps[pair.bodyA].fraction * share, stage.bodies.steps[pair.bodyB].fraction * share});
}

/// True when the motion of either body was cut short.
bool sweepPair(const ToiStage& stage, std::uint32_t index, const Stoppable& which) {
    const Pair& pair = stage.contacts.table.pairs[index];
    const std::optional<double> hit = timeOfImpactOf(stage.bodies, stage.contacts, index);
    if (hit && *hit <= 0 && hasContact(stage.contacts, pair) && pair.kind == PairKind::General) {
        return stopDeepening(stage, pair);
    }
    // What is near from the start and yet no contact is a corner that another part or wall answers for.
    if (!hit || *hit <= 0 || *hit >= 1) {
        return false;
    }
    return stop(stage, pair, which,
                {stage.bodies.steps[pair.bodyA].fraction * *hit, stage.bodies.steps[pair.bodyB].fraction * *hit});
}

/// Whether the bodies come near each other at any fraction of their motions.
bool sweptBoundsOverlap(const Bodies& bodies, const BroadPhase& broadPhase, const Pair& pair) {
    const BodyStep& a = bodies.steps[pair.bodyA];
    const Vec2& centerA = bodies.motions[pair.bodyA].center;
    if (pair.staticB) {
        const double reach = a.outerRadius + 2 * gap;
        const Aabb& wall = broadPhase.staticCollider(pair.collider).bounds;
        Aabb way{centerA, centerA};
        way.include(centerA + a.deltaPosition);
        return way.grown(reach).overlaps(wall);
    }
    const BodyStep& b = bodies.steps[pair.bodyB];
    const double wayA =
        std::abs(a.deltaPosition.x()) + std::abs(a.deltaPosition.y()); // no less than the length, and cheaper
    const double wayB = std::abs(b.deltaPosition.x()) + std::abs(b.deltaPosition.y());
    const double both =
        std::abs(a.deltaPosition.x() - b.deltaPosition.x()) + std::abs(a.deltaPosition.y() - b.deltaPosition.y());
    const double reach = a.outerRadius + b.outerRadius + 2 * gap + std::max(both, std::max(wayA, wayB));
    return !((bodies.motions[pair.bodyB].center - centerA).squaredNorm() > reach * reach);
}

/// Whether the pair is far apart or has a contact that holds, while nothing is fast or bounces.
bool cannotHit(const Bodies& bodies, const Contacts& contacts, std::uint32_t index) {
    if (isDeflectedPastManifold(bodies, contacts, contacts.table.pairs[index])) {
        return false;
    }
    const PairBound& bound = contacts.table.bounds[index];
    const bool yield =
        bound.moverB == Mover::Static || (bodies.movable[bound.moverA] & bodies.movable[bound.moverB]) != 0;
    return contacts.table.flags[index].inSolver || (yield && !contacts.mayTouchNow(bodies, index));
}

/// The pairs whose bodies may have to be stopped, with all that does not change while they are.
void listToiCandidates(const ToiStage& stage) {
    stage.toi.candidates.clear();
    const bool onlyDeflected = !stage.flags.anyFast && !stage.flags.anySweep;
    for (std::uint32_t i = 0; i < stage.contacts.table.size(); ++i) {
        const PairBound& bound = stage.contacts.table.bounds[i];
        if ((stage.bodies.mayNeedToi[bound.moverA] | stage.bodies.mayNeedToi[bound.moverB]) == 0 ||
            (onlyDeflected && cannotHit(stage.bodies, stage.contacts, i))) {
            continue;
        }
        const Pair& pair = stage.contacts.table.pairs[i];
        if (pair.kind == PairKind::Sensor) {
            continue;
        }
        // The solver keeps those that have a contact from closing their gap.
        if (!pair.sweep && hasContact(stage.contacts, pair)) {
            const bool deepens = isDeflectedPastManifold(stage.bodies, stage.contacts, pair);
            if (deepens || (stage.flags.anyFast && pair.kind == PairKind::General)) {
                stage.toi.candidates.push_back({i, pair.bodyA, pair.bodyB, 0, true, deepens});
            }
        } else if (sweptBoundsOverlap(stage.bodies, stage.broadPhase, pair)) {
            const Stoppable which = sweptOf(stage.bodies, stage.contacts, i);
            if (which.a || which.b) {
                stage.toi.candidates.push_back({i, pair.bodyA, pair.bodyB, 0, false, false, which.a, which.b});
            }
        }
    }
}

/// True when a motion was cut short.
bool visit(const ToiStage& stage, ToiCandidate& candidate) {
    const std::uint32_t changed =
        std::max(stage.toi.shortenedAt[candidate.bodyA], stage.toi.shortenedAt[candidate.bodyB]);
    if (changed < candidate.visitedAt) {
        return false; // and would find the same
    }
    candidate.visitedAt = ++stage.toi.visits;
    const Pair& pair = stage.contacts.table.pairs[candidate.pair];
    if (candidate.touches) {
        return candidate.deepens ? stopDeepening(stage, pair) : limitTurn(stage, pair);
    }
    Stoppable which = stoppable(stage.bodies, pair);
    which.a = candidate.stopsA;
    which.b = candidate.stopsB;
    return sweepPair(stage, candidate.pair, which);
}

} // namespace

double safeFraction(const Bodies& bodies, const Contacts& contacts, double least) {
    double share = 1;
    double impact = 1;
    for (std::size_t i = 0; i < contacts.table.size(); ++i) {
        if (!contacts.table.flags[i].limitsFraction) {
            continue;
        }
        const Pair& pair = contacts.table.pairs[i];
        bool touches = hasContact(contacts, pair);
        if (!touches && isHitByUnstoppable(bodies, pair)) {
            const double hit = timeOfImpactOf(bodies, contacts, static_cast<std::uint32_t>(i)).value_or(1);
            touches = hit <= 0;
            impact = touches ? impact : std::min(impact, std::max(hit, leastFraction));
        }
        if (touches && pair.kind == PairKind::General) {
            share = std::min(share, safeTurnFraction(bodies, pair));
        }
    }
    return std::min(std::max(share, least), impact);
}

void stopAtImpacts(const ToiStage& stage) {
    listToiCandidates(stage);
    if (stage.toi.candidates.empty()) {
        return;
    }
    beginBySlot(stage.toi.shortenedAt, stage.bodies.steps.size(), std::uint32_t{0});
    for (const Slot slot : stage.bodies.moving) {
        stage.toi.shortenedAt[slot] = 0;
    }
    stage.toi.visits = 0;
    bool changed = true;
    for (int round = 0; changed && round < maxRounds; ++round) {
        changed = false;
        for (ToiCandidate& candidate : stage.toi.candidates) {
            changed |= visit(stage, candidate);
        }
    }
}

} // namespace spacetow
