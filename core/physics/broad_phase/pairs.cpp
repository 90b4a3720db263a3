#include "core/physics/broad_phase/pairs.h"

#include "core/physics/broad_phase/find_pairs.h"
#include "core/physics/broad_phase/pair_changes.h"
#include "core/physics/broad_phase/statics.h"

#include <algorithm>
#include <cmath>

namespace spacetow {

namespace {

bool isSensor(const Pair& pair) {
    return pair.kind == PairKind::Sensor;
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
    data.moving.clear();
    data.scratch.solver.velocities.clear(); // of whatever does not move the solver takes them to be 0
    for (const BodyKind kind : {BodyKind::Kinematic, BodyKind::Dynamic}) {
        for (Slot slot = 0; slot < data.records.size(); ++slot) {
            const BodyRecord& record = data.records[slot];
            if (record.used && record.active && !record.asleep && record.kind == kind) {
                data.moving.push_back(slot);
            }
        }
    }
}

void prepareStructure(WorldData& data) {
    refreshStatics(data);
    if (!data.flags.bodiesChanged) {
        return;
    }
    listMoving(data);
    data.reporters.clear();
    for (Slot slot = 0; slot < data.records.size(); ++slot) {
        if (data.records[slot].used && data.records[slot].reportsTouches) {
            data.reporters.push_back(slot);
        }
    }
    data.motionBounds.assign(data.records.size(), 0);
    data.mayNeedToi.assign(data.records.size(), 0);
    data.plannedMotions.resize(data.records.size());
    data.extents.resize(data.records.size());
    for (const Slot slot : data.sleep.sleepers) {
        data.motionBounds[slot] = data.steps[slot].motionBound;
        data.notePlannedMotion(slot);
    }
    data.touchedTags.resize(data.records.size());
    data.flags.bodiesChanged = false;
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
