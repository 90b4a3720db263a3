#pragma once
// Numbers that are typed while something is drawn, in place of being pointed at: length and angle of the next segment,
// width and height of a rectangle. What is typed is kept as text; what has not been typed is left to the pointer.

#include "core/math/vec.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>

namespace spacetow {

/// What the two fields are; a radius has but one.
enum class TypedKind : std::uint8_t { LengthAngle, SpeedAngle, WidthHeight, Radius };

constexpr int typedFields(TypedKind kind) {
    return kind == TypedKind::Radius ? 1 : 2;
}
constexpr bool isTypedAngle(TypedKind kind, int field) {
    return field == 1 && (kind == TypedKind::LengthAngle || kind == TypedKind::SpeedAngle);
}

/// What the pointer says of that which could be typed.
struct TypedMeasures {
    TypedKind kind = TypedKind::LengthAngle;
    double first = 0;  // m or m/s
    double second = 0; // m, or rad

    bool operator==(const TypedMeasures&) const = default;
};

/// The fields that hold a number, in the same units.
struct TypedValues {
    std::optional<double> first, second;

    bool any() const { return first || second; }
    bool operator==(const TypedValues&) const = default;
};

struct TypedEntry {
    TypedKind kind = TypedKind::LengthAngle;
    std::array<std::string, 2> texts; // UTF-8 with ASCII digits
    TypedValues values;
    int faulty = -1;   // the first field with a text that will not do; −1 for none
    std::string fault; // code of the hint that says why, with the text as its argument
};

/// Reads the texts, which are expressions in metres, metres a second or degrees. Sizes must be more than nothing.
TypedEntry typedEntry(TypedKind kind, const std::array<std::string, 2>& texts);

/// `at` with length and angle as seen from `from` replaced by what has been typed. With an angle alone the length is
/// the pointer's way along it, in whole `steps` unless that is 0.
Vec2 typedPoint(const TypedValues& typed, const Vec2& from, const Vec2& at, double step);
/// Length and angle of the way, for TypedMeasures.
TypedMeasures polarMeasures(TypedKind kind, const Vec2& way);

} // namespace spacetow
