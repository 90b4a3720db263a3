#include "core/physics/sleep/touches.h"

#include "core/base/sort_unique.h"
#include "core/physics/broad_phase/collision_rules.h"
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
    return {iteration, bodies.idOf(a), bodies.idOf(b), areTangible(bodies, a, b)};
}

/// The range of the pair table with all pairs of the same two bodies.
struct Group {
    std::uint64_t bodies = 0; // Pair::bodies()
    std::size_t first = 0, end = 0;
};

Group groupAround(const Contacts& contacts, std::size_t index) {
    const std::vector<Pair>& pairs = contacts.table.pairs;
    const std::uint64_t bodies = pairs[index].key().bodies();
    Group group{bodies, index, index + 1};
    while (group.first > 0 && pairs[group.first - 1].key().bodies() == bodies) {
        --group.first;
    }
    while (group.end < pairs.size() && pairs[group.end].key().bodies() == bodies) {
        ++group.end;
    }
    return group;
}

/// Adds the events of two bodies. A touch that `passed` within the iteration begins and ends in it.
void report(const TouchStage& stage, const Group& group, int iteration) {
    bool now = false;
    bool passed = false;
    bool before = false;
    for (std::size_t i = group.first; i < group.end; ++i) {
        PairFlags& flags = stage.contacts.table.flags[i];
        now |= flags.touching;
        passed |= flags.passed;
        before |= flags.reported;
        flags.reported = flags.touching;
    }
    if (!before && (now || passed)) {
        stage.events.began.push_back(touchEvent(stage.bodies, group.bodies, iteration));
    }
    if (!now && (before || passed)) {
        stage.events.ended.push_back(touchEvent(stage.bodies, group.bodies, iteration));
    }
}

/// Ends the touches of dropped pairs. If other pairs of the same bodies are in the table, the bodies may still touch:
/// one of these pairs counts as reported instead.
void reportDropped(const TouchStage& stage, int iteration) {
    std::vector<std::uint64_t>& dropped = stage.changes.droppedTouches;
    sortUnique(dropped);
    for (const std::uint64_t bodyPair : dropped) {
        PairTable& table = stage.contacts.table;
        const std::size_t found = table.firstFrom(bodyPair);
        if (found < table.size() && table.pairs[found].key().bodies() == bodyPair) {
            table.flags[found].reported = true;
        } else {
            stage.events.ended.push_back(touchEvent(stage.bodies, bodyPair, iteration));
        }
    }
    dropped.clear();
}

void reportChanged(const TouchStage& stage, int iteration) {
    for (std::size_t i = 0; i < stage.contacts.table.size(); ++i) {
        const PairFlags& flags = stage.contacts.table.flags[i];
        if (flags.touching != flags.reported || flags.passed) {
            const Group group = groupAround(stage.contacts, i);
            report(stage, group, iteration);
            i = group.end - 1;
        }
    }
}

/// The tags that a body touches by sleeping pairs.
TagMask tagsOfSleepers(const Sleep& sleep, Slot slot) {
    const std::vector<TouchedTags>& all = sleep.touchedTags;
    const auto at = std::lower_bound(all.begin(), all.end(), slot,
                                     [](const TouchedTags& touched, Slot body) { return touched.body < body; });
    return at != all.end() && at->body == slot ? at->tags : TagMask{};
}

/// Resets the touched tags to those of sleeping pairs.
void forgetTouchedTags(Bodies& bodies, const Sleep& sleep) {
    for (const Slot slot : bodies.moving) {
        bodies.touchedTags[slot] = TagMask{};
    }
    for (const Slot slot : bodies.taggedAtRest) {
        bodies.touchedTags[slot] = tagsOfSleepers(sleep, slot);
    }
    bodies.taggedAtRest.clear();
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

Slot bodySlot(const TagsTouchedEvent& report) {
    return report.body.index;
}
Slot bodySlot(const TouchedTags& touched) {
    return touched.body;
}

/// Sorts the entries from index `first` on by body, and joins those of the same body.
template <class Entry>
void joinTags(std::vector<Entry>& entries, std::size_t first) {
    const auto begin = entries.begin() + static_cast<std::ptrdiff_t>(first);
    std::stable_sort(begin, entries.end(), [](const Entry& a, const Entry& b) { return bodySlot(a) < bodySlot(b); });
    std::size_t count = first;
    for (std::size_t i = first; i < entries.size(); ++i) {
        if (count > first && bodySlot(entries[count - 1]) == bodySlot(entries[i])) {
            entries[count - 1].tags = entries[count - 1].tags | entries[i].tags;
        } else {
            entries[count++] = entries[i];
        }
    }
    entries.resize(count);
}

} // namespace

void reportTouches(const TouchStage& stage, int iteration) {
    reportDropped(stage, iteration);
    reportChanged(stage, iteration);
    if (stage.bodies.reporters.empty()) {
        return;
    }
    collectTouchedTags(stage.bodies, stage.contacts, stage.sleep);
    for (const Slot slot : stage.bodies.reporters) {
        if (stage.bodies.touchedTags[slot].bits != 0) {
            stage.events.tagsTouched.push_back({iteration, stage.bodies.idOf(slot), stage.bodies.touchedTags[slot]});
        }
    }
}

void joinTagReports(Events& events, std::size_t first) {
    joinTags(events.tagsTouched, first);
}

void collectTouchedTags(Bodies& bodies, const Contacts& contacts, const Sleep& sleep) {
    forgetTouchedTags(bodies, sleep);
    if (bodies.taggedAtRest.capacity() < 2 * contacts.table.size()) {
        bodies.taggedAtRest.reserve(2 * contacts.table.capacity());
    }
    forTouching(bodies, contacts.table, [&](Slot slot, TagMask tags) {
        bodies.touchedTags[slot] = bodies.touchedTags[slot] | tags;
        const BodyRecord& record = bodies.records[slot];
        if (record.kind == BodyKind::Static || record.asleep) {
            bodies.taggedAtRest.push_back(slot);
        }
    });
}

void relistTouchedTags(Bodies& bodies, Sleep& sleep) {
    std::vector<TouchedTags>& all = sleep.touchedTags;
    const auto note = [&] {
        for (const TouchedTags& touched : all) {
            bodies.taggedAtRest.push_back(touched.body);
        }
    };
    note();
    all.clear();
    forTouching(bodies, sleep.table, [&](Slot slot, TagMask tags) { all.push_back({slot, tags}); });
    joinTags(all, 0);
    note();
    bodies.taggedAtRest.insert(bodies.taggedAtRest.end(), bodies.nonStatic.begin(), bodies.nonStatic.end());
}

void endTouches(const TouchStage& stage, NarrowPhase& narrow, Slot slot, int iteration) {
    PairTable& table = stage.contacts.table;
    for (std::size_t i = 0; i < table.size(); ++i) {
        const Pair& pair = table.pairs[i];
        if (pair.bodyA == slot || pair.bodyB == slot) {
            for (const Group group = groupAround(stage.contacts, i); i < group.end; ++i) {
                table.flags[i].touching = table.flags[i].passed = false;
                freeContact(stage.contacts, narrow, table.pairs[i]);
            }
            --i;
            report(stage, groupAround(stage.contacts, i), iteration);
        }
    }
}

} // namespace spacetow
