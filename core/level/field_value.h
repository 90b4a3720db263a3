#pragma once
// The value of one field of an object or of the level, whatever its type. In the units of the file.

#include "core/level/level.h"

#include <optional>
#include <string>
#include <variant>

namespace spacetow {

/// Of an enumeration: the position among its spellings.
struct Choice {
    int index = 0;

    bool operator==(const Choice&) const = default;
};
/// Without a value: a depth without end, a mass that comes from the shapes, no parent, no colour.
struct Unset {
    bool operator==(const Unset&) const = default;
};
/// Of another object.
struct KeyValue {
    Key key = 0;

    bool operator==(const KeyValue&) const = default;
};
struct ColorValue {
    std::uint32_t rgb = 0; // 0xRRGGBB

    bool operator==(const ColorValue&) const = default;
};
/// How many vertices a shape has; the vertices themselves are edited on the canvas.
struct PointCount {
    int count = 0;

    bool operator==(const PointCount&) const = default;
};

using FieldValue = std::variant<Unset, double, bool, Choice, std::string, TagMask, KeyValue, ColorValue, PointCount>;

} // namespace spacetow
