#include "core/physics/sleep/touches.h"

#include "core/physics/contacts/constraint_list.h"
#include "core/physics/contacts/contact_pool.h"

#include <algorithm>

namespace spacetow {

namespace {

TouchEvent touchEvent(const Bodies& bodies, std::uint64_t bodyPair, int iteration) {
    auto a = static_cast<Slot>(bodyPair >> 32);
    auto b = static_cast<Slot>(bodyPair & 0xffffffffu);
    if (bodies.records[b].serial < bodies.records[a].serial) {
        std::swap(a, b);
    }
    return {iteration, bodies.idOf(a), bodies.idOf(b), bodies.records[a].tangible && bodies.records[b].tangible};
}

/// All pairs of the same two bodies.
struct Group {
    std::uint64_t bodies = 0;
    std::size_t first = 0, end = 0;
};

Group groupAround(const Contacts& contacts, std::size_t index) {
    const std::vector<Pair>& pairs = contacts.table.pairs;
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

/// What is passed between two iterations begins and ends in the same one.
void report(WorldData& data, const Group& group, int iteration) {
    bool now = false;
    bool passed = false;
    bool before = false;
    for (std::size_t i = group.first; i < group.end; ++i) {
        PairFlags& flags = data.contacts.table.flags[i];
        now |= flags.touching;
        passed |= flags.passed;
        before |= flags.reported;
        flags.reported = flags.touching;
    }
    if (!before && (now || passed)) {
        data.events.began.push_back(touchEvent(data.bodies, group.bodies, iteration));
    }
    if (!now && (before || passed)) {
        data.events.ended.push_back(touchEvent(data.bodies, group.bodies, iteration));
    }
}

/// Pairs whose boxes have parted are no longer in the table. Where others of the same bodies are, these may still
/// touch: one of them takes the place of what was dropped.
void reportDropped(WorldData& data, int iteration) {
    std::vector<std::uint64_t>& dropped = data.scratch.changes.droppedTouches;
    std::sort(dropped.begin(), dropped.end());
    dropped.erase(std::unique(dropped.begin(), dropped.end()), dropped.end());
    for (const std::uint64_t bodyPair : dropped) {
        const auto found =
            std::lower_bound(data.contacts.table.pairs.begin(), data.contacts.table.pairs.end(), bodyPair,
                             [](const Pair& pair, std::uint64_t key) { return pair.bodies() < key; });
        if (found != data.contacts.table.pairs.end() && found->bodies() == bodyPair) {
            data.contacts.table.flags[static_cast<std::size_t>(found - data.contacts.table.pairs.begin())].reported =
                true;
        } else {
            data.events.ended.push_back(touchEvent(data.bodies, bodyPair, iteration));
        }
    }
    dropped.clear();
}

void reportChanged(WorldData& data, int iteration) {
    for (std::size_t i = 0; i < data.contacts.table.size(); ++i) {
        const PairFlags& flags = data.contacts.table.flags[i];
        if (flags.touching != flags.reported || flags.passed) {
            const Group group = groupAround(data.contacts, i);
            report(data, group, iteration);
            i = group.end - 1;
        }
    }
}

/// Of pairs of sleepers.
TagMask tagsOfSleepers(const Sleep& sleep, Slot slot) {
    const std::vector<TouchedTags>& all = sleep.touchedTags;
    const auto at = std::lower_bound(all.begin(), all.end(), slot,
                                     [](const TouchedTags& touched, Slot body) { return touched.body < body; });
    return at != all.end() && at->body == slot ? at->tags : TagMask{};
}

/// But for those of sleepers.
void forgetTouchedTags(Bodies& bodies, const Sleep& sleep) {
    for (const Slot slot : bodies.moving) {
        bodies.touchedTags[slot] = TagMask{};
    }
    for (const Slot slot : bodies.tagged) {
        bodies.touchedTags[slot] = tagsOfSleepers(sleep, slot);
    }
    bodies.tagged.clear();
}

/// Calls `visit(body, tags)` for both bodies of the pairs of the table that touch.
template <class Visit>
void forTouching(const Bodies& bodies, const PairTable& table, const Visit& visit) {
    for (std::size_t i = 0; i < table.size(); ++i) {
        if (table.flags[i].touching || table.flags[i].passed) {
            const Pair& pair = table.pairs[i];
            visit(pair.bodyA, bodies.records[pair.bodyB].filter.tags);
            visit(pair.bodyB, bodies.records[pair.bodyA].filter.tags);
        }
    }
}

} // namespace

void reportTouches(WorldData& data, int iteration) {
    reportDropped(data, iteration);
    reportChanged(data, iteration);
    if (data.bodies.reporters.empty()) {
        return;
    }
    collectTouchedTags(data.bodies, data.contacts, data.sleep);
    for (const Slot slot : data.bodies.reporters) {
        if (data.bodies.touchedTags[slot].bits != 0) {
            data.events.tagsTouched.push_back({iteration, data.bodies.idOf(slot), data.bodies.touchedTags[slot]});
        }
    }
}

void joinTagReports(Events& events, std::size_t first) {
    std::vector<TagsTouchedEvent>& reports = events.tagsTouched;
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

void collectTouchedTags(Bodies& bodies, const Contacts& contacts, const Sleep& sleep) {
    forgetTouchedTags(bodies, sleep);
    if (bodies.tagged.capacity() < 2 * contacts.table.size()) {
        bodies.tagged.reserve(2 * contacts.table.capacity());
    }
    forTouching(bodies, contacts.table, [&](Slot slot, TagMask tags) {
        bodies.touchedTags[slot] = bodies.touchedTags[slot] | tags;
        const BodyRecord& record = bodies.records[slot];
        if (record.kind == BodyKind::Static || record.asleep) {
            bodies.tagged.push_back(slot);
        }
    });
}

void relistTouchedTags(Bodies& bodies, Sleep& sleep) {
    std::vector<TouchedTags>& all = sleep.touchedTags;
    const auto note = [&] {
        for (const TouchedTags& touched : all) {
            bodies.tagged.push_back(touched.body);
        }
    };
    note();
    all.clear();
    forTouching(bodies, sleep.table, [&](Slot slot, TagMask tags) { all.push_back({slot, tags}); });
    std::stable_sort(all.begin(), all.end(),
                     [](const TouchedTags& a, const TouchedTags& b) { return a.body < b.body; });
    std::size_t count = 0;
    for (const TouchedTags& touched : all) {
        if (count > 0 && all[count - 1].body == touched.body) {
            all[count - 1].tags = all[count - 1].tags | touched.tags;
        } else {
            all[count++] = touched;
        }
    }
    all.resize(count);
    note();
    bodies.tagged.insert(bodies.tagged.end(), bodies.nonStatic.begin(), bodies.nonStatic.end());
}

void endTouches(WorldData& data, Slot slot, int iteration) {
    releaseConstraints(data.contacts, data.constraints, data.flags);
    for (std::size_t i = 0; i < data.contacts.table.size(); ++i) {
        const Pair& pair = data.contacts.table.pairs[i];
        if (pair.bodyA == slot || pair.bodyB == slot) {
            for (const Group group = groupAround(data.contacts, i); i < group.end; ++i) {
                data.contacts.table.flags[i].touching = data.contacts.table.flags[i].passed = false;
                freeContact(data.contacts, data.scratch.narrow, data.contacts.table.pairs[i]);
            }
            --i;
            report(data, groupAround(data.contacts, i), iteration);
        }
    }
}

} // namespace spacetow
