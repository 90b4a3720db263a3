#pragma once
// Handles: an index into an array plus a generation, so that a handle to something removed is recognised
// even after its place has been used again.

#include <compare>
#include <cstdint>

namespace spacetow {

/// `Tag` only keeps handles to different things apart. A default handle refers to nothing.
template <class Tag>
struct Id {
    static constexpr std::uint32_t none = 0xffffffffu;

    std::uint32_t index = none;
    std::uint32_t generation = 0;

    explicit operator bool() const { return index != none; }
    auto operator<=>(const Id&) const = default; // NOLINT(modernize-use-nullptr): clang-tidy 14 sees a 0 in it
};

} // namespace spacetow
