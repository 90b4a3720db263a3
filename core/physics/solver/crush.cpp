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
void seeBoth(const WorldData& data, const Sight& ofA, double leverB, const Visit& visit) {
    if (data.motions[ofA.body].isMovable()) {
        visit(ofA);
    }
    if (data.motions[ofA.other].isMovable()) {
        visit(Sight{ofA.other, ofA.body, -ofA.towards, -leverB, ofA.separation});
    }
}

/// Visits all points of contact of driven bodies.
template <class Visit>
void forSights(const WorldData& data, const Visit& visit) {
    const std::vector<std::uint8_t>& driven = data.scratch.solver.driven;
    const auto isDriven = [&](const auto& c) { return (driven[c.a] | driven[c.b]) != 0; };
    for (const CircleContact& c : data.circleContacts) {
        if (isDriven(c)) {
            const CircleBatch& batch = data.batches.circles[c.lane.batch];
            const std::uint32_t i = c.lane.lane;
            seeBoth(data, {c.a, c.b, {batch.normalX[i], batch.normalY[i]}, 0, batch.separation[i]}, 0, visit);
        }
    }
    for (const GeneralContact& c : data.generalContacts) {
        if (isDriven(c)) {
            const ConstraintBatch& batch = data.batches.general[c.lane.batch];
            const std::uint32_t i = c.lane.lane;
            const Vec2 normal(batch.normalX[i], batch.normalY[i]);
            seeBoth(data, {c.a, c.b, normal, batch.leverA1[i], batch.separation1[i]}, batch.leverB1[i], visit);
            seeBoth(data, {c.a, c.b, normal, batch.leverA2[i], batch.separation2[i]}, batch.leverB2[i], visit);
        }
    }
}

bool stands(const WorldData& data, Slot slot) {
    return !data.motions[slot].isMovable() && !data.motions[slot].isMoving();
}

/// How far the body comes to the other in this iteration, m.
double approach(const WorldData& data, const Sight& at) {
    const BodyStep& s = data.steps[at.body];
    return at.towards.dot(s.fraction * s.deltaPosition + s.correction) +
           at.lever * (s.fraction * s.deltaAngle + s.angleCorrection);
}

/// How much further the body would go into what stands still than it may, m.
double excess(const WorldData& data, const Sight& at) {
    return approach(data, at) - std::max(at.separation + linearSlop, 0.0);
}

void stopClosing(WorldData& data, const Sight& at) {
    BodyMotion& m = data.motions[at.body];
    const double speed = at.towards.dot(m.velocity) + at.lever * m.angularVelocity;
    if (speed > 0) {
        m.velocity -= speed * at.towards;
    }
}

/// True when the way of a body had to be changed; these are listed.
bool keepOutOnce(WorldData& data, std::vector<Slot>& kept) {
    bool changed = false;
    forSights(data, [&](const Sight& at) {
        const double tooFar = stands(data, at.other) ? excess(data, at) : 0;
        if (tooFar > 0) {
            BodyStep& s = data.steps[at.body];
            if (tooFar > linearSlop) {
                s.deltaAngle = s.angleCorrection = 0;
            }
            s.correction -= std::max(excess(data, at), 0.0) * at.towards;
            stopClosing(data, at);
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

Transform poseAfterStop(const WorldData& data, Slot slot) {
    const BodyMotion& m = data.motions[slot];
    const BodyStep& s = data.steps[slot];
    return {m.center + s.fraction * s.deltaPosition, turned(m.rotation, s.fraction * s.deltaAngle)};
}

bool isPushed(const WorldData& data, Slot slot) {
    const BodyStep& s = data.steps[slot];
    return data.scratch.solver.driven[slot] != 0 && (s.correction != Vec2(0, 0) || s.angleCorrection != 0);
}

/// Visits the pairs of driven bodies with static ones that they have no contact with.
template <class Visit>
void forUnmet(WorldData& data, const Visit& visit) {
    for (std::uint32_t i = 0; i < data.table.size(); ++i) {
        const Pair& pair = data.table.pairs[i];
        if (pair.staticB && pair.kind != PairKind::Sensor && !data.table.flags[i].inSolver &&
            isPushed(data, pair.bodyA)) {
            visit(pair);
        }
    }
}

double freeShare(const Pair& pair, const Motion& way) {
    return timeOfImpact(*pair.shapeA, way, *pair.shapeB, Motion{}, stopGap).value_or(1);
}

/// What is between two that do not give way.
struct Squeeze {
    Slot body;
    Slot against = noSlot;
    Slot by = noSlot;
    double depth = 0; // m, of the overlap at the end of the iteration
};

/// Pushes and what carries a body along do not take it through what it has not yet met.
void stopPushed(WorldData& data, std::vector<Squeeze>& stopped) {
    forUnmet(data, [&](const Pair& pair) {
        BodyStep& s = data.steps[pair.bodyA];
        const Transform start = poseAfterStop(data, pair.bodyA);
        const double share = freeShare(pair, {.start = start, .translation = s.correction, .turn = s.angleCorrection});
        s.correction *= share;
        s.angleCorrection *= share;
        if (share < 1) {
            stopped.push_back({pair.bodyA, pair.bodyB});
        }
    });
}

/// What is kept out of one thing and would go into another goes nowhere.
void stopWedged(WorldData& data, const std::vector<Slot>& kept) {
    forSights(data, [&](const Sight& at) {
        if (stands(data, at.other) && excess(data, at) > linearSlop) {
            halt(data.steps[at.body]);
        }
    });
    forUnmet(data, [&](const Pair& pair) {
        BodyStep& s = data.steps[pair.bodyA];
        const Motion way{.start = data.pose(pair.bodyA),
                         .translation = s.fraction * s.deltaPosition + s.correction,
                         .turn = s.fraction * s.deltaAngle + s.angleCorrection};
        if (std::find(kept.begin(), kept.end(), pair.bodyA) != kept.end() && freeShare(pair, way) < 1) {
            halt(s);
        }
    });
}

void noteSqueeze(const WorldData& data, const Sight& at, Squeeze& squeeze) {
    if (stands(data, at.other)) {
        squeeze.against = at.separation <= linearSlop + approach(data, at) ? at.other : squeeze.against;
        return;
    }
    const BodyStep& other = data.steps[at.other];
    const Vec2 wayOfOther = other.fraction * other.deltaPosition + other.correction;
    const double depth = approach(data, at) - at.towards.dot(wayOfOther) - at.separation;
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
void reportCrushed(WorldData& data, std::vector<Squeeze>& squeezes, int iteration) {
    for (const BodyId body : data.crushed) {
        squeezes.push_back({body.index});
    }
    sortOut(squeezes);
    for (Squeeze& squeeze : squeezes) {
        squeeze.depth = std::max(crushShare * data.steps[squeeze.body].innerRadius, crushDepth);
    }
    forSights(data, [&](const Sight& at) {
        const auto found = std::lower_bound(squeezes.begin(), squeezes.end(), at.body,
                                            [](const Squeeze& squeeze, Slot body) { return squeeze.body < body; });
        if (found != squeezes.end() && found->body == at.body) {
            noteSqueeze(data, at, *found);
        }
    });
    const std::vector<BodyId> before = std::exchange(data.crushed, {});
    for (const Squeeze& squeeze : squeezes) {
        const BodyId body = data.idOf(squeeze.body);
        if (squeeze.by == noSlot || squeeze.against == noSlot) {
            continue;
        }
        data.crushed.push_back(body);
        if (std::find(before.begin(), before.end(), body) == before.end()) {
            data.events.crushed.push_back({iteration, body, data.idOf(squeeze.by), data.idOf(squeeze.against)});
        }
    }
}

bool anyDriven(const WorldData& data) {
    const std::vector<std::uint8_t>& driven = data.scratch.solver.driven;
    return std::any_of(data.moving.begin(), data.moving.end(),
                       [&driven](Slot slot) { return slot < driven.size() && driven[slot] != 0; });
}

} // namespace

void measureCorrections(WorldData& data) {
    data.flags.anyMovedProxy = false;
    if (!anyDriven(data)) {
        return;
    }
    data.scratch.search.movedBodies.clear();
    for (const Slot slot : data.moving) {
        BodyStep& s = data.steps[slot];
        const Vec2 end = poseAfterStop(data, slot).position + s.correction;
        s.movedProxy = isPushed(data, slot) &&
                       (!s.fat.centers.contains(end) ||
                        std::abs(s.fraction * s.deltaAngle) + std::abs(s.angleCorrection) > s.fat.angleLeft);
        if (s.movedProxy) {
            data.scratch.search.movedBodies.push_back(slot);
        }
    }
    data.flags.anyMovedProxy = !data.scratch.search.movedBodies.empty();
}

void keepOutOfStatics(WorldData& data, int iteration) {
    if (!anyDriven(data)) {
        data.crushed.clear();
        return;
    }
    std::vector<Squeeze> squeezes;
    stopPushed(data, squeezes);
    std::vector<Slot> kept;
    bool changed = true;
    for (int round = 0; round < roundsOfKeeping && changed; ++round) {
        changed = keepOutOnce(data, kept);
    }
    if (!kept.empty()) {
        stopWedged(data, kept);
    }
    for (const Slot slot : kept) {
        squeezes.push_back({slot});
    }
    if (!squeezes.empty() || !data.crushed.empty()) {
        reportCrushed(data, squeezes, iteration);
    }
}

} // namespace spacetow
