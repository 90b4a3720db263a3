#include "core/physics/energy_limit.h"

#include "core/physics/contact_rules.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace spacetow {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

// Deeper than this, bodies are pushed apart whatever it costs, m.
constexpr double deepOverlap = 8 * linearSlop;
constexpr int extraPasses = 10;
constexpr int softerBounces = 8; // each time half as fast
constexpr int passesAfterSoftening = 4;
// What may be gained, of the energy that the impulses of an iteration move: beyond rounding, below notice.
constexpr double tolerance = 1e-9;

bool isMovable(const BodyMotion& m) {
    return m.inverseMass > 0 || m.inverseInertia > 0;
}

/// What the forces added to the velocity in the part of the iteration that is carried out.
Vec2 forcedOf(const BodyMotion& m, const BodyStep& s) {
    return s.accounted * (m.velocity - s.startVelocity);
}
double forcedTurnOf(const BodyMotion& m, const BodyStep& s) {
    return s.accounted * (m.angularVelocity - s.startAngularVelocity);
}

/// With a share x of its impulses an iteration changes a body's energy by a·x²/2 + b·x + c: a velocity v after it costs
/// m·(v²/2 − d·v), where d is what the forces added to the velocity v₀ that it began with; their work on the way v·dt
/// is in it.
EnergyChange changeOf(const WorldData& data, Slot slot) {
    const BodyMotion& m = data.motions[slot];
    const BodyStep& s = data.steps[slot];
    const Pace& pace = data.batches.paces[slot];
    const Vec2 forced = forcedOf(m, s);
    const Vec2 push = Vec2(pace.x, pace.y) - s.startVelocity - forced;
    const double forcedTurn = forcedTurnOf(m, s);
    const double turn = pace.turn - s.startAngularVelocity - forcedTurn;
    EnergyChange e;
    if (!isPush(push, turn * s.outerRadius)) {
        return e;
    }
    if (m.inverseMass > 0) {
        const double mass = 1 / m.inverseMass;
        e.a = mass * push.squaredNorm();
        e.b = mass * push.dot(s.startVelocity);
        e.c = -0.5 * mass * forced.squaredNorm();
        e.kinetic = mass * push.dot(s.startVelocity + forced + 0.5 * push);
    }
    if (m.inverseInertia > 0) {
        const double inertia = 1 / m.inverseInertia;
        e.a += inertia * turn * turn;
        e.b += inertia * turn * s.startAngularVelocity;
        e.c -= 0.5 * inertia * forcedTurn * forcedTurn;
        e.kinetic += inertia * turn * (s.startAngularVelocity + forcedTurn + 0.5 * turn);
    }
    return e;
}

EnergyChange& changeOfIsland(WorldData& data, Slot slot) {
    return data.islands.changes[data.islands.roots[slot]];
}

void measureIslands(WorldData& data) {
    for (const Slot slot : data.moving) {
        data.islands.changes[slot] = {};
    }
    for (const Slot slot : data.moving) {
        changeOfIsland(data, slot) += changeOf(data, slot);
    }
    for (const Islands::Driver& driver : data.islands.drivers) {
        const BodyMotion& m = data.motions[driver.slot];
        if (m.angularVelocity != 0 || m.velocity != Vec2(0, 0)) {
            data.islands.changes[driver.pushed] = {0, 0, -infinite, 0};
        }
    }
}

// Near rest energy comes and goes in small amounts.
bool gainsMuch(const EnergyChange& e) {
    return e.gain() > 0.01 * e.a;
}
bool gains(const EnergyChange& e) {
    return e.gain() > tolerance * e.a;
}

template <class Predicate>
bool anyIsland(const WorldData& data, const Predicate& predicate) {
    return std::any_of(data.moving.begin(), data.moving.end(),
                       [&](Slot slot) { return predicate(data.islands.changes[slot]); });
}

Slot moverOf(const WorldData& data, Slot a, Slot b) {
    return isMovable(data.motions[a]) ? a : b;
}

/// Visits the lanes of the islands' contacts, in the order of the contacts.
template <class Visit>
void forLanesOf(WorldData& data, bool (*which)(const EnergyChange&), const Visit& visit) {
    for (const RoundContact& c : data.roundContacts) {
        if (which(changeOfIsland(data, moverOf(data, c.a, c.b)))) {
            visit(data.batches.round, data.islands.batches.round, c);
        }
    }
    for (const Constraint& c : data.constraints) {
        if (which(changeOfIsland(data, moverOf(data, c.a, c.b)))) {
            visit(data.batches.general, data.islands.batches.general, c);
        }
    }
}

/// Solves on, for these islands alone.
void solveOn(WorldData& data, bool (*which)(const EnergyChange&), int passes) {
    ContactBatches& part = data.islands.batches;
    part.round.reset(data.motions.size());
    part.general.reset(data.motions.size());
    data.islands.lanes.clear();
    forLanesOf(data, which, [&](auto& from, auto& to, const auto& c) {
        const Lane lane = to.open(c.a, isMovable(data.motions[c.a]), c.b, isMovable(data.motions[c.b]));
        copyLane(from[c.lane.batch], c.lane.lane, to[lane.batch], lane.lane);
        data.islands.lanes.push_back(lane);
    });
    std::swap(part.paces, data.batches.paces);
    for (int pass = 0; pass < passes; ++pass) {
        solvePass(part);
    }
    std::swap(part.paces, data.batches.paces);
    std::size_t next = 0;
    forLanesOf(data, which, [&](auto& to, auto& from, const auto& c) {
        const Lane lane = data.islands.lanes[next++];
        copyLane(from[lane.batch], lane.lane, to[c.lane.batch], c.lane.lane);
    });
}

void soften(RoundBatch& batch, std::uint32_t lane, bool& any) {
    if (batch.target[lane] > 0) {
        batch.target[lane] *= 0.5;
        any = true;
    }
}

void soften(ConstraintBatch& batch, std::uint32_t lane, bool& any) {
    for (Wide* target : {&batch.target1, &batch.target2}) {
        if ((*target)[lane] > 0) {
            (*target)[lane] *= 0.5;
            any = true;
        }
    }
}

/// Restitution and friction together may add energy: what gains it bounces half as fast. Whether anything does.
bool softenBounces(WorldData& data) {
    bool any = false;
    forLanesOf(data, gainsMuch,
               [&](auto& batches, auto&, const auto& c) { soften(batches[c.lane.batch], c.lane.lane, any); });
    return any;
}

/// The greatest share of the impulses with which the energy does not rise.
double shareOf(const EnergyChange& e) {
    return std::clamp((-e.b + std::sqrt(std::max(e.b * e.b - 2 * e.a * e.c, 0.0))) / e.a, 0.0, 1.0);
}

void scaleImpulses(WorldData& data) {
    for (const Slot slot : data.moving) {
        const EnergyChange& change = changeOfIsland(data, slot);
        if (gains(change)) {
            const double share = shareOf(change);
            const BodyMotion& m = data.motions[slot];
            const BodyStep& s = data.steps[slot];
            const Vec2 without = s.startVelocity + forcedOf(m, s);
            const double turnWithout = s.startAngularVelocity + forcedTurnOf(m, s);
            Pace& pace = data.batches.paces[slot];
            pace.x = without.x() + share * (pace.x - without.x());
            pace.y = without.y() + share * (pace.y - without.y());
            pace.turn = turnWithout + share * (pace.turn - turnWithout);
        }
    }
}

/// J, of a push out of overlaps, against the forces that act on the body.
double workOf(const WorldData& data, Slot slot, double dt) {
    const BodyMotion& m = data.motions[slot];
    const BodyStep& s = data.steps[slot];
    return m.inverseMass > 0 ? (s.startVelocity - m.velocity).dot(s.push) / (m.inverseMass * dt) : 0;
}

bool isDeep(const RoundContact& c) {
    return c.separation < -deepOverlap;
}

bool isDeep(const Constraint& c) {
    return c.points[0].separation < -deepOverlap || (c.count == 2 && c.points[1].separation < -deepOverlap);
}

/// What pushes may cost, in place of what was gained.
bool exceeds(const EnergyChange& e) {
    return e.b > 0 && e.b > -e.c;
}

/// Whenever there is something to solve again, it is not to allocate.
void reserveRoom(WorldData& data) {
    Islands& islands = data.islands;
    islands.changes.resize(data.motions.size());
    islands.lanes.reserve(data.roundContacts.capacity() + data.constraints.capacity());
    islands.batches.round.reserve(data.batches.round);
    islands.batches.general.reserve(data.batches.general);
}

} // namespace

bool limitGain(WorldData& data) {
    reserveRoom(data);
    measureIslands(data);
    bool changed = false;
    for (int pass = 0; pass < extraPasses && anyIsland(data, gainsMuch); ++pass) {
        solveOn(data, gainsMuch, 1);
        measureIslands(data);
        changed = true;
    }
    for (int round = 0; round < softerBounces && anyIsland(data, gainsMuch) && softenBounces(data); ++round) {
        solveOn(data, gainsMuch, passesAfterSoftening);
        measureIslands(data);
        changed = true;
    }
    if (anyIsland(data, gains)) {
        scaleImpulses(data);
        changed = true;
    }
    return changed;
}

void limitPushes(WorldData& data, double dt) {
    if (data.moving.empty()) {
        return;
    }
    measureIslands(data);
    for (const Slot slot : data.moving) {
        EnergyChange& change = data.islands.changes[slot];
        change.c = std::min(change.gain(), 0.0); // the reverse of what is there to spend
        change.b = 0;
    }
    for (const Slot slot : data.moving) {
        changeOfIsland(data, slot).b += workOf(data, slot, dt);
    }
    if (!anyIsland(data, exceeds)) {
        return;
    }
    forLanesOf(data, exceeds, [&](auto&, auto&, const auto& c) {
        if (isDeep(c)) {
            changeOfIsland(data, moverOf(data, c.a, c.b)).c = -infinite;
        }
    });
    for (const Slot slot : data.moving) {
        const EnergyChange& change = changeOfIsland(data, slot);
        if (exceeds(change)) {
            const double share = -change.c / change.b;
            data.steps[slot].push *= share;
            data.steps[slot].pushTurn *= share;
        }
    }
}

} // namespace spacetow
