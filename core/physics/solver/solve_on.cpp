#include "core/physics/solver/solve_on.h"

#include "core/physics/lanes/solver_kernels.h"
#include "core/physics/solver/islands.h"

#include <algorithm>
#include <span>

namespace spacetow {

namespace {

constexpr int rounds = 10;
constexpr int passesInRound = 4;

bool isUnsettled(const Islands& islands, Slot root) {
    return islands.unsettled[root] != 0;
}

template <class Batch>
void markClosing(WorldData& data, const Batches<Batch>& batches) {
    forLanes(batches, &BatchNotes::closes, [&](Lane at) {
        const Slot root = rootAt(data, batches[at.batch], at.lane);
        data.islands.unsettled[root] = data.islands.driven[root] != 0 ? 0 : 1;
    });
}

/// Marks the islands in which contacts close; whether there are any. Not those that something drives which cannot be
/// stopped: they are not held back either, and in a turning drum something always closes.
bool markClosing(WorldData& data) {
    Islands& islands = data.islands;
    islands.unsettled.assign(data.motions.size(), 0);
    markClosing(data, data.batches.round);
    markClosing(data, data.batches.general);
    return std::any_of(islands.all.begin(), islands.all.end(), [&](Slot root) { return isUnsettled(islands, root); });
}

template <class Batch>
void copyThere(WorldData& data, const Batches<Batch>& from, Batches<Batch>& to) {
    forLanes(from, &BatchNotes::occupied, [&](Lane at) {
        const Batch& batch = from[at.batch];
        if (isUnsettled(data.islands, rootAt(data, batch, at.lane))) {
            const Slot a = batch.a[at.lane];
            const Slot b = batch.b[at.lane];
            const Lane lane = to.open(a, data.motions[a].yields(), b, data.motions[b].yields());
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

void solveFurther(ContactBatches& batches, int passes) {
    for (int pass = 1; pass < passes; ++pass) {
        overrelaxPass(batches);
    }
    solvePass(batches);
}

} // namespace

void solveOn(WorldData& data, int passes) {
    Islands& islands = data.islands;
    if (std::all_of(islands.all.begin(), islands.all.end(), [&](Slot root) { return isUnsettled(islands, root); })) {
        solveFurther(data.batches, passes);
        return;
    }
    ContactBatches& part = islands.batches;
    part.round.reset(data.motions.size());
    part.general.reset(data.motions.size());
    islands.lanes.clear();
    copyThere(data, data.batches.round, part.round);
    const std::size_t firstGeneral = islands.lanes.size();
    copyThere(data, data.batches.general, part.general);
    std::swap(part.paces, data.batches.paces);
    solveFurther(part, passes);
    std::swap(part.paces, data.batches.paces);
    const std::span<const Islands::SameLane> lanes(islands.lanes);
    copyBack(part.round, data.batches.round, lanes.first(firstGeneral));
    copyBack(part.general, data.batches.general, lanes.subspan(firstGeneral));
}

bool solveOnWhereClosing(WorldData& data) {
    bool closes = true;
    for (int round = 0; round < rounds && closes && markClosing(data); ++round) {
        solveOn(data, passesInRound);
        closes = measureVelocities(data.batches);
    }
    return closes;
}

void reserveForSolvingOn(WorldData& data) {
    Islands& islands = data.islands;
    islands.unsettled.resize(data.motions.size());
    const std::size_t contacts = data.roundContacts.capacity() + data.generalContacts.capacity();
    if (islands.lanes.capacity() < contacts) {
        islands.lanes.reserve(contacts);
        islands.batches.round.reserve(data.batches.round);
        islands.batches.general.reserve(data.batches.general);
    }
}

} // namespace spacetow
