#pragma once
// Arrays: many copies of some objects, in a row or round a centre. World coordinates, m, radians.

#include "core/level/level.h"
#include "core/math/affine.h"

#include <cstdint>
#include <optional>
#include <span>
#include <variant>
#include <vector>

namespace spacetow {

/// Each copy stands `step` from the one before.
struct LinearArray {
    int copies = 3; // beside the originals
    Vec2 step{1, 0};

    bool operator==(const LinearArray&) const = default;
};

/// Each copy stands `angle` further round `center`, anticlockwise.
struct RadialArray {
    int copies = 5; // beside the originals
    double angle = 1.0471975511965976;
    Vec2 center{0, 0};
    bool turns = true; // the copies turn as well

    bool operator==(const RadialArray&) const = default;
};

using ArraySpec = std::variant<LinearArray, RadialArray>;

constexpr int maxArrayObjects = 20'000; // that one array may add

struct ArrayPlace {
    ArraySpec spec;
    std::uint64_t seed; // of the keys of the copies
};

/// How many objects the array would add: none of a ship, a payload and a finish.
std::int64_t arraySize(const Level& level, std::span<const Key> keys, const ArraySpec& spec);

/// With fresh keys, groups and connectors as `duplicated` has them, drawn above everything. The keys
/// of the copies, without members of groups that are copied, come out in `copies`. The array is no larger than
/// maxArrayObjects.
Level arrayed(Level level, std::span<const Key> keys, const ArrayPlace& place, std::vector<Key>& copies);

} // namespace spacetow
