#include "core/physics/sleep/touches.h"

#include "core/physics/contacts/constraint_list.h"
#include "core/physics/contacts/contact_pool.h"

#include <algorithm>

namespace spacetow {

namespace {

TouchEvent touchEvent(const WorldData& data, std::uint64_t bodies, int iteration) {
    auto a = static_cast<Slot>(bodies >> 32);
    auto b = static_cast<Slot>(bodies & 0xffffffffu);
    if (data.records[b].serial < data.records[a].serial) {
        std::swap(a, b);
    }
    return {iteration, data.idOf(a), data.idOf(b), data.records[a].tangible && data.records[b].tangible};
}

/// All pairs of the same two bodies.
struct Group {
    std::uint64_t bodies = 0;
    std::size_t first = 0, end = 0;
};

Group groupAround(const WorldData& data, std::size_t index) {
    const std::vector<Pair>& pairs = data.table.pairs;
    const std::uint64_t bodies = pairs[index].bodies();
    Group group{bodies, index, index + 1};
    while (group.first > 0 && pairs[group.first - 1].bodies() == bodies) {
        --group.first;
    }
    while (group.end < pairs.size() && pairs[group.end].bodies() == bodies) {
        ++group.end;
    }
    return group;
}

void report(WorldData& data, const Group& group, bool before, int iteration) {
    bool now = false;
    for (std::size_t i = group.first; i < group.end; ++i) {
        PairFlags& flags = data.table.flags[i];
        now |= flags.touching;
        before |= flags.reported;
        flags.reported = flags.touching;
    }
    if (now != before) {
        (now ? data.events.began : data.events.ended).push_back(touchEvent(data, group.bodies, iteration));
    }
}

/// Pairs whose boxes have parted are no longer in the table; others of the same bodies may still touch.
void reportDropped(WorldData& data, int iteration) {
    for (const std::uint64_t bodies : data.scratch.changes.droppedTouches) {
        const auto found = std::lower_bound(data.table.pairs.begin(), data.table.pairs.end(), bodies,
                                            [](const Pair& pair, std::uint64_t key) { return pair.bodies() < key; });
        Group group{bodies};
        if (found != data.table.pairs.end() && found->bodies() == bodies) {
            group = groupAround(data, static_cast<std::size_t>(found - data.table.pairs.begin()));
        }
        report(data, group, true, iteration);
    }
    data.scratch.changes.droppedTouches.clear();
}

void reportChanged(WorldData& data, int iteration) {
    for (std::size_t i = 0; i < data.table.size(); ++i) {
        const PairFlags& flags = data.table.flags[i];
        if (flags.touching != flags.reported) {
            report(data, groupAround(data, i), false, iteration);
        }
    }
}

} // namespace

void reportTouches(WorldData& data, int iteration) {
    reportDropped(data, iteration);
    reportChanged(data, iteration);
    if (data.reporters.empty()) {
        return;
    }
    collectTouchedTags(data);
    for (const Slot slot : data.reporters) {
        if (data.touchedTags[slot].bits != 0) {
            data.events.tagsTouched.push_back({iteration, data.idOf(slot), data.touchedTags[slot]});
        }
    }
}

void joinTagReports(WorldData& data, std::size_t first) {
    std::vector<TagsTouchedEvent>& reports = data.events.tagsTouched;
    const auto begin = reports.begin() + static_cast<std::ptrdiff_t>(first);
    std::stable_sort(begin, reports.end(), [](const auto& a, const auto& b) { return a.body.index < b.body.index; });
    auto last = begin;
    for (auto next = begin; next != reports.end(); ++next) {
        if (next->body == last->body) {
            last->tags = last->tags | next->tags;
        } else {
            *++last = *next;
        }
    }
    reports.erase(last == reports.end() ? last : last + 1, reports.end());
}

void collectTouchedTags(WorldData& data) {
    std::fill(data.touchedTags.begin(), data.touchedTags.end(), TagMask{});
    std::copy(data.sleep.touchedTags.begin(), data.sleep.touchedTags.end(), data.touchedTags.begin());
    addTouchedTags(data, data.table, data.touchedTags);
}

void addTouchedTags(const WorldData& data, const PairTable& table, std::vector<TagMask>& tags) {
    for (std::size_t i = 0; i < table.size(); ++i) {
        if (table.flags[i].touching) {
            const Pair& pair = table.pairs[i];
            tags[pair.bodyA] = tags[pair.bodyA] | data.records[pair.bodyB].filter.tags;
            tags[pair.bodyB] = tags[pair.bodyB] | data.records[pair.bodyA].filter.tags;
        }
    }
}

void endTouches(WorldData& data, Slot slot, int iteration) {
    releaseConstraints(data);
    for (std::size_t i = 0; i < data.table.size(); ++i) {
        const Pair& pair = data.table.pairs[i];
        if (pair.bodyA == slot || pair.bodyB == slot) {
            for (const Group group = groupAround(data, i); i < group.end; ++i) {
                data.table.flags[i].touching = false;
                freeContact(data, data.table.pairs[i]);
            }
            --i;
            report(data, groupAround(data, i), false, iteration);
        }
    }
}

} // namespace spacetow
