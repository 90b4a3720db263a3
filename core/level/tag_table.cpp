#include "core/level/tag_table.h"

namespace spacetow {

TagTable::TagTable() {
    // Apart in lightness as well as in hue, so that they stay apart for colour-blind eyes.
    m_tags[wallTag] = {"wall", 0x8a9bb0};
    m_tags[shipTag] = {"ship", 0x4cc9f0};
    m_tags[payloadTag] = {"payload", 0xffb703};
    m_tags[finishTag] = {"finish", 0x80ed99};
    m_tags[debrisTag] = {"debris", 0xd66ba0};
}

TagTable TagTable::empty() {
    TagTable table;
    table.m_tags.fill({});
    return table;
}

std::optional<int> TagTable::indexOf(std::string_view name) const {
    for (int i = 0; i < size; ++i) {
        if (!name.empty() && (*this)[i].name == name) {
            return i;
        }
    }
    return {};
}

TagMask TagTable::named() const {
    TagMask mask;
    for (int i = 0; i < size; ++i) {
        if (!(*this)[i].name.empty()) {
            mask = mask | TagMask::bit(i);
        }
    }
    return mask;
}

} // namespace spacetow
