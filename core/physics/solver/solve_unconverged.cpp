#include "core/physics/solver/solve_unconverged.h"

#include "core/physics/lanes/solver_kernels.h"
#include "core/physics/solver/accelerated_passes.h"
#include "core/physics/solver/contact_graph.h"

#include <algorithm>
#include <span>

namespace spacetow {

namespace {

constexpr int rounds = 10;
constexpr int passesInRound = 4;
// Once for each change of a mass, at most: what rests on it is neither to sink nor to lean meanwhile.
constexpr int passesForNewWeight = 100;

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
    clearUnconverged(stage.bodies, stage.graph, stage.solver);
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

/// Copies the contacts of unconverged components to batches of their own. Returns how many of them are circles: these
/// come first in the list of lanes.
std::size_t copyThere(const SolverStage& stage) {
    ContactBatches& part = stage.solver.componentBatches;
    part.circles.reset(stage.bodies.motions.size());
    part.general.reset(stage.bodies.motions.size());
    stage.solver.lanes.clear();
    copyThere(stage, stage.constraints.batches.circles, part.circles);
    const std::size_t circles = stage.solver.lanes.size();
    copyThere(stage, stage.constraints.batches.general, part.general);
    return circles;
}

void copyBack(const SolverStage& stage, std::size_t circles) {
    const ContactBatches& part = stage.solver.componentBatches;
    const std::span<const SolverScratch::SameLane> lanes(stage.solver.lanes);
    copyBack(part.circles, stage.constraints.batches.circles, lanes.first(circles));
    copyBack(part.general, stage.constraints.batches.general, lanes.subspan(circles));
}

/// The lanes of the copies, in the order of their pairs: that does not depend on other components.
template <class Kind, class Batch>
std::vector<Lane> orderedLanes(std::span<SolverScratch::SameLane> lanes, const std::vector<Kind>& list,
                               const Batches<Batch>& batches) {
    const auto pair = [&](const SolverScratch::SameLane& lane) {
        return pairOf(list[batches.anchors(lane.here.batch).owner[lane.here.lane]]);
    };
    std::sort(lanes.begin(), lanes.end(), [&](const auto& a, const auto& b) { return pair(a) < pair(b); });
    std::vector<Lane> result;
    for (const SolverScratch::SameLane& lane : lanes) {
        result.push_back(lane.there);
    }
    return result;
}

/// Each component by itself: mixed with others, none would get its own result.
void solveAlone(const SolverStage& stage, Slot root) {
    stage.solver.unconverged[root] = 1;
    const std::size_t circles = copyThere(stage);
    const std::span<SolverScratch::SameLane> lanes(stage.solver.lanes);
    const Constraints& all = stage.constraints;
    const std::vector<Lane> ofCircles = orderedLanes(lanes.first(circles), all.circleContacts, all.batches.circles);
    const std::vector<Lane> others = orderedLanes(lanes.subspan(circles), all.generalContacts, all.batches.general);
    solveUntilConverged(stage.solver.componentBatches, {ofCircles, others}, stage.solver.velocities,
                        passesForNewWeight);
    copyBack(stage, circles);
    stage.solver.unconverged[root] = 0;
}

void relaxPasses(ContactBatches& batches, std::vector<BodyVelocity>& velocities, int passes) {
    for (int pass = 1; pass < passes; ++pass) {
        overrelaxPass(batches, velocities);
    }
    solvePass(batches, velocities);
}

} // namespace

void clearUnconverged(const Bodies& bodies, const ContactGraph& graph, SolverScratch& solver) {
    std::vector<std::uint8_t>& unconverged = solver.unconverged;
    beginBySlot(unconverged, bodies.motions.size(), std::uint8_t{0});
    for (const Slot root : graph.componentRoots) {
        unconverged[root] = 0;
    }
}

void solveUnconverged(const SolverStage& stage, int passes) {
    SolverScratch& scratch = stage.solver;
    const std::vector<Slot>& roots = stage.graph.componentRoots;
    if (std::all_of(roots.begin(), roots.end(), [&](Slot root) { return isUnconverged(stage.solver, root); })) {
        relaxPasses(stage.constraints.batches, scratch.velocities, passes);
        return;
    }
    const std::size_t circles = copyThere(stage);
    relaxPasses(scratch.componentBatches, scratch.velocities, passes);
    copyBack(stage, circles);
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
    std::vector<Slot> roots;
    for (const Slot slot : stage.bodies.moving) {
        const BodyVelocity before = graph.inertias[slot];
        refreshInertia(stage.bodies.motions[slot], graph, slot);
        if (before.x != graph.inertias[slot].x || before.angular != graph.inertias[slot].angular) {
            roots.push_back(graph.roots[slot]);
        }
    }
    if (roots.empty()) {
        return;
    }
    std::sort(roots.begin(), roots.end());
    roots.erase(std::unique(roots.begin(), roots.end()), roots.end());
    clearUnconverged(stage.bodies, graph, stage.solver);
    for (const Slot root : roots) {
        solveAlone(stage, root);
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
