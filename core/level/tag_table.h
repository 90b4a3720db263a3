#pragma once
// Names and colours of the 32 tags of a level. Files store names, so that renumbering never shows in a diff.

#include "core/physics/def/tags.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace spacetow {

struct TagInfo {
    std::string name;               // empty: the tag is not in use; unique among those in use
    std::uint32_t color = 0x808080; // 0xRRGGBB

    bool operator==(const TagInfo&) const = default;
};

/// A new table names the tags that SpaceTow itself uses, see `wallTag` and its neighbours.
class TagTable {
  public:
    static constexpr int size = 32;

    TagTable();
    /// A table without any name.
    static TagTable empty();

    const TagInfo& operator[](int index) const { return m_tags[static_cast<std::size_t>(index)]; }
    void set(int index, TagInfo info) { m_tags[static_cast<std::size_t>(index)] = std::move(info); }
    std::optional<int> indexOf(std::string_view name) const;
    /// The tags that have a name.
    TagMask named() const;

    bool operator==(const TagTable&) const = default;

  private:
    std::array<TagInfo, size> m_tags;
};

// The tags of the game (facts of the original: WORLD, SHIP, PAYLOAD, FINISH_LINE, DECORATIVE).
constexpr int wallTag = 0;
constexpr int shipTag = 1;
constexpr int payloadTag = 2;
constexpr int finishTag = 3;
constexpr int debrisTag = 4;

} // namespace spacetow
