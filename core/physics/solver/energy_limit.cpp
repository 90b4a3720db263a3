#include "core/physics/solver/energy_limit.h"

#include "core/physics/contacts/contact_rules.h"
#include "core/physics/solver/islands.h"
#include "core/physics/solver/solve_on.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace spacetow {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

// Deeper than this, bodies are pushed apart whatever it costs, m.
constexpr double deepOverlap = 8 * linearSlop;
constexpr int extraRounds = 2;
constexpr int extraPasses = 2;
constexpr int softerBounces = 8; // each time half as fast
// What may be gained, of the energy that the impulses of an iteration move: beyond rounding, below notice.
constexpr double tolerance = 1e-9;

/// A velocity as numbers to reckon with all at once.
struct WideVelocity {
    Wide value;
    explicit WideVelocity(const Pace& pace) { std::memcpy(&value, &pace, sizeof value); }
};

double sum(const Wide& w) {
    return w[0] + w[1] + w[2];
}

EnergyBalance& balanceOf(WorldData& data, Slot slot) {
    return data.islands.balances[data.islands.roots[slot]];
}

/// With a share x of its impulses an iteration changes a body's energy by a·x²/2 + b·x + c: a velocity v after it costs
/// m·(v²/2 − d·v), where d is what the forces added to the velocity v₀ that it began with; their work on the way v·dt
/// is in it.
void measureBody(const WorldData& data, Slot slot, EnergyChange& change) {
    const Wide planned = WideVelocity(data.batches.planned[slot]).value;
    const Wide push = WideVelocity(data.batches.paces[slot]).value - planned;
    if (!isPush({push[0], push[1]}, push[2] * data.steps[slot].outerRadius)) {
        return;
    }
    const Wide start = WideVelocity(data.batches.starts[slot]).value;
    const Wide forced = planned - start;
    const Wide inertia = WideVelocity(data.islands.inertias[slot]).value;
    change.a += inertia * push * push;
    change.b += inertia * push * start;
    change.c -= 0.5 * inertia * forced * forced;
}

/// The sum of an island stays in registers while the bodies are its: through memory each would wait for the last.
void measureBodies(WorldData& data) {
    std::vector<EnergyChange>& changes = data.islands.changes;
    EnergyChange sum;
    Slot root = noSlot;
    for (const Slot slot : data.moving) {
        if (data.islands.roots[slot] != root) {
            if (root != noSlot) {
                changes[root] = sum;
            }
            root = data.islands.roots[slot];
            sum = changes[root];
        }
        if (data.islands.driven[root] == 0) { // what is driven may gain what it likes
            measureBody(data, slot, sum);
        }
    }
    if (root != noSlot) {
        changes[root] = sum;
    }
}

enum class Gain : std::uint8_t { None, Little, Much };

/// Near rest energy comes and goes in small amounts.
Gain gainOf(const EnergyBalance& e) {
    const double gain = e.gain();
    return gain <= tolerance * e.a ? Gain::None : gain <= 0.01 * e.a ? Gain::Little : Gain::Much;
}

/// Returns the worst of all islands.
Gain measureIslands(WorldData& data) {
    for (const Slot root : data.islands.all) {
        data.islands.changes[root] = {};
    }
    measureBodies(data);
    Gain worst = Gain::None;
    for (const Slot root : data.islands.all) {
        const EnergyChange& change = data.islands.changes[root];
        EnergyBalance& balance = data.islands.balances[root];
        balance = {sum(change.a), sum(change.b), sum(change.c), 0};
        if (data.islands.driven[root] != 0) {
            balance = {0, 0, -infinite, 0};
        }
        worst = std::max(worst, gainOf(balance));
    }
    return worst;
}

using Question = bool (*)(const EnergyBalance&);

bool gainsMuch(const EnergyBalance& e) {
    return gainOf(e) == Gain::Much;
}
bool pushesTooMuch(const EnergyBalance& e) {
    return e.pushes > 0 && e.pushes > -e.gain();
}

/// Solves on, for these islands alone.
void solveOnWhere(WorldData& data, Question which) {
    data.islands.unsettled.assign(data.motions.size(), 0);
    for (const Slot root : data.islands.all) {
        data.islands.unsettled[root] = which(data.islands.balances[root]) ? 1 : 0;
    }
    solveOn(data, extraPasses);
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

template <class Batch>
bool soften(WorldData& data, Batches<Batch>& batches) {
    bool any = false;
    forLanes(batches, &BatchNotes::occupied, [&](Lane at) {
        Batch& batch = batches[at.batch];
        if (gainsMuch(data.islands.balances[rootAt(data, batch, at.lane)])) {
            soften(batch, at.lane, any);
        }
    });
    return any;
}

/// Restitution and friction together may add energy: what gains it bounces half as fast. Whether anything does.
bool softenBounces(WorldData& data) {
    const bool round = soften(data, data.batches.round);
    return soften(data, data.batches.general) || round;
}

/// The greatest share of the impulses with which the energy does not rise.
double shareOf(const EnergyBalance& e) {
    return std::clamp((-e.b + std::sqrt(std::max(e.b * e.b - 2 * e.a * e.c, 0.0))) / e.a, 0.0, 1.0);
}

void scaleImpulses(WorldData& data) {
    for (const Slot slot : data.moving) {
        const EnergyBalance& balance = balanceOf(data, slot);
        if (gainOf(balance) != Gain::None) {
            const double share = shareOf(balance);
            const Pace& without = data.batches.planned[slot];
            Pace& pace = data.batches.paces[slot];
            pace.x = without.x + share * (pace.x - without.x);
            pace.y = without.y + share * (pace.y - without.y);
            pace.turn = without.turn + share * (pace.turn - without.turn);
        }
    }
}

bool isDeep(const RoundBatch& batch, std::uint32_t lane) {
    return batch.separation[lane] < -deepOverlap;
}

bool isDeep(const ConstraintBatch& batch, std::uint32_t lane) {
    return batch.separation1[lane] < -deepOverlap || batch.separation2[lane] < -deepOverlap;
}

/// Lets the islands of deep contacts pay whatever the pushes cost.
template <class Batch>
void allowDeep(WorldData& data, const Batches<Batch>& batches) {
    forLanes(batches, &BatchNotes::occupied, [&](Lane at) {
        if (isDeep(batches[at.batch], at.lane)) {
            EnergyBalance& balance = data.islands.balances[rootAt(data, batches[at.batch], at.lane)];
            balance.c = pushesTooMuch(balance) ? -infinite : balance.c;
        }
    });
}

/// What the pushes cost: the work against the forces that act on the bodies.
void measurePushes(WorldData& data, double dt) {
    for (const Slot slot : data.moving) {
        const Pace& push = data.batches.pushes[slot];
        if (push.x == 0 && push.y == 0 && push.turn == 0) {
            continue;
        }
        const Pace& start = data.batches.starts[slot];
        const Pace& planned = data.batches.planned[slot];
        const double along = push.x * (start.x - planned.x) + push.y * (start.y - planned.y);
        balanceOf(data, slot).pushes += data.islands.inertias[slot].x * along / dt;
        data.steps[slot].push = {push.x, push.y};
        data.steps[slot].pushTurn = push.turn;
    }
}

} // namespace

bool limitGain(WorldData& data) {
    data.islands.changes.resize(data.motions.size());
    data.islands.balances.resize(data.motions.size());
    Gain gain = measureIslands(data);
    bool changed = false;
    for (int round = 0; round < extraRounds && gain == Gain::Much; ++round) {
        solveOnWhere(data, gainsMuch);
        gain = measureIslands(data);
        changed = true;
    }
    for (int round = 0; round < softerBounces && gain == Gain::Much && softenBounces(data); ++round) {
        solveOnWhere(data, gainsMuch);
        gain = measureIslands(data);
        changed = true;
    }
    if (gain != Gain::None) {
        scaleImpulses(data);
        measureIslands(data);
        changed = true;
    }
    return changed;
}

void takePushes(WorldData& data, double dt) {
    measurePushes(data, dt);
    const std::vector<EnergyBalance>& balances = data.islands.balances;
    if (std::none_of(data.islands.all.begin(), data.islands.all.end(),
                     [&](Slot root) { return pushesTooMuch(balances[root]); })) {
        return;
    }
    allowDeep(data, data.batches.round);
    allowDeep(data, data.batches.general);
    for (const Slot slot : data.moving) {
        const EnergyBalance& balance = balanceOf(data, slot);
        if (pushesTooMuch(balance)) {
            const double share = std::max(-balance.gain(), 0.0) / balance.pushes;
            data.steps[slot].push *= share;
            data.steps[slot].pushTurn *= share;
        }
    }
}

} // namespace spacetow
