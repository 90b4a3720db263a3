#include "editor/exchange/import_tags.h"

#include "core/level/key_text.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace spacetow {

namespace {

std::string inLowerCase(std::string text) {
    std::ranges::transform(text, text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

/// Apart from each other and from those of the game.
constexpr std::array<std::uint32_t, 8> tagColors{0x56b4e9, 0xe69f00, 0x009e73, 0xcc79a7,
                                                 0xd55e00, 0x0072b2, 0xf0e442, 0x9467bd};

} // namespace

std::string spellableTag(const std::string& name) {
    return unnamedTag(name) >= 0 ? "tag " + name : name;
}

TagMask ImportTags::maskOf(const DrawnItem& item, const std::vector<std::string>& names) {
    TagMask mask = TagMask::bit(wallTag);
    for (const std::string& name : names) {
        const int place = placeOf(name);
        if (place < 0) {
            m_report.refuse("import-tags-full", item.line, name);
        } else {
            mask = mask | TagMask::bit(place);
        }
    }
    return mask;
}

int ImportTags::placeOf(const std::string& given) {
    const std::string name = spellableTag(given);
    const std::string wanted = inLowerCase(name);
    int free = -1;
    for (int tag = 0; tag < TagTable::size; ++tag) {
        const std::string& known = m_table[tag].name;
        if (!known.empty() && inLowerCase(known) == wanted) {
            return tag;
        }
        free = known.empty() && free < 0 ? tag : free;
    }
    if (free >= 0) {
        m_table.set(free, {name, tagColors[static_cast<std::size_t>(free) % tagColors.size()]});
    }
    return free;
}

} // namespace spacetow
