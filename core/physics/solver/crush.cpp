#include "core/physics/solver/crush.h"

#include "core/geometry/cast.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace spacetow {

namespace {

// Bodies in wedges meet several things that stand still: rounds of looking again.
constexpr int roundsOfKeeping = 8;
// What is stopped stops this far before the surface, m.
constexpr double stopGap = 0.5 * linearSlop;
// By position correction a point of what touches what stands still turns this far at most in an iteration, m: corners
// that have no contact yet may come down on it.
constexpr double mostTurned = 4 * linearSlop;
// Who is overlapped by no more than this share of the inner radius, or this way, m, is not yet crushed.
constexpr double crushShare = 0.1;
constexpr double crushDepth = 4 * linearSlop;

/// A point of contact, as a body sees it that can be moved.
struct Sight {
    Slot body, other;
    Vec2 towards; // unit, from the body to the other
    double lever; // m, of a push along that
    double separation;
};

template <class Visit>
void seeBoth(const Bodies& bodies, const Sight& ofA, double leverB, const Visit& visit) {
    if (bodies.motions[ofA.body].isMovable()) {
        visit(ofA);
    }
    if (bodies.motions[ofA.other].isMovable()) {
        visit(Sight{ofA.other, ofA.body, -ofA.towards, -leverB, ofA.separation});
    }
}

enum class With { Anything, Immovable };

/// Visits all points of contact, with anything or with what nothing can move, of bodies that a kinematic one may push.
template <class Visit>
void forSights(const Bodies& bodies, const Constraints& constraints, const SolverScratch& solver, With with,
               const Visit& visit) {
    const std::vector<std::uint8_t>& pushed = solver.pushedByKinematic;
    const auto isSeen = [&](const auto& c) {
        return (with == With::Anything || !bodies.motions[c.a].isMovable() || !bodies.motions[c.b].isMovable()) &&
               (pushed[c.a] | pushed[c.b]) != 0;
    };
    for (const CircleContact& c : constraints.circleContacts) {
        if (isSeen(c)) {
            const CircleBatch& batch = constraints.batches.circles[c.lane.batch];
            const std::uint32_t i = c.lane.lane;
            seeBoth(bodies, {c.a, c.b, {batch.normalX[i], batch.normalY[i]}, 0, batch.separation[i]}, 0, visit);
        }
    }
    for (const GeneralContact& c : constraints.generalContacts) {
        if (isSeen(c)) {
            const ConstraintBatch& batch = constraints.batches.general[c.lane.batch];
            const std::uint32_t i = c.lane.lane;
            const Vec2 normal(batch.normalX[i], batch.normalY[i]);
            seeBoth(bodies, {c.a, c.b, normal, batch.leverA1[i], batch.separation1[i]}, batch.leverB1[i], visit);
            seeBoth(bodies, {c.a, c.b, normal, batch.leverA2[i], batch.separation2[i]}, batch.leverB2[i], visit);
        }
    }
}

bool hasStatics(const BroadPhase& broadPhase) {
    return !broadPhase.statics->colliders.empty() || broadPhase.staticChanges || !broadPhase.changedStatics.empty();
}

bool stands(const Bodies& bodies, Slot slot) {
    return !bodies.motions[slot].isMovable() && !bodies.motions[slot].isMoving();
}

/// How far the body comes to the other in this iteration, m.
double approach(const Bodies& bodies, const Sight& at) {
    const BodyStep& s = bodies.steps[at.body];
    return at.towards.dot(s.fraction * s.deltaPosition + s.correction) +
           at.lever * (s.fraction * s.deltaAngle + s.angleCorrection);
}

/// How much further the body would go into what stands still than it may, m.
double excess(const Bodies& bodies, const Sight& at) {
    return approach(bodies, at) - std::max(at.separation + linearSlop, 0.0);
}

void stopClosing(Bodies& bodies, const Sight& at) {
    BodyMotion& m = bodies.motions[at.body];
    const double speed = at.towards.dot(m.velocity) + at.lever * m.angularVelocity;
    if (speed > 0) {
        m.velocity -= speed * at.towards;
    }
}

void limitTurns(Bodies& bodies, const Constraints& constraints, const SolverScratch& solver) {
    forSights(bodies, constraints, solver, With::Immovable, [&](const Sight& at) {
        if (stands(bodies, at.other)) {
            BodyStep& s = bodies.steps[at.body];
            const double most = mostTurned / s.outerRadius;
            s.angleCorrection = std::clamp(s.angleCorrection, -most, most);
        }
    });
}

/// True when the way of a body had to be changed; these are listed.
bool keepOutOnce(Bodies& bodies, const Constraints& constraints, const SolverScratch& solver, std::vector<Slot>& kept) {
    bool changed = false;
    forSights(bodies, constraints, solver, With::Immovable, [&](const Sight& at) {
        const double tooFar = stands(bodies, at.other) ? excess(bodies, at) : 0;
        if (tooFar > 0) {
            BodyStep& s = bodies.steps[at.body];
            if (tooFar > linearSlop) {
                s.deltaAngle = s.angleCorrection = 0;
            }
            s.correction -= std::max(excess(bodies, at), 0.0) * at.towards;
            stopClosing(bodies, at);
            kept.push_back(at.body);
            changed = true;
        }
    });
    return changed;
}

void halt(BodyStep& s) {
    s.fraction = s.angleCorrection = 0;
    s.correction.setZero();
}

Vec2 centerAfterStop(const Bodies& bodies, Slot slot) {
    const BodyStep& s = bodies.steps[slot];
    return bodies.motions[slot].center + s.fraction * s.deltaPosition;
}

Transform poseAfterStop(const Bodies& bodies, Slot slot) {
    const BodyStep& s = bodies.steps[slot];
    return {centerAfterStop(bodies, slot), turned(bodies.motions[slot].rotation, s.fraction * s.deltaAngle)};
}

/// By position corrections, or with its platform.
bool isDisplaced(const Bodies& bodies, const SolverScratch& solver, Slot slot) {
    const BodyStep& s = bodies.steps[slot];
    return solver.pushedByKinematic[slot] != 0 && (s.correction != Vec2(0, 0) || s.angleCorrection != 0);
}

/// Visits the pairs of these bodies with static ones that they have no contact with.
template <class Visit>
void forUnmet(const Bodies& bodies, const Contacts& contacts, const SolverScratch& solver, const Visit& visit) {
    for (std::uint32_t i = 0; i < contacts.table.size(); ++i) {
        const Pair& pair = contacts.table.pairs[i];
        if (pair.staticB && pair.kind != PairKind::Sensor && !contacts.table.flags[i].inSolver &&
            isDisplaced(bodies, solver, pair.bodyA)) {
            visit(pair);
        }
    }
}

double freeShare(const Pair& pair, const Sweep& way) {
    return timeOfImpact(*pair.shapeA, way, *pair.shapeB, Sweep{}, stopGap).value_or(1);
}

/// What is between two that do not give way.
struct Squeeze {
    Slot body;
    Slot against = noSlot;
    Slot by = noSlot;
    double depth = 0; // m, of the overlap at the end of the iteration
};

/// Position corrections and platforms do not take a body through what it has not yet met.
void stopDisplaced(Bodies& bodies, const Contacts& contacts, const SolverScratch& solver,
                   std::vector<Squeeze>& stopped) {
    forUnmet(bodies, contacts, solver, [&](const Pair& pair) {
        BodyStep& s = bodies.steps[pair.bodyA];
        const Transform start = poseAfterStop(bodies, pair.bodyA);
        const double share = freeShare(pair, {.start = start, .translation = s.correction, .turn = s.angleCorrection});
        s.correction *= share;
        s.angleCorrection *= share;
        if (share < 1) {
            stopped.push_back({pair.bodyA, pair.bodyB});
        }
    });
}

/// What is kept out of one thing and would go into another goes nowhere.
void stopWedged(const CrushStage& stage, const std::vector<Slot>& kept) {
    forSights(stage.bodies, stage.constraints, stage.solver, With::Immovable, [&](const Sight& at) {
        if (stands(stage.bodies, at.other) && excess(stage.bodies, at) > linearSlop) {
            halt(stage.bodies.steps[at.body]);
        }
    });
    forUnmet(stage.bodies, stage.contacts, stage.solver, [&](const Pair& pair) {
        BodyStep& s = stage.bodies.steps[pair.bodyA];
        const Sweep way{.start = stage.bodies.pose(pair.bodyA),
                        .translation = s.fraction * s.deltaPosition + s.correction,
                        .turn = s.fraction * s.deltaAngle + s.angleCorrection};
        if (std::find(kept.begin(), kept.end(), pair.bodyA) != kept.end() && freeShare(pair, way) < 1) {
            halt(s);
        }
    });
}

void noteSqueeze(const Bodies& bodies, const Sight& at, Squeeze& squeeze) {
    if (stands(bodies, at.other)) {
        squeeze.against = at.separation <= linearSlop + approach(bodies, at) ? at.other : squeeze.against;
        return;
    }
    const BodyStep& other = bodies.steps[at.other];
    const Vec2 wayOfOther = other.fraction * other.deltaPosition + other.correction;
    const double depth = approach(bodies, at) - at.towards.dot(wayOfOther) - at.separation;
    if (depth > squeeze.depth) {
        squeeze.depth = depth;
        squeeze.by = at.other;
    }
}

/// By body, each once.
void sortOut(std::vector<Squeeze>& squeezes) {
    std::stable_sort(squeezes.begin(), squeezes.end(), [](const auto& a, const auto& b) { return a.body < b.body; });
    const auto same = [](const Squeeze& a, const Squeeze& b) { return a.body == b.body; };
    squeezes.erase(std::unique(squeezes.begin(), squeezes.end(), same), squeezes.end());
}

/// Of those that were kept out or stopped in this iteration, and those that have been crushed before: they are until
/// they are free on one side.
void reportCrushed(const CrushStage& stage, std::vector<Squeeze>& squeezes, int iteration) {
    for (const BodyId body : stage.crushed) {
        squeezes.push_back({body.index});
    }
    sortOut(squeezes);
    for (Squeeze& squeeze : squeezes) {
        squeeze.depth = std::max(crushShare * stage.bodies.steps[squeeze.body].innerRadius, crushDepth);
    }
    forSights(stage.bodies, stage.constraints, stage.solver, With::Anything, [&](const Sight& at) {
        const auto found = std::lower_bound(squeezes.begin(), squeezes.end(), at.body,
                                            [](const Squeeze& squeeze, Slot body) { return squeeze.body < body; });
        if (found != squeezes.end() && found->body == at.body) {
            noteSqueeze(stage.bodies, at, *found);
        }
    });
    const std::vector<BodyId> before = std::exchange(stage.crushed, {});
    for (const Squeeze& squeeze : squeezes) {
        const BodyId body = stage.bodies.idOf(squeeze.body);
        if (squeeze.by == noSlot || squeeze.against == noSlot) {
            continue;
        }
        stage.crushed.push_back(body);
        if (std::find(before.begin(), before.end(), body) == before.end()) {
            stage.events.crushed.push_back(
                {iteration, body, stage.bodies.idOf(squeeze.by), stage.bodies.idOf(squeeze.against)});
        }
    }
}

} // namespace

bool mayCrush(const CrushStage& stage) {
    const std::vector<Slot>& moving = stage.bodies.moving;
    const std::vector<std::uint8_t>& pushed = stage.solver.pushedByKinematic;
    const auto isStill = [&](Slot slot) { return stands(stage.bodies, slot); };
    const auto isPushed = [&](Slot slot) { return slot < pushed.size() && pushed[slot] != 0; };
    const bool anyStands = hasStatics(stage.broadPhase) || !stage.sleep.sleepers.empty() ||
                           std::any_of(moving.begin(), moving.end(), isStill);
    return anyStands && std::any_of(moving.begin(), moving.end(), isPushed);
}

void measureCorrections(Bodies& bodies, StepFlags& flags, const SolverScratch& solver, PairSearch& search) {
    search.movedBodies.clear();
    for (const Slot slot : bodies.moving) {
        BodyStep& s = bodies.steps[slot];
        const Vec2 end = centerAfterStop(bodies, slot) + s.correction;
        s.movedProxy = isDisplaced(bodies, solver, slot) &&
                       (!s.fat.centers.contains(end) ||
                        std::abs(s.fraction * s.deltaAngle) + std::abs(s.angleCorrection) > s.fat.angleLeft);
        if (s.movedProxy) {
            search.movedBodies.push_back(slot);
        }
    }
    flags.anyMovedProxy = !search.movedBodies.empty();
}

void keepOutOfStatics(const CrushStage& stage, int iteration) {
    limitTurns(stage.bodies, stage.constraints, stage.solver);
    std::vector<Squeeze> squeezes;
    stopDisplaced(stage.bodies, stage.contacts, stage.solver, squeezes);
    std::vector<Slot> kept;
    bool changed = true;
    for (int round = 0; round < roundsOfKeeping && changed; ++round) {
        changed = keepOutOnce(stage.bodies, stage.constraints, stage.solver, kept);
    }
    if (!kept.empty()) {
        stopWedged(stage, kept);
    }
    for (const Slot slot : kept) {
        squeezes.push_back({slot});
    }
    if (!squeezes.empty() || !stage.crushed.empty()) {
        reportCrushed(stage, squeezes, iteration);
    }
}

} // namespace spacetow
