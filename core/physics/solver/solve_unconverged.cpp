#include "core/physics/solver/solve_unconverged.h"

#include "core/physics/lanes/solver_kernels.h"
#include "core/physics/solver/islands.h"

#include <algorithm>
#include <span>

namespace spacetow {

namespace {

constexpr int rounds = 10;
constexpr int passesInRound = 4;

bool isUnconverged(const SolverScratch& solver, Slot root) {
    return solver.unconverged[root] != 0;
}

template <class Batch>
void markClosing(WorldData& data, const Batches<Batch>& batches) {
    forLanes(batches, &BatchFlags::closes, [&](Lane at) {
        const Slot root = rootAt(data.islands, batches[at.batch], at.lane);
        data.scratch.solver.unconverged[root] = data.scratch.solver.driven[root] != 0 ? 0 : 1;
    });
}

/// Marks the islands in which contacts close; whether there are any. Not those that something drives which cannot be
/// stopped: they are not held back either, and in a turning drum something always closes.
bool markClosing(WorldData& data) {
    settleAll(data.bodies, data.islands, data.sleep, data.scratch.solver);
    markClosing(data, data.constraints.batches.circles);
    markClosing(data, data.constraints.batches.general);
    const std::vector<Slot>& roots = data.islands.islandRoots;
    return std::any_of(roots.begin(), roots.end(), [&](Slot root) { return isUnconverged(data.scratch.solver, root); });
}

template <class Batch>
void copyThere(WorldData& data, const Batches<Batch>& from, Batches<Batch>& to) {
    forLanes(from, &BatchFlags::occupied, [&](Lane at) {
        const Batch& batch = from[at.batch];
        if (isUnconverged(data.scratch.solver, rootAt(data.islands, batch, at.lane))) {
            const Slot a = batch.a[at.lane];
            const Slot b = batch.b[at.lane];
            const Lane lane = to.open(a, data.bodies.motions[a].isMovable(), b, data.bodies.motions[b].isMovable());
            copyLane(batch, at.lane, to[lane.batch], lane.lane);
            data.scratch.solver.lanes.push_back({at, lane});
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

void settleAll(const Bodies& bodies, const Islands& islands, const Sleep& sleep, SolverScratch& solver) {
    std::vector<std::uint8_t>& unconverged = solver.unconverged;
    beginBySlot(unconverged, bodies.motions.size(), std::uint8_t{0});
    for (const Slot root : islands.islandRoots) {
        unconverged[root] = 0;
    }
    if (!sleep.sleepers.empty()) { // whose island is that of somebody asleep
        for (const Slot slot : bodies.moving) {
            unconverged[islands.roots[slot]] = 0;
        }
    }
}

void solveUnconverged(WorldData& data, int passes) {
    SolverScratch& scratch = data.scratch.solver;
    const std::vector<Slot>& roots = data.islands.islandRoots;
    if (std::all_of(roots.begin(), roots.end(), [&](Slot root) { return isUnconverged(data.scratch.solver, root); })) {
        relaxPasses(data.constraints.batches, scratch.velocities, passes);
        return;
    }
    ContactBatches& part = scratch.islandBatches;
    part.circles.reset(data.bodies.motions.size());
    part.general.reset(data.bodies.motions.size());
    scratch.lanes.clear();
    copyThere(data, data.constraints.batches.circles, part.circles);
    const std::size_t firstGeneral = scratch.lanes.size();
    copyThere(data, data.constraints.batches.general, part.general);
    relaxPasses(part, scratch.velocities, passes);
    const std::span<const SolverScratch::SameLane> lanes(scratch.lanes);
    copyBack(part.circles, data.constraints.batches.circles, lanes.first(firstGeneral));
    copyBack(part.general, data.constraints.batches.general, lanes.subspan(firstGeneral));
}

bool solveClosingIslands(WorldData& data) {
    bool closes = true;
    for (int round = 0; round < rounds && closes && markClosing(data); ++round) {
        solveUnconverged(data, passesInRound);
        closes = measureVelocities(data.constraints.batches, data.scratch.solver.velocities);
    }
    return closes;
}

void reserveForUnconverged(WorldData& data) {
    SolverScratch& scratch = data.scratch.solver;
    scratch.unconverged.resize(data.bodies.motions.size());
    const std::size_t most = data.constraints.circleContacts.capacity() + data.constraints.generalContacts.capacity();
    if (scratch.lanes.capacity() < most) {
        scratch.lanes.reserve(most);
        scratch.islandBatches.circles.reserve(data.constraints.batches.circles);
        scratch.islandBatches.general.reserve(data.constraints.batches.general);
    }
}

} // namespace spacetow
