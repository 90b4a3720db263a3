#include "core/game/tag_touches.h"

#include "core/physics/query/masked_meetings.h"

namespace spacetow {

void TagTouches::add(Table& table, TagMask a, TagMask b) {
    for (int tag = 0; tag < static_cast<int>(table.size()); ++tag) {
        TagMask& row = table[static_cast<std::size_t>(tag)];
        row = a.contains(tag) ? row | b : row;
        row = b.contains(tag) ? row | a : row;
    }
}

void TagTouches::note(const World& world, bool meetings) {
    for (const TouchEvent& began : world.events().began) {
        if (world.contains(began.a) && world.contains(began.b)) {
            add(m_touched, world.body(began.a).filter.tags, world.body(began.b).filter.tags);
        }
    }
    if (!meetings) {
        return;
    }
    for (const auto& [a, b] : maskedMeetings(world)) {
        add(m_passed, world.body(a).filter.tags, world.body(b).filter.tags);
    }
}

} // namespace spacetow
