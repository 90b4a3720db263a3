#include "core/physics/broad_phase/pairs.h"

#include "core/physics/broad_phase/find_pairs.h"
#include "core/physics/broad_phase/pair_changes.h"
#include "core/physics/broad_phase/statics.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace spacetow {

namespace {

bool isSensor(const Pair& pair) {
    return pair.kind == PairKind::Sensor;
}

template <class T>
void clearSlots(std::vector<T>& list, const std::vector<Slot>& slots) {
    for (const Slot slot : slots) {
        if (slot < list.size()) {
            list[slot] = T{};
        }
    }
}

/// What the solver keeps by slot of those that have moved begins anew: it writes no other.
void clearBySlot(Scratch& scratch, const std::vector<Slot>& moved) {
    clearSlots(scratch.solver.velocities, moved);
    clearSlots(scratch.solver.corrections, moved);
    clearSlots(scratch.solver.driven, moved);
    clearSlots(scratch.solver.unconverged, moved);
    clearSlots(scratch.solver.limited, moved);
    clearSlots(scratch.toi.shortenedAt, moved);
    for (const Slot slot : moved) {
        if (slot < scratch.solver.fractions.size()) {
            scratch.solver.fractions[slot] = 1;
        }
    }
}

// Up to so many are put into the lists one by one.
constexpr std::size_t fewBodies = 64;

bool isNonStatic(const BodyRecord& record) {
    return record.used && record.kind != BodyKind::Static;
}

/// In a sorted list, or not.
void put(std::vector<Slot>& list, Slot slot, bool in) {
    const auto at = std::lower_bound(list.begin(), list.end(), slot);
    const bool listed = at != list.end() && *at == slot;
    if (in && !listed) {
        list.insert(at, slot);
    } else if (!in && listed) {
        list.erase(at);
    }
}

void relist(WorldData& data, Slot slot) {
    const BodyRecord& record = data.records[slot];
    put(data.nonStatic, slot, isNonStatic(record));
    put(data.reporters, slot, record.used && record.reportsTouches);
}

void listBodies(WorldData& data) {
    data.nonStatic.clear();
    data.reporters.clear();
    for (Slot slot = 0; slot < data.records.size(); ++slot) {
        const BodyRecord& record = data.records[slot];
        if (isNonStatic(record)) {
            data.nonStatic.push_back(slot);
        }
        if (record.used && record.reportsTouches) {
            data.reporters.push_back(slot);
        }
    }
}

} // namespace

void listSensors(WorldData& data) {
    data.sensors.clear();
    for (std::uint32_t i = 0; i < data.table.size(); ++i) {
        if (isSensor(data.table.pairs[i])) {
            data.sensors.push_back(i);
        }
    }
    data.flags.islandsStale = true;
}

void listMoving(WorldData& data) {
    clearBySlot(data.scratch, data.moving);
    data.moving.clear();
    for (const BodyKind kind : {BodyKind::Kinematic, BodyKind::Dynamic}) {
        for (const Slot slot : data.nonStatic) {
            const BodyRecord& record = data.records[slot];
            if (record.active && !record.asleep && record.kind == kind) {
                data.moving.push_back(slot);
            }
        }
    }
}

void prepareStructure(WorldData& data) {
    refreshStatics(data);
    data.flags.pairsStale |= std::exchange(data.flags.crowded, false);
    const std::size_t bodies = data.records.size();
    data.motionBounds.resize(bodies);
    data.mayNeedToi.resize(bodies);
    data.plannedMotions.resize(bodies);
    data.extents.resize(bodies);
    data.touchedTags.resize(bodies);
    if (data.sleep.allowed) {
        data.scratch.sleep.parents.resize(bodies);
        data.scratch.sleep.marked.resize(bodies);
    }
    if (data.changedBodies.empty()) {
        return;
    }
    if (data.changedBodies.size() <= fewBodies) {
        std::for_each(data.changedBodies.begin(), data.changedBodies.end(), [&](Slot slot) { relist(data, slot); });
    } else {
        listBodies(data);
    }
    listMoving(data);
    for (const Slot slot : data.changedBodies) {
        data.motionBounds[slot] = data.records[slot].asleep ? data.steps[slot].motionBound : 0;
        data.mayNeedToi[slot] = 0;
        data.touchedTags[slot] = TagMask{};
    }
    data.renewed.insert(data.renewed.end(), data.changedBodies.begin(), data.changedBodies.end());
    data.changedBodies.clear();
    data.flags.pairsStale = true;
}

void measureMotion(WorldData& data, double ahead) {
    data.flags.anyMovedProxy = data.flags.pairsStale;
    data.flags.anyFault = data.flags.anyFast = false;
    data.scratch.search.movedBodies.clear();
    for (const Slot slot : data.moving) {
        BodyStep& s = data.steps[slot];
        const BodyMotion& m = data.motions[slot];
        const double reach = s.maxMotion();
        data.flags.anyFault |= !isSound(m, s);
        data.motionBounds[slot] = s.motionBound + reach;
        data.notePlannedMotion(slot);
        const bool far = exceedsMargin(s, reach);
        data.flags.anyFast |= far;
        data.mayNeedToi[slot] = far || s.bouncing || s.deflected ? 1 : 0;
        s.movedProxy = !s.fat.centers.contains(m.center) ||
                       !s.fat.centers.contains(Vec2(m.center + s.deltaPosition + ahead * m.velocity)) ||
                       std::abs(s.deltaAngle + ahead * m.angularVelocity) > s.fat.angleLeft;
        if (s.movedProxy) {
            data.scratch.search.movedBodies.push_back(slot);
        }
    }
    data.flags.anyMovedProxy |= !data.scratch.search.movedBodies.empty();
}

bool findPairs(WorldData& data, const IterationStep& step) {
    if (data.flags.pairsStale) {
        listProxies(data);
    }
    enlargeAabbs(data, step.remaining);
    collectPairs(data);
    data.flags.anyMovedProxy = false;
    return comparePairs(data);
}

void changePairs(WorldData& data) {
    changeTable(data);
    data.flags.islandsStale = true;
    if (data.flags.pairsStale || !data.sensors.empty() ||
        std::any_of(data.scratch.changes.newPairs.begin(), data.scratch.changes.newPairs.end(), isSensor)) {
        listSensors(data);
    }
    data.flags.pairsStale = false;
}

} // namespace spacetow
