#pragma once
// Tags and collision filters: which bodies may touch each other.

#include <cstdint>

namespace spacetow {

/// A set of up to 32 tags; bit i is tag i.
struct TagMask {
    std::uint32_t bits = 0;

    static constexpr TagMask all() { return {0xffffffffu}; }
    static constexpr TagMask bit(int index) { return {std::uint32_t{1} << index}; } // index 0 … 31

    constexpr bool intersects(TagMask other) const { return (bits & other.bits) != 0; }
    constexpr bool contains(int index) const { return (bits >> index & 1u) != 0; }
    constexpr TagMask operator|(TagMask other) const { return {bits | other.bits}; }
    constexpr bool operator==(const TagMask&) const = default;
};

/// Category bits and mask bits of a body. A body without tags touches nothing.
struct Filter {
    TagMask tags{1};
    TagMask touches = TagMask::all();

    constexpr bool operator==(const Filter&) const = default;
};

/// Whether the mask (`touches`) of each body has one of the other's categories (`tags`).
constexpr bool mayTouch(const Filter& a, const Filter& b) {
    return a.touches.intersects(b.tags) && b.touches.intersects(a.tags);
}

} // namespace spacetow
