#include "core/physics/solver/crush.h"

#include "core/geometry/cast.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace spacetow {

namespace {

// A body in a wedge touches several fixed bodies: rounds over all contacts.
constexpr int crushRounds = 8;
// Distance from the surface at which a displaced body stops, m.
constexpr double stopGap = 0.5 * linearSlop;
// Limit of the motion by which position correction turns the rim of a body that touches a fixed one in an iteration, m:
// corners that have no contact yet would penetrate.
constexpr double mostTurnMotion = 4 * linearSlop;
// A body counts as crushed if the overlap exceeds both this share of its inner radius and this length, m.
constexpr double crushShare = 0.1;
constexpr double crushDepth = 4 * linearSlop;

/// A contact point on a movable body.
struct PushedContact {
    Slot body, other;
    Vec2 towards;      // unit, from the body to the other
    double lever;      // m, of an impulse along `towards`
    double separation; // m
};

template <class Visit>
void visitBoth(const Bodies& bodies, const PushedContact& onA, double leverB, const Visit& visit) {
    if (bodies.motions[onA.body].isMovable()) {
        visit(onA);
    }
    if (bodies.motions[onA.other].isMovable()) {
        visit(PushedContact{onA.other, onA.body, -onA.towards, -leverB, onA.separation});
    }
}

enum class ContactsWith { AllBodies, ImmovableBodies };

/// Visits the contact points, with all or with immovable bodies, of the bodies that a kinematic body may push; a
/// contact of two movable bodies once for each.
template <class Visit>
void forPushedContacts(const Bodies& bodies, const Constraints& constraints, const SolverScratch& solver,
                       ContactsWith with, const Visit& visit) {
    const std::vector<std::uint8_t>& pushed = solver.pushedByKinematic;
    const auto isVisited = [&](const auto& c) {
        return (with == ContactsWith::AllBodies || !bodies.motions[c.a].isMovable() ||
                !bodies.motions[c.b].isMovable()) &&
               (pushed[c.a] | pushed[c.b]) != 0;
    };
    for (const CircleContact& c : constraints.circleContacts) {
        if (isVisited(c)) {
            const CircleBatch& batch = constraints.batches.circles[c.lane.batch];
            const std::uint32_t i = c.lane.lane;
            visitBoth(bodies, {c.a, c.b, {batch.normalX[i], batch.normalY[i]}, 0, batch.separation[i]}, 0, visit);
        }
    }
    for (const GeneralContact& c : constraints.generalContacts) {
        if (isVisited(c)) {
            const ConstraintBatch& batch = constraints.batches.general[c.lane.batch];
            const std::uint32_t i = c.lane.lane;
            const Vec2 normal(batch.normalX[i], batch.normalY[i]);
            visitBoth(bodies, {c.a, c.b, normal, batch.leverA1[i], batch.separation1[i]}, batch.leverB1[i], visit);
            visitBoth(bodies, {c.a, c.b, normal, batch.leverA2[i], batch.separation2[i]}, batch.leverB2[i], visit);
        }
    }
}

bool hasStatics(const BroadPhase& broadPhase) {
    return !broadPhase.statics->colliders.empty() || broadPhase.staticChanges || !broadPhase.changedStatics.empty();
}

/// Whether the body is immovable and does not move.
bool isFixed(const Bodies& bodies, Slot slot) {
    return !bodies.motions[slot].isMovable() && !bodies.motions[slot].isMoving();
}

/// The motion of the body towards the other in this iteration, position correction included, m.
double approach(const Bodies& bodies, const PushedContact& at) {
    const BodyStep& s = bodies.steps[at.body];
    return at.towards.dot(s.fraction * s.deltaPosition + s.correction) +
           at.lever * (s.fraction * s.deltaAngle + s.angleCorrection);
}

/// By how much the motion would exceed a penetration of the slop, m.
double excess(const Bodies& bodies, const PushedContact& at) {
    return approach(bodies, at) - std::max(at.separation + linearSlop, 0.0);
}

/// Removes the velocity towards the other body.
void stopClosing(Bodies& bodies, const PushedContact& at) {
    BodyMotion& m = bodies.motions[at.body];
    const double speed = at.towards.dot(m.velocity) + at.lever * m.angularVelocity;
    if (speed > 0) {
        m.velocity -= speed * at.towards;
    }
}

/// Limits the turn by position correction of bodies that touch fixed ones.
void limitTurns(Bodies& bodies, const Constraints& constraints, const SolverScratch& solver) {
    forPushedContacts(bodies, constraints, solver, ContactsWith::ImmovableBodies, [&](const PushedContact& at) {
        if (isFixed(bodies, at.other)) {
            BodyStep& s = bodies.steps[at.body];
            const double most = mostTurnMotion / s.outerRadius;
            s.angleCorrection = std::clamp(s.angleCorrection, -most, most);
        }
    });
}

/// Shortens the motion of bodies that would penetrate fixed ones by more than the slop, and appends these bodies to
/// `limited`. Returns whether there are any.
bool removeExcess(Bodies& bodies, const Constraints& constraints, const SolverScratch& solver,
                  std::vector<Slot>& limited) {
    bool changed = false;
    forPushedContacts(bodies, constraints, solver, ContactsWith::ImmovableBodies, [&](const PushedContact& at) {
        const double tooFar = isFixed(bodies, at.other) ? excess(bodies, at) : 0;
        if (tooFar > 0) {
            BodyStep& s = bodies.steps[at.body];
            if (tooFar > linearSlop) {
                s.deltaAngle = s.angleCorrection = 0;
            }
            s.correction -= std::max(excess(bodies, at), 0.0) * at.towards;
            stopClosing(bodies, at);
            limited.push_back(at.body);
            changed = true;
        }
    });
    return changed;
}

void stopMotion(BodyStep& s) {
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

/// Whether position correction or a platform moves a pushed body.
bool isDisplaced(const Bodies& bodies, const SolverScratch& solver, Slot slot) {
    const BodyStep& s = bodies.steps[slot];
    return solver.pushedByKinematic[slot] != 0 && (s.correction != Vec2(0, 0) || s.angleCorrection != 0);
}

/// Visits the pairs of displaced bodies with static bodies that have no contact.
template <class Visit>
void forStaticPairsWithoutContact(const Bodies& bodies, const Contacts& contacts, const SolverScratch& solver,
                                  const Visit& visit) {
    for (std::uint32_t i = 0; i < contacts.table.size(); ++i) {
        const Pair& pair = contacts.table.pairs[i];
        if (pair.staticB && pair.kind != PairKind::Sensor && !contacts.table.flags[i].inSolver &&
            isDisplaced(bodies, solver, pair.bodyA)) {
            visit(pair);
        }
    }
}

/// The fraction of the motion before the time of impact; 1 without an impact.
double freeFraction(const Pair& pair, const Sweep& motion) {
    return timeOfImpact(*pair.shapeA, motion, *pair.shapeB, Sweep{}, stopGap).value_or(1);
}

/// A body that may be crushed.
struct CrushCandidate {
    Slot body;
    Slot against = noSlot;
    Slot by = noSlot;
    double depth = 0; // m, of the overlap at the end of the iteration
};

/// Stops displaced bodies at static bodies that they have no contact with.
void stopDisplaced(Bodies& bodies, const Contacts& contacts, const SolverScratch& solver,
                   std::vector<CrushCandidate>& stopped) {
    forStaticPairsWithoutContact(bodies, contacts, solver, [&](const Pair& pair) {
        BodyStep& s = bodies.steps[pair.bodyA];
        const Transform start = poseAfterStop(bodies, pair.bodyA);
        const double share =
            freeFraction(pair, {.start = start, .translation = s.correction, .turn = s.angleCorrection});
        s.correction *= share;
        s.angleCorrection *= share;
        if (share < 1) {
            stopped.push_back({pair.bodyA, pair.bodyB});
        }
    });
}

/// Stops bodies that were limited at one fixed body and would penetrate another one.
void stopWedged(const CrushStage& stage, const std::vector<Slot>& limited) {
    forPushedContacts(stage.bodies, stage.constraints, stage.solver, ContactsWith::ImmovableBodies,
                      [&](const PushedContact& at) {
                          if (isFixed(stage.bodies, at.other) && excess(stage.bodies, at) > linearSlop) {
                              stopMotion(stage.bodies.steps[at.body]);
                          }
                      });
    forStaticPairsWithoutContact(stage.bodies, stage.contacts, stage.solver, [&](const Pair& pair) {
        BodyStep& s = stage.bodies.steps[pair.bodyA];
        const Sweep motion{.start = stage.bodies.pose(pair.bodyA),
                           .translation = s.fraction * s.deltaPosition + s.correction,
                           .turn = s.fraction * s.deltaAngle + s.angleCorrection};
        if (std::find(limited.begin(), limited.end(), pair.bodyA) != limited.end() && freeFraction(pair, motion) < 1) {
            stopMotion(s);
        }
    });
}

void updateCandidate(const Bodies& bodies, const PushedContact& at, CrushCandidate& candidate) {
    if (isFixed(bodies, at.other)) {
        candidate.against = at.separation <= linearSlop + approach(bodies, at) ? at.other : candidate.against;
        return;
    }
    const BodyStep& other = bodies.steps[at.other];
    const Vec2 motionOfOther = other.fraction * other.deltaPosition + other.correction;
    const double depth = approach(bodies, at) - at.towards.dot(motionOfOther) - at.separation;
    if (depth > candidate.depth) {
        candidate.depth = depth;
        candidate.by = at.other;
    }
}

/// Sorts the candidates by body; of several with one body the first remains.
void sortByBody(std::vector<CrushCandidate>& candidates) {
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](const auto& a, const auto& b) { return a.body < b.body; });
    const auto same = [](const CrushCandidate& a, const CrushCandidate& b) { return a.body == b.body; };
    candidates.erase(std::unique(candidates.begin(), candidates.end(), same), candidates.end());
}

/// Finds the crushed bodies among the candidates and those that were crushed in the last iteration, and adds events for
/// new ones. A body remains crushed until it is free on one side.
void reportCrushed(const CrushStage& stage, std::vector<CrushCandidate>& candidates, int iteration) {
    for (const BodyId body : stage.crushed) {
        candidates.push_back({body.index});
    }
    sortByBody(candidates);
    for (CrushCandidate& candidate : candidates) {
        candidate.depth = std::max(crushShare * stage.bodies.steps[candidate.body].innerRadius, crushDepth);
    }
    forPushedContacts(
        stage.bodies, stage.constraints, stage.solver, ContactsWith::AllBodies, [&](const PushedContact& at) {
            const auto found =
                std::lower_bound(candidates.begin(), candidates.end(), at.body,
                                 [](const CrushCandidate& candidate, Slot body) { return candidate.body < body; });
            if (found != candidates.end() && found->body == at.body) {
                updateCandidate(stage.bodies, at, *found);
            }
        });
    const std::vector<BodyId> before = std::exchange(stage.crushed, {});
    for (const CrushCandidate& candidate : candidates) {
        const BodyId body = stage.bodies.idOf(candidate.body);
        if (candidate.by == noSlot || candidate.against == noSlot) {
            continue;
        }
        stage.crushed.push_back(body);
        if (std::find(before.begin(), before.end(), body) == before.end()) {
            stage.events.crushed.push_back(
                {iteration, body, stage.bodies.idOf(candidate.by), stage.bodies.idOf(candidate.against)});
        }
    }
}

} // namespace

bool mayCrush(const CrushStage& stage) {
    const std::vector<Slot>& moving = stage.bodies.moving;
    const std::vector<std::uint8_t>& pushed = stage.solver.pushedByKinematic;
    const auto isFixedBody = [&](Slot slot) { return isFixed(stage.bodies, slot); };
    const auto isPushed = [&](Slot slot) { return slot < pushed.size() && pushed[slot] != 0; };
    const bool anyFixed = hasStatics(stage.broadPhase) || !stage.sleep.sleepers.empty() ||
                          std::any_of(moving.begin(), moving.end(), isFixedBody);
    return anyFixed && std::any_of(moving.begin(), moving.end(), isPushed);
}

void findDisplaced(Bodies& bodies, StepFlags& flags, const SolverScratch& solver, PairSearch& search) {
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
    std::vector<CrushCandidate> candidates;
    stopDisplaced(stage.bodies, stage.contacts, stage.solver, candidates);
    std::vector<Slot> limited;
    bool changed = true;
    for (int round = 0; round < crushRounds && changed; ++round) {
        changed = removeExcess(stage.bodies, stage.constraints, stage.solver, limited);
    }
    if (!limited.empty()) {
        stopWedged(stage, limited);
    }
    for (const Slot slot : limited) {
        candidates.push_back({slot});
    }
    if (!candidates.empty() || !stage.crushed.empty()) {
        reportCrushed(stage, candidates, iteration);
    }
}

} // namespace spacetow
