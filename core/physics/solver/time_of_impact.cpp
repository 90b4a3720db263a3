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

// A body that was stopped by one pair may meet another one: rounds over all candidates.
constexpr int maxRounds = 4;
// Distance from the surface at which a swept body stops, m.
constexpr double gap = 0.5 * linearSlop;
// Bodies in contact may always turn by this much in an iteration, rad: thin bodies have hardly any margin.
constexpr double smallTurn = 0.0125;
// The least fraction of the rest of an iteration that one of its parts makes.
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

/// Whether the pair has contact points. A contact of circles always has one: the pool is not read.
bool hasContact(const Contacts& contacts, const Pair& pair) {
    return pair.contact != Pair::none && (pair.kind != PairKind::General || contacts.pool[pair.contact].count > 0);
}

/// The relative motion that the speculative margin covers, m.
double speculativeDistance(const BodyStep& a, const BodyStep& b, bool staticB) {
    return std::max(0.5 * (a.innerRadius + (staticB ? 0 : b.innerRadius)), linearSlop);
}

/// The fraction of the turn of two bodies in contact that the speculative margin covers, at most 1: bodies that touch
/// at one end may meet at the other.
double safeTurnFraction(const Bodies& bodies, const Pair& pair) {
    const BodyStep& a = bodies.steps[pair.bodyA];
    const BodyStep& b = bodies.steps[pair.bodyB];
    // Also each body by its own size: a small body does not turn further because the other one is long.
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

/// Whether one body is immovable and the relative motion exceeds the speculative margin.
bool isHitByUnstoppable(const Bodies& bodies, const Pair& pair) {
    if (pair.staticB || (bodies.motions[pair.bodyA].isMovable() && bodies.motions[pair.bodyB].isMovable())) {
        return false;
    }
    const BodyStep& a = bodies.steps[pair.bodyA];
    const BodyStep& b = bodies.steps[pair.bodyB];
    const double motion =
        std::sqrt((a.deltaPosition - b.deltaPosition).squaredNorm()) + a.maxTurnMotion() + b.maxTurnMotion();
    return motion > speculativeDistance(a, b, false);
}

/// The time of impact of the pair, as a fraction of the motions that are left. A stopped body moves on with an
/// immovable one, so both are swept for the lesser of their fractions.
std::optional<double> timeOfImpactOf(const Bodies& bodies, const Contacts& contacts, std::uint32_t index) {
    const Pair& pair = contacts.table.pairs[index];
    const double fractionA = bodies.steps[pair.bodyA].fraction;
    const double fractionB = pair.staticB ? 1 : bodies.steps[pair.bodyB].fraction;
    const bool bothYield =
        pair.staticB || (bodies.motions[pair.bodyA].isMovable() && bodies.motions[pair.bodyB].isMovable());
    const double both = std::min(fractionA, fractionB);
    const Sweep a = plannedSweep(bodies, pair.bodyA, bothYield ? fractionA : both);
    const Sweep b = pair.staticB ? Sweep{} : plannedSweep(bodies, pair.bodyB, bothYield ? fractionB : both);
    if (!pair.staticB) { // bodies that fall side by side are fast, but do not approach each other
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

/// Which bodies of a pair may be stopped, and the platforms with which they then move on.
struct Stoppable {
    bool a, b;
    Slot platformOfA, platformOfB;
};

Stoppable stoppable(const Bodies& bodies, const Pair& pair) {
    const bool a = bodies.motions[pair.bodyA].isMovable();
    const bool b = !pair.staticB && bodies.motions[pair.bodyB].isMovable();
    return {a, b, b || pair.staticB ? noSlot : pair.bodyB, a ? noSlot : pair.bodyA};
}

/// Fractions of the motions of two bodies.
struct Fractions {
    double a, b;
};

/// Shortens the motions. Returns whether either has changed.
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

/// Whether the parts may come nearer to each other by `distance` metres in this iteration.
bool mayClose(const BodyStep& a, const BodyStep& b, double distance) {
    return std::sqrt((a.deltaPosition - b.deltaPosition).squaredNorm()) + a.maxTurnMotion() +
               std::abs(b.deltaAngle) * (b.outerRadius + distance) >=
           distance;
}

/// Whether contacts have deflected one of the bodies so that it may meet the other.
bool isDeflected(const Bodies& bodies, const Contacts& contacts, std::uint32_t index) {
    const Pair& pair = contacts.table.pairs[index];
    const BodyStep& a = bodies.steps[pair.bodyA];
    const BodyStep& b = bodies.steps[pair.bodyB];
    return (a.deflected || b.deflected) && contacts.mayTouchNow(bodies, index) &&
           mayClose(a, b, separationBoundOf(bodies, contacts, pair));
}

/// Whether contacts have deflected one of the bodies so far that the pair, which has a contact, may meet at points that
/// its manifold lacks: the manifold was made with the speculative margin of the motion without contacts. A circle has
/// one point only.
bool isDeflectedPastManifold(const Bodies& bodies, const Contacts& contacts, const Pair& pair) {
    const BodyStep& a = bodies.steps[pair.bodyA];
    const BodyStep& b = bodies.steps[pair.bodyB];
    return (a.deflected || b.deflected) && pair.kind == PairKind::General && hasContact(contacts, pair) &&
           !std::holds_alternative<Circle>(*pair.shapeA) && !std::holds_alternative<Circle>(*pair.shapeB) &&
           mayClose(a, b, std::max(toleranceLeftOf(bodies, contacts, pair), 0.0));
}

/// Which bodies of a pair without a contact the time of impact stops.
Stoppable sweptOf(const Bodies& bodies, const Contacts& contacts, std::uint32_t index) {
    const Pair& pair = contacts.table.pairs[index];
    Stoppable which = stoppable(bodies, pair);
    const bool all = pair.sweep || isHitByUnstoppable(bodies, pair) || isDeflected(bodies, contacts, index);
    which.a = which.a && (all || isFast(bodies, pair.bodyA));
    which.b = which.b && (all || isFast(bodies, pair.bodyB));
    return which;
}

/// Limits the turn of bodies in contact. Returns whether a motion was shortened.
bool limitTurn(const ToiStage& stage, const Pair& pair) {
    const double covered = safeTurnFraction(stage.bodies, pair);
    return covered < 1 && stop(stage, pair, stoppable(stage.bodies, pair), {covered, covered});
}

/// The penetration of the parts, m, after this share of the motions that are left.
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

/// Stops a pair that touches from the beginning where its penetration begins to grow. The solver has no constraint for
/// a corner that will bounce or that an impact elsewhere turns in, and a sweep finds the first touch only. Returns
/// whether a motion was shortened.
bool stopDeepening(const ToiStage& stage, const Pair& pair) {
    constexpr int visits = 16;
    const double covered = safeTurnFraction(stage.bodies, pair);
    const double most = depthAt(stage.bodies, pair, 0) + linearSlop;
    int visit = 1; // at least one: a pair that is stopped at once would never move again
    while (visit < visits && depthAt(stage.bodies, pair, covered * (visit + 1) / visits) <= most) {
        ++visit;
    }
    const double share = covered * visit / visits;
    const Stoppable which = stoppable(stage.bodies, pair);
    return share < 1 &&
           stop(stage, pair, which,
                {stage.bodies.steps[pair.bodyA].fraction * share, stage.bodies.steps[pair.bodyB].fraction * share});
}

/// Stops a pair at its time of impact. Returns whether a motion was shortened.
bool sweepPair(const ToiStage& stage, std::uint32_t index, const Stoppable& which) {
    const Pair& pair = stage.contacts.table.pairs[index];
    const std::optional<double> hit = timeOfImpactOf(stage.bodies, stage.contacts, index);
    if (hit && *hit <= 0 && hasContact(stage.contacts, pair) && pair.kind == PairKind::General) {
        return stopDeepening(stage, pair);
    }
    // Parts that are near from the start without a contact meet at a corner that belongs to another part or wall.
    if (!hit || *hit <= 0 || *hit >= 1) {
        return false;
    }
    return stop(stage, pair, which,
                {stage.bodies.steps[pair.bodyA].fraction * *hit, stage.bodies.steps[pair.bodyB].fraction * *hit});
}

/// Whether the bounds of the swept bodies overlap.
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
    const double motion =
        std::max({oneNorm(a.deltaPosition - b.deltaPosition), oneNorm(a.deltaPosition), oneNorm(b.deltaPosition)});
    const double reach = a.outerRadius + b.outerRadius + 2 * gap + motion;
    return !((bodies.motions[pair.bodyB].center - centerA).squaredNorm() > reach * reach);
}

/// Whether the pair needs no time of impact in an iteration in which no body is fast and no pair bounces: it is beyond
/// its separation bound, or has a contact whose manifold suffices.
bool cannotHit(const Bodies& bodies, const Contacts& contacts, std::uint32_t index) {
    if (isDeflectedPastManifold(bodies, contacts, contacts.table.pairs[index])) {
        return false;
    }
    const PairBound& bound = contacts.table.bounds[index];
    const bool yield =
        bound.moverB == Mover::Static || (bodies.movable[bound.moverA] & bodies.movable[bound.moverB]) != 0;
    return contacts.table.flags[index].inSolver || (yield && !contacts.mayTouchNow(bodies, index));
}

/// Lists the pairs whose bodies may have to be stopped, with their properties that do not change while bodies are
/// stopped.
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
        // The solver keeps a pair with a contact from closing its gap.
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

/// Returns whether a motion was shortened.
bool visit(const ToiStage& stage, ToiCandidate& candidate) {
    const std::uint32_t changed =
        std::max(stage.toi.shortenedAt[candidate.bodyA], stage.toi.shortenedAt[candidate.bodyB]);
    if (changed < candidate.visitedAt) {
        return false; // nothing has changed since its last visit
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
