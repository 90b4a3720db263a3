#include "core/physics/broad_phase/pairs.h"

#include "core/physics/broad_phase/collect_pairs.h"
#include "core/physics/broad_phase/merge_pairs.h"
#include "core/physics/broad_phase/statics.h"

#include <algorithm>
#include <cmath>

namespace spacetow {

namespace {

bool isFelt(const Pair& pair) {
    return pair.kind == PairKind::Felt;
}

} // namespace

void listFelt(WorldData& data) {
    data.felt.clear();
    for (std::uint32_t i = 0; i < data.table.size(); ++i) {
        if (isFelt(data.table.pairs[i])) {
            data.felt.push_back(i);
        }
    }
    data.islandsStale = true;
}

void listMoving(WorldData& data) {
    data.moving.clear();
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
    if (!data.bodiesChanged) {
        return;
    }
    listMoving(data);
    data.reporters.clear();
    for (Slot slot = 0; slot < data.records.size(); ++slot) {
        if (data.records[slot].used && data.records[slot].reportsTouches) {
            data.reporters.push_back(slot);
        }
    }
    data.travelled.assign(data.records.size() + 1, 0);
    data.alert.assign(data.records.size() + 1, 0);
    data.ways.resize(data.records.size() + 1);
    data.reaches.resize(data.records.size() + 1);
    for (const Slot slot : data.sleep.sleepers) {
        data.travelled[slot + 1] = data.steps[slot].travelled;
        data.noteWay(slot);
    }
    data.touchedTags.resize(data.records.size());
    data.bodiesChanged = false;
    data.pairsStale = true;
}

void measureMotion(WorldData& data, double ahead) {
    data.anyEscaped = data.pairsStale;
    data.anyFault = data.anyFast = false;
    data.escaped.clear();
    for (const Slot slot : data.moving) {
        BodyStep& s = data.steps[slot];
        const BodyMotion& m = data.motions[slot];
        const double reach = s.reach();
        data.anyFault |= !isSound(m, s);
        data.travelled[slot + 1] = s.travelled + reach;
        data.noteWay(slot);
        const bool far = isFar(s, reach);
        data.anyFast |= far;
        data.alert[slot + 1] = far || s.bouncing || s.diverted ? 1 : 0;
        s.escaped = !s.room.centers.contains(m.center) ||
                    !s.room.centers.contains(Vec2(m.center + s.shift + ahead * m.velocity)) ||
                    std::abs(s.turn + ahead * m.angularVelocity) > s.room.turnLeft;
        if (s.escaped) {
            data.escaped.push_back(slot);
        }
    }
    data.anyEscaped |= !data.escaped.empty();
}

bool findPairs(WorldData& data, const IterationStep& step) {
    if (data.pairsStale) {
        listColliders(data);
    }
    giveRoom(data, step.remaining);
    collectPairs(data);
    data.anyEscaped = false;
    return comparePairs(data);
}

void changePairs(WorldData& data) {
    changeTable(data);
    data.islandsStale = true;
    if (data.pairsStale || !data.felt.empty() || std::any_of(data.newPairs.begin(), data.newPairs.end(), isFelt)) {
        listFelt(data);
    }
    data.pairsStale = false;
}

} // namespace spacetow
