#pragma once
// How a set of tags is told: by those that are in it, or by those that are not.

#include "core/physics/def/tags.h"

#include <bit>

namespace spacetow {

/// Whether a mask is told by the tags that it leaves out, as in "everything but debris": whichever list is shorter. So
/// tags that nobody has named yet are in neither.
constexpr bool isSpelledByExceptions(TagMask mask) {
    return 2 * std::popcount(mask.bits) > 32;
}

} // namespace spacetow
