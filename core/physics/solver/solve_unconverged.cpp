#include "core/physics/solver/solve_unconverged.h"

#include "core/physics/lanes/solver_kernels.h"
#include "core/physics/solver/islands.h"

#include <algorithm>
#include <span>

namespace spacetow {

namespace {

constexpr int rounds = 10;
constexpr int passesInRound = 4;

bool isUnconverged(const WorldData& data, Slot root) {
    return data.scratch.solver.unconverged[root] != 0;
}

template <class Batch>
void markClosing(WorldData& data, const Batches<Batch>& batches) {
    forLanes(batches, &BatchFlags::closes, [&](Lane at) {
        const Slot root = rootAt(data, batches[at.batch], at.lane);
        data.scratch.solver.unconverged[root] = data.scratch.solver.driven[root] != 0 ? 0 : 1;
    });
}

/// Marks the islands in which contacts close; whether there are any. Not those that something drives which cannot be
/// stopped: they are not held back either, and in a turning drum something always closes.
bool markClosing(WorldData& data) {
    settleAll(data);
    markClosing(data, data.batches.circles);
    markClosing(data, data.batches.general);
    const std::vector<Slot>& roots = data.islands.islandRoots;
    return std::any_of(roots.begin(), roots.end(), [&](Slot root) { return isUnconverged(data, root); });
}

template <class Batch>
void copyThere(WorldData& data, const Batches<Batch>& from, Batches<Batch>& to) {
    forLanes(from, &BatchFlags::occupied, [&](Lane at) {
        const Batch& batch = from[at.batch];
        if (isUnconverged(data, rootAt(data, batch, at.lane))) {
            const Slot a = batch.a[at.lane];
            const Slot b = batch.b[at.lane];
            const Lane lane = to.open(a, data.motions[a].isMovable(), b, data.motions[b].isMovable());
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

void settleAll(WorldData& data) {
    std::vector<std::uint8_t>& unconverged = data.scratch.solver.unconverged;
    beginBySlot(unconverged, data.motions.size(), std::uint8_t{0});
    for (const Slot root : data.islands.islandRoots) {
        unconverged[root] = 0;
    }
    if (!data.sleep.sleepers.empty()) { // whose island is that of somebody asleep
        for (const Slot slot : data.moving) {
            unconverged[data.islands.roots[slot]] = 0;
        }
    }
}

void solveUnconverged(WorldData& data, int passes) {
    SolverScratch& scratch = data.scratch.solver;
    const std::vector<Slot>& roots = data.islands.islandRoots;
    if (std::all_of(roots.begin(), roots.end(), [&](Slot root) { return isUnconverged(data, root); })) {
        relaxPasses(data.batches, scratch.velocities, passes);
        return;
    }
    ContactBatches& part = scratch.islandBatches;
    part.circles.reset(data.motions.size());
    part.general.reset(data.motions.size());
    scratch.lanes.clear();
    copyThere(data, data.batches.circles, part.circles);
    const std::size_t firstGeneral = scratch.lanes.size();
    copyThere(data, data.batches.general, part.general);
    relaxPasses(part, scratch.velocities, passes);
    const std::span<const SolverScratch::SameLane> lanes(scratch.lanes);
    copyBack(part.circles, data.batches.circles, lanes.first(firstGeneral));
    copyBack(part.general, data.batches.general, lanes.subspan(firstGeneral));
}

bool solveClosingIslands(WorldData& data) {
    bool closes = true;
    for (int round = 0; round < rounds && closes && markClosing(data); ++round) {
        solveUnconverged(data, passesInRound);
        closes = measureVelocities(data.batches, data.scratch.solver.velocities);
    }
    return closes;
}

void reserveForUnconverged(WorldData& data) {
    SolverScratch& scratch = data.scratch.solver;
    scratch.unconverged.resize(data.motions.size());
    const std::size_t contacts = data.circleContacts.capacity() + data.generalContacts.capacity();
    if (scratch.lanes.capacity() < contacts) {
        scratch.lanes.reserve(contacts);
        scratch.islandBatches.circles.reserve(data.batches.circles);
        scratch.islandBatches.general.reserve(data.batches.general);
    }
}

} // namespace spacetow
