#include "core/physics/step/body_lists.h"

#include "core/physics/broad_phase/pairs.h"
#include "core/physics/broad_phase/statics.h"

#include <algorithm>
#include <utility>

namespace spacetow {

namespace {

// Up to this many changed bodies are inserted one by one; more are listed by a pass over all bodies.
constexpr std::size_t fewBodies = 64;

bool isNonStatic(const BodyRecord& record) {
    return record.used && record.kind != BodyKind::Static;
}

/// Inserts the slot in a sorted list, or erases it.
void put(std::vector<Slot>& list, Slot slot, bool in) {
    const auto at = std::lower_bound(list.begin(), list.end(), slot);
    const bool listed = at != list.end() && *at == slot;
    if (in && !listed) {
        list.insert(at, slot);
    } else if (!in && listed) {
        list.erase(at);
    }
}

void relist(Bodies& bodies, Slot slot) {
    const BodyRecord& record = bodies.records[slot];
    put(bodies.nonStatic, slot, isNonStatic(record));
    put(bodies.reporters, slot, record.used && record.reportsTouches);
}

void listBodies(Bodies& bodies) {
    bodies.nonStatic.clear();
    bodies.reporters.clear();
    for (Slot slot = 0; slot < bodies.records.size(); ++slot) {
        const BodyRecord& record = bodies.records[slot];
        if (isNonStatic(record)) {
            bodies.nonStatic.push_back(slot);
        }
        if (record.used && record.reportsTouches) {
            bodies.reporters.push_back(slot);
        }
    }
}

} // namespace

void refreshBodyLists(WorldData& data) {
    Bodies& bodies = data.bodies;
    refreshStatics(bodies, data.broadPhase, data.sleep.table, data.flags);
    data.flags.pairsStale |= std::exchange(data.flags.crowded, false);
    const std::size_t count = bodies.records.size();
    bodies.motionBounds.resize(count);
    bodies.mayNeedToi.resize(count);
    bodies.plannedMotions.resize(count);
    bodies.extents.resize(count);
    bodies.touchedTags.resize(count);
    if (data.sleep.allowed) {
        data.scratch.sleep.parents.resize(count);
        data.scratch.sleep.marked.resize(count);
    }
    if (bodies.changedBodies.empty()) {
        return;
    }
    if (bodies.changedBodies.size() <= fewBodies) {
        std::for_each(bodies.changedBodies.begin(), bodies.changedBodies.end(),
                      [&](Slot slot) { relist(bodies, slot); });
    } else {
        listBodies(bodies);
    }
    listMoving(bodies, data.scratch.solver, data.scratch.toi);
    for (const Slot slot : bodies.changedBodies) {
        bodies.motionBounds[slot] = bodies.records[slot].asleep ? bodies.steps[slot].motionBound : 0;
        bodies.mayNeedToi[slot] = 0;
        bodies.touchedTags[slot] = TagMask{};
    }
    bodies.slotsToReset.insert(bodies.slotsToReset.end(), bodies.changedBodies.begin(), bodies.changedBodies.end());
    bodies.changedBodies.clear();
    bodies.addedNonStatic.clear();
    data.flags.pairsStale = true;
}

} // namespace spacetow
