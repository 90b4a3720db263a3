#include "editor/editing/typed_entry.h"

#include "core/base/expression.h"
#include "core/math/affine.h"
#include "editor/editing/snap.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>

namespace spacetow {

namespace {

constexpr double radiansPerDegree = std::numbers::pi / 180;

bool isBlank(std::string_view text) {
    return text.find_first_not_of(" \t") == std::string_view::npos;
}

const char* unitOf(TypedKind kind, int field) {
    if (isTypedAngle(kind, field)) {
        return "°";
    }
    return kind == TypedKind::SpeedAngle ? "m/s" : "m";
}

/// Unit vector; exact where the angle is a multiple of 15°, so that the points of a grid stay on it.
Vec2 directionAt(double radians) {
    const Vec2 rough(std::cos(radians), std::sin(radians));
    const Vec2 exact = snappedDirection(rough);
    return (exact - rough).norm() < 1e-12 ? exact : rough;
}

void read(TypedEntry& entry, int field) {
    const std::string& text = entry.texts[static_cast<std::size_t>(field)];
    if (isBlank(text) || field >= typedFields(entry.kind)) {
        return;
    }
    const bool angle = isTypedAngle(entry.kind, field);
    const Result<double> number = evaluated(text, unitOf(entry.kind, field));
    const bool tooSmall =
        number && !angle && (number.value() < 0 || (number.value() == 0 && entry.kind != TypedKind::SpeedAngle));
    if (number && !tooSmall) {
        (field == 0 ? entry.values.first : entry.values.second) = number.value() * (angle ? radiansPerDegree : 1);
    } else if (entry.faulty < 0) {
        entry.faulty = field;
        entry.fault = angle ? "typing.no-angle" : tooSmall ? "typing.too-small" : "typing.no-number";
    }
}

} // namespace

TypedEntry typedEntry(TypedKind kind, const std::array<std::string, 2>& texts) {
    TypedEntry entry{kind, texts, {}, -1, {}};
    read(entry, 0);
    read(entry, 1);
    return entry;
}

Vec2 typedPoint(const TypedValues& typed, const Vec2& from, const Vec2& at, double step) {
    if (!typed.any()) {
        return at;
    }
    const Vec2 way = at - from;
    const double distance = way.norm();
    const Vec2 pointed = distance > 0 ? Vec2(way / distance) : Vec2(1, 0);
    const Vec2 along = typed.second ? directionAt(*typed.second) : pointed;
    double length = std::max(0.0, way.dot(along));
    if (step > 0) {
        length = std::round(length / step) * step;
    }
    return tidied(Vec2(from + typed.first.value_or(length) * along));
}

TypedMeasures polarMeasures(TypedKind kind, const Vec2& way) {
    return {kind, way.norm(), std::atan2(way.y(), way.x())};
}

} // namespace spacetow
