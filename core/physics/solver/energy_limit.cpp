#include "core/physics/solver/energy_limit.h"

#include "core/physics/contacts/contact_rules.h"
#include "core/physics/solver/contact_graph.h"
#include "core/physics/solver/solve_unconverged.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace spacetow {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

// Overlaps deeper than this are corrected even if the correction adds energy, m.
constexpr double deepOverlap = 8 * linearSlop;
// More iterations before restitution is lowered: components that do not converge after four gain from restitution.
constexpr int extraRounds = 2;
constexpr int extraPasses = 2;
// How often restitution is halved at most.
constexpr int mostHalvings = 8;
// Relative to the energy that the impulses of an iteration move (a of EnergyBalance): a gain up to `tolerance` is
// rounding, a gain up to `littleGain` is what comes and goes near rest, for which scaling the impulses will do.
constexpr double tolerance = 1e-9;
constexpr double littleGain = 0.01;

/// A velocity as one SIMD vector: x, y, rotation.
struct WideVelocity {
    Wide value;
    explicit WideVelocity(const BodyVelocity& velocity) { std::memcpy(&value, &velocity, sizeof value); }
};

double sum(const Wide& w) {
    return w[0] + w[1] + w[2];
}

EnergyBalance& balanceOf(const ContactGraph& graph, SolverScratch& solver, Slot slot) {
    return solver.balances[graph.roots[slot]];
}

/// Adds a body to the coefficients of its component. If its impulses are scaled by x, the iteration changes the energy
/// of the body by a·x²/2 + b·x + c: kinetic energy m·v²/2 of the final velocity v, less the work m·d·v of the forces
/// along the motion v·dt, where d is the velocity that the forces added to the velocity v₀ at the beginning.
void measureBody(const SolverStage& stage, Slot slot, EnergyChange& change) {
    const Wide planned = WideVelocity(stage.solver.plannedVelocities[slot]).value;
    const Wide push = WideVelocity(stage.solver.velocities[slot]).value - planned;
    if (!isPush({push[0], push[1]}, push[2] * stage.bodies.steps[slot].outerRadius)) {
        return;
    }
    const Wide start = WideVelocity(stage.solver.startVelocities[slot]).value;
    const Wide forced = planned - start;
    const Wide inertia = WideVelocity(stage.graph.inertias[slot]).value;
    change.a += inertia * push * push;
    change.b += inertia * push * start;
    change.c -= 0.5 * inertia * forced * forced;
}

/// Neighbours in `moving` are mostly of one component: its sum stays in registers, else each addition would wait for
/// the store of the last one.
void measureBodies(const SolverStage& stage) {
    std::vector<EnergyChange>& changes = stage.solver.changes;
    EnergyChange sum;
    Slot root = noSlot;
    for (const Slot slot : stage.bodies.moving) {
        if (stage.graph.roots[slot] != root) {
            if (root != noSlot) {
                changes[root] = sum;
            }
            root = stage.graph.roots[slot];
            sum = changes[root];
        }
        if (stage.solver.pushedByKinematic[root] == 0) { // a kinematic body may do any work
            measureBody(stage, slot, sum);
        }
    }
    if (root != noSlot) {
        changes[root] = sum;
    }
}

enum class Gain : std::uint8_t { None, Little, Much };

/// Rates the gain of a component.
Gain gainOf(const EnergyBalance& e) {
    const double gain = e.gain();
    return gain <= tolerance * e.a ? Gain::None : gain <= littleGain * e.a ? Gain::Little : Gain::Much;
}

/// Computes the balances of all components. Returns the worst gain.
Gain measureComponents(const SolverStage& stage) {
    for (const Slot root : stage.graph.componentRoots) {
        stage.solver.changes[root] = {};
    }
    measureBodies(stage);
    Gain worst = Gain::None;
    for (const Slot root : stage.graph.componentRoots) {
        const EnergyChange& change = stage.solver.changes[root];
        EnergyBalance& balance = stage.solver.balances[root];
        balance = {sum(change.a), sum(change.b), sum(change.c), 0};
        if (stage.solver.pushedByKinematic[root] != 0) {
            balance = {0, 0, -infinite, 0};
        }
        worst = std::max(worst, gainOf(balance));
    }
    return worst;
}

using Predicate = bool (*)(const EnergyBalance&);

bool gainsMuch(const EnergyBalance& e) {
    return gainOf(e) == Gain::Much;
}
bool costsTooMuch(const EnergyBalance& e) {
    return e.corrections > 0 && e.corrections > -e.gain();
}

/// Runs more iterations over the components for which the predicate holds.
void solveComponentsWhere(const SolverStage& stage, Predicate which) {
    clearUnconverged(stage.bodies, stage.graph, stage.solver);
    for (const Slot root : stage.graph.componentRoots) {
        stage.solver.unconverged[root] = which(stage.solver.balances[root]) ? 1 : 0;
    }
    solveUnconverged(stage, extraPasses);
}

void halveTargets(CircleBatch& batch, std::uint32_t lane, bool& any) {
    if (batch.target[lane] > 0) {
        batch.target[lane] *= 0.5;
        any = true;
    }
}

void halveTargets(ConstraintBatch& batch, std::uint32_t lane, bool& any) {
    for (Wide* target : {&batch.target1, &batch.target2}) {
        if ((*target)[lane] > 0) {
            (*target)[lane] *= 0.5;
            any = true;
        }
    }
}

template <class Batch>
bool halveTargets(const ContactGraph& graph, SolverScratch& solver, Batches<Batch>& batches) {
    bool any = false;
    forLanes(batches, &BatchFlags::occupied, [&](Lane at) {
        Batch& batch = batches[at.batch];
        if (gainsMuch(solver.balances[rootAt(graph, batch, at.lane)])) {
            halveTargets(batch, at.lane, any);
        }
    });
    return any;
}

/// Restitution and friction together may add energy: halves the target velocities in components that gain much. Returns
/// whether there are any.
bool lowerRestitution(Constraints& constraints, const ContactGraph& graph, SolverScratch& solver) {
    const bool circles = halveTargets(graph, solver, constraints.batches.circles);
    return halveTargets(graph, solver, constraints.batches.general) || circles;
}

/// The largest factor of the impulses, 0 … 1, with which the energy does not rise.
double shareOf(const EnergyBalance& e) {
    return std::clamp((-e.b + std::sqrt(std::max(e.b * e.b - 2 * e.a * e.c, 0.0))) / e.a, 0.0, 1.0);
}

void scaleImpulses(const Bodies& bodies, const ContactGraph& graph, SolverScratch& solver) {
    for (const Slot slot : bodies.moving) {
        const EnergyBalance& balance = balanceOf(graph, solver, slot);
        if (gainOf(balance) != Gain::None) {
            const double share = shareOf(balance);
            const BodyVelocity& without = solver.plannedVelocities[slot];
            BodyVelocity& velocity = solver.velocities[slot];
            velocity.x = without.x + share * (velocity.x - without.x);
            velocity.y = without.y + share * (velocity.y - without.y);
            velocity.angular = without.angular + share * (velocity.angular - without.angular);
        }
    }
}

bool isDeep(const CircleBatch& batch, std::uint32_t lane) {
    return batch.separation[lane] < -deepOverlap;
}

bool isDeep(const ConstraintBatch& batch, std::uint32_t lane) {
    return batch.separation1[lane] < -deepOverlap || batch.separation2[lane] < -deepOverlap;
}

/// Lifts the limit for components with deep overlaps.
template <class Batch>
void allowDeep(const ContactGraph& graph, SolverScratch& solver, const Batches<Batch>& batches) {
    forLanes(batches, &BatchFlags::occupied, [&](Lane at) {
        if (isDeep(batches[at.batch], at.lane)) {
            EnergyBalance& balance = solver.balances[rootAt(graph, batches[at.batch], at.lane)];
            balance.c = costsTooMuch(balance) ? -infinite : balance.c;
        }
    });
}

/// Stores the corrections in the bodies, and adds their work against the forces to the balances.
void gatherCorrections(const SolverStage& stage, double dt) {
    for (const Slot slot : stage.bodies.moving) {
        const BodyVelocity& push = stage.solver.corrections[slot];
        if (push.x == 0 && push.y == 0 && push.angular == 0) {
            continue;
        }
        const BodyVelocity& start = stage.solver.startVelocities[slot];
        const BodyVelocity& planned = stage.solver.plannedVelocities[slot];
        const double along = push.x * (start.x - planned.x) + push.y * (start.y - planned.y);
        balanceOf(stage.graph, stage.solver, slot).corrections += stage.graph.inertias[slot].x * along / dt;
        stage.bodies.steps[slot].correction = {push.x, push.y};
        stage.bodies.steps[slot].angleCorrection = push.angular;
    }
}

} // namespace

bool limitEnergyGain(const SolverStage& stage) {
    stage.solver.changes.resize(stage.bodies.motions.size());
    stage.solver.balances.resize(stage.bodies.motions.size());
    Gain gain = measureComponents(stage);
    bool changed = false;
    for (int round = 0; round < extraRounds && gain == Gain::Much; ++round) {
        solveComponentsWhere(stage, gainsMuch);
        gain = measureComponents(stage);
        changed = true;
    }
    for (int round = 0;
         round < mostHalvings && gain == Gain::Much && lowerRestitution(stage.constraints, stage.graph, stage.solver);
         ++round) {
        solveComponentsWhere(stage, gainsMuch);
        gain = measureComponents(stage);
        changed = true;
    }
    if (gain != Gain::None) {
        scaleImpulses(stage.bodies, stage.graph, stage.solver);
        measureComponents(stage);
        changed = true;
    }
    return changed;
}

void applyCorrections(const SolverStage& stage, double dt) {
    gatherCorrections(stage, dt);
    const std::vector<EnergyBalance>& balances = stage.solver.balances;
    if (std::none_of(stage.graph.componentRoots.begin(), stage.graph.componentRoots.end(),
                     [&](Slot root) { return costsTooMuch(balances[root]); })) {
        return;
    }
    allowDeep(stage.graph, stage.solver, stage.constraints.batches.circles);
    allowDeep(stage.graph, stage.solver, stage.constraints.batches.general);
    for (const Slot slot : stage.bodies.moving) {
        const EnergyBalance& balance = balanceOf(stage.graph, stage.solver, slot);
        if (costsTooMuch(balance)) {
            const double share = std::max(-balance.gain(), 0.0) / balance.corrections;
            stage.bodies.steps[slot].correction *= share;
            stage.bodies.steps[slot].angleCorrection *= share;
        }
    }
}

} // namespace spacetow
