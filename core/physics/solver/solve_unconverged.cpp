#include "core/physics/solver/solve_unconverged.h"

#include "core/physics/lanes/solver_kernels.h"
#include "core/physics/solver/contact_graph.h"

#include <algorithm>
#include <span>

namespace spacetow {

namespace {

constexpr int rounds = 10;
constexpr int passesInRound = 4;
// Once for each change of a mass: what rests on it is not to sink meanwhile.
constexpr int passesForNewWeight = 400;

bool isUnconverged(const SolverScratch& solver, Slot root) {
    return solver.unconverged[root] != 0;
}

template <class Batch>
void markClosing(const SolverStage& stage, const Batches<Batch>& batches) {
    forLanes(batches, &BatchFlags::closes, [&](Lane at) {
        const Slot root = rootAt(stage.graph, batches[at.batch], at.lane);
        stage.solver.unconverged[root] = stage.solver.pushedByKinematic[root] != 0 ? 0 : 1;
    });
}

/// Marks the components in which contacts close; whether there are any. Not those that a kinematic body may
/// push: they are not held back either, and in a turning drum something always closes.
bool markClosing(const SolverStage& stage) {
    clearUnconverged(stage.bodies, stage.graph, stage.sleep, stage.solver);
    markClosing(stage, stage.constraints.batches.circles);
    markClosing(stage, stage.constraints.batches.general);
    const std::vector<Slot>& roots = stage.graph.componentRoots;
    return std::any_of(roots.begin(), roots.end(), [&](Slot root) { return isUnconverged(stage.solver, root); });
}

template <class Batch>
void copyThere(const SolverStage& stage, const Batches<Batch>& from, Batches<Batch>& to) {
    forLanes(from, &BatchFlags::occupied, [&](Lane at) {
        const Batch& batch = from[at.batch];
        if (isUnconverged(stage.solver, rootAt(stage.graph, batch, at.lane))) {
            const Slot a = batch.a[at.lane];
            const Slot b = batch.b[at.lane];
            const Lane lane = to.open(a, stage.bodies.motions[a].isMovable(), b, stage.bodies.motions[b].isMovable());
            copyLane(batch, at.lane, to[lane.batch], lane.lane);
            stage.solver.lanes.push_back({at, lane});
        }
    });
}

template <class Batch>
void copyBack(const Batches<Batch>& from, Batches<Batch>& to, std::span<const SolverScratch::SameLane> lanes) {
    for (const SolverScratch::SameLane& lane : lanes) {
        copyLane(from[lane.there.batch], lane.there.lane, to[lane.here.batch], lane.here.lane);
    }
}

void relaxPasses(ContactBatches& batches, std::vector<BodyVelocity>& velocities, int passes) {
    for (int pass = 1; pass < passes; ++pass) {
        overrelaxPass(batches, velocities);
    }
    solvePass(batches, velocities);
}

} // namespace

void clearUnconverged(const Bodies& bodies, const ContactGraph& graph, const Sleep& sleep, SolverScratch& solver) {
    std::vector<std::uint8_t>& unconverged = solver.unconverged;
    beginBySlot(unconverged, bodies.motions.size(), std::uint8_t{0});
    for (const Slot root : graph.componentRoots) {
        unconverged[root] = 0;
    }
    if (!sleep.sleepers.empty()) { // whose component may have the root of somebody asleep
        for (const Slot slot : bodies.moving) {
            unconverged[graph.roots[slot]] = 0;
        }
    }
}

void solveUnconverged(const SolverStage& stage, int passes) {
    SolverScratch& scratch = stage.solver;
    const std::vector<Slot>& roots = stage.graph.componentRoots;
    if (std::all_of(roots.begin(), roots.end(), [&](Slot root) { return isUnconverged(stage.solver, root); })) {
        relaxPasses(stage.constraints.batches, scratch.velocities, passes);
        return;
    }
    ContactBatches& part = scratch.componentBatches;
    part.circles.reset(stage.bodies.motions.size());
    part.general.reset(stage.bodies.motions.size());
    scratch.lanes.clear();
    copyThere(stage, stage.constraints.batches.circles, part.circles);
    const std::size_t firstGeneral = scratch.lanes.size();
    copyThere(stage, stage.constraints.batches.general, part.general);
    relaxPasses(part, scratch.velocities, passes);
    const std::span<const SolverScratch::SameLane> lanes(scratch.lanes);
    copyBack(part.circles, stage.constraints.batches.circles, lanes.first(firstGeneral));
    copyBack(part.general, stage.constraints.batches.general, lanes.subspan(firstGeneral));
}

bool solveClosingComponents(const SolverStage& stage) {
    bool closes = true;
    for (int round = 0; round < rounds && closes && markClosing(stage); ++round) {
        solveUnconverged(stage, passesInRound);
        closes = measureVelocities(stage.constraints.batches, stage.solver.velocities);
    }
    return closes;
}

void solveReweighed(const SolverStage& stage) {
    ContactGraph& graph = stage.graph;
    bool any = false;
    for (const Slot slot : stage.bodies.moving) {
        const BodyVelocity before = graph.inertias[slot];
        refreshInertia(stage.bodies.motions[slot], graph, slot);
        if (before.x != graph.inertias[slot].x || before.angular != graph.inertias[slot].angular) {
            if (!any) {
                clearUnconverged(stage.bodies, graph, stage.sleep, stage.solver);
            }
            stage.solver.unconverged[graph.roots[slot]] = 1;
            any = true;
        }
    }
    if (any) {
        solveUnconverged(stage, passesForNewWeight);
    }
}

void reserveForUnconverged(const SolverStage& stage) {
    SolverScratch& scratch = stage.solver;
    scratch.unconverged.resize(stage.bodies.motions.size());
    const std::size_t most = stage.constraints.circleContacts.capacity() + stage.constraints.generalContacts.capacity();
    if (scratch.lanes.capacity() < most) {
        scratch.lanes.reserve(most);
        scratch.componentBatches.circles.reserve(stage.constraints.batches.circles);
        scratch.componentBatches.general.reserve(stage.constraints.batches.general);
    }
}

} // namespace spacetow
