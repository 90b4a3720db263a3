#include "core/physics/solver/solve_unconverged.h"

#include "core/physics/lanes/solver_kernels.h"
#include "core/physics/solver/islands.h"

#include <algorithm>
#include <span>

namespace spacetow {

namespace {

constexpr int rounds = 10;
constexpr int passesInRound = 4;

bool isUnconverged(const Islands& islands, Slot root) {
    return islands.unconverged[root] != 0;
}

template <class Batch>
void markClosing(WorldData& data, const Batches<Batch>& batches) {
    forLanes(batches, &BatchFlags::closes, [&](Lane at) {
        const Slot root = rootAt(data, batches[at.batch], at.lane);
        data.islands.unconverged[root] = data.islands.driven[root] != 0 ? 0 : 1;
    });
}

/// Marks the islands in which contacts close; whether there are any. Not those that something drives which cannot be
/// stopped: they are not held back either, and in a turning drum something always closes.
bool markClosing(WorldData& data) {
    Islands& islands = data.islands;
    islands.unconverged.assign(data.motions.size(), 0);
    markClosing(data, data.batches.circles);
    markClosing(data, data.batches.general);
    return std::any_of(islands.islandRoots.begin(), islands.islandRoots.end(),
                       [&](Slot root) { return isUnconverged(islands, root); });
}

template <class Batch>
void copyThere(WorldData& data, const Batches<Batch>& from, Batches<Batch>& to) {
    forLanes(from, &BatchFlags::occupied, [&](Lane at) {
        const Batch& batch = from[at.batch];
        if (isUnconverged(data.islands, rootAt(data, batch, at.lane))) {
            const Slot a = batch.a[at.lane];
            const Slot b = batch.b[at.lane];
            const Lane lane = to.open(a, data.motions[a].isMovable(), b, data.motions[b].isMovable());
            copyLane(batch, at.lane, to[lane.batch], lane.lane);
            data.islands.lanes.push_back({at, lane});
        }
    });
}

template <class Batch>
void copyBack(const Batches<Batch>& from, Batches<Batch>& to, std::span<const Islands::SameLane> lanes) {
    for (const Islands::SameLane& lane : lanes) {
        copyLane(from[lane.there.batch], lane.there.lane, to[lane.here.batch], lane.here.lane);
    }
}

void relaxPasses(ContactBatches& batches, int passes) {
    for (int pass = 1; pass < passes; ++pass) {
        overrelaxPass(batches);
    }
    solvePass(batches);
}

} // namespace

void solveUnconverged(WorldData& data, int passes) {
    Islands& islands = data.islands;
    if (std::all_of(islands.islandRoots.begin(), islands.islandRoots.end(),
                    [&](Slot root) { return isUnconverged(islands, root); })) {
        relaxPasses(data.batches, passes);
        return;
    }
    ContactBatches& part = islands.batches;
    part.circles.reset(data.motions.size());
    part.general.reset(data.motions.size());
    islands.lanes.clear();
    copyThere(data, data.batches.circles, part.circles);
    const std::size_t firstGeneral = islands.lanes.size();
    copyThere(data, data.batches.general, part.general);
    std::swap(part.velocities, data.batches.velocities);
    relaxPasses(part, passes);
    std::swap(part.velocities, data.batches.velocities);
    const std::span<const Islands::SameLane> lanes(islands.lanes);
    copyBack(part.circles, data.batches.circles, lanes.first(firstGeneral));
    copyBack(part.general, data.batches.general, lanes.subspan(firstGeneral));
}

bool solveClosingIslands(WorldData& data) {
    bool closes = true;
    for (int round = 0; round < rounds && closes && markClosing(data); ++round) {
        solveUnconverged(data, passesInRound);
        closes = measureVelocities(data.batches);
    }
    return closes;
}

void reserveForUnconverged(WorldData& data) {
    Islands& islands = data.islands;
    islands.unconverged.resize(data.motions.size());
    const std::size_t contacts = data.circleContacts.capacity() + data.generalContacts.capacity();
    if (islands.lanes.capacity() < contacts) {
        islands.lanes.reserve(contacts);
        islands.batches.circles.reserve(data.batches.circles);
        islands.batches.general.reserve(data.batches.general);
    }
}

} // namespace spacetow
