#include "core/physics/touches.h"

#include <algorithm>

namespace spacetow {

namespace {

TouchEvent touchEvent(const WorldData& data, const SlotPair& pair, int iteration) {
    Slot a = pair.first;
    Slot b = pair.second;
    if (data.records[b].serial < data.records[a].serial) {
        std::swap(a, b);
    }
    return {iteration, data.idOf(a), data.idOf(b), data.records[a].tangible && data.records[b].tangible};
}

void collectTouching(WorldData& data) {
    data.touchingNow.clear();
    for (const Pair& pair : data.pairs) {
        if (pair.touching) {
            data.touchingNow.push_back(std::minmax(pair.bodyA, pair.bodyB));
        }
    }
    std::sort(data.touchingNow.begin(), data.touchingNow.end());
    data.touchingNow.erase(std::unique(data.touchingNow.begin(), data.touchingNow.end()), data.touchingNow.end());
}

void mergeEvents(WorldData& data, int iteration) {
    auto before = data.touching.begin();
    auto now = data.touchingNow.begin();
    while (before != data.touching.end() || now != data.touchingNow.end()) {
        if (now == data.touchingNow.end() || (before != data.touching.end() && *before < *now)) {
            data.events.ended.push_back(touchEvent(data, *before++, iteration));
        } else if (before == data.touching.end() || *now < *before) {
            data.events.began.push_back(touchEvent(data, *now++, iteration));
        } else {
            ++before;
            ++now;
        }
    }
}

void collectTags(WorldData& data, int iteration) {
    for (const SlotPair& pair : data.touching) {
        data.records[pair.first].touchedTags = {};
        data.records[pair.second].touchedTags = {};
    }
    for (const auto& [a, b] : data.touchingNow) {
        data.records[a].touchedTags = data.records[a].touchedTags | data.records[b].filter.tags;
        data.records[b].touchedTags = data.records[b].touchedTags | data.records[a].filter.tags;
    }
    for (const auto& pair : data.touchingNow) {
        for (const Slot slot : {pair.first, pair.second}) {
            BodyRecord& record = data.records[slot];
            if (record.reportsTouches && record.lastReport != data.iterationCount && record.touchedTags.bits != 0) {
                record.lastReport = data.iterationCount;
                data.events.tagsTouched.push_back({iteration, data.idOf(slot), record.touchedTags});
            }
        }
    }
}

} // namespace

void reportTouches(WorldData& data, int iteration) {
    collectTouching(data);
    mergeEvents(data, iteration);
    collectTags(data, iteration);
    data.touching.swap(data.touchingNow);
    ++data.iterationCount;
}

} // namespace spacetow
