#pragma once
// Tags and filters: which bodies may touch which.

#include <cstdint>

namespace spacetow {

/// A set of up to 32 tags, one a bit.
struct TagMask {
    std::uint32_t bits = 0;

    static constexpr TagMask all() { return {0xffffffffu}; }
    static constexpr TagMask bit(int index) { return {std::uint32_t{1} << index}; } // index 0 … 31

    constexpr bool intersects(TagMask other) const { return (bits & other.bits) != 0; }
    constexpr bool contains(int index) const { return (bits >> index & 1u) != 0; }
    constexpr TagMask operator|(TagMask other) const { return {bits | other.bits}; }
    constexpr bool operator==(const TagMask&) const = default;
};

/// What a body is, and what it touches. A body without tags is touched by nothing.
struct Filter {
    TagMask tags{1};
    TagMask touches = TagMask::all();

    constexpr bool operator==(const Filter&) const = default;
};

/// A pair meets when each one's `touches` meets the other's `tags`.
constexpr bool mayTouch(const Filter& a, const Filter& b) {
    return a.touches.intersects(b.tags) && b.touches.intersects(a.tags);
}

} // namespace spacetow
