#pragma once
// Stretches of straight lines, with ends or infinite: closest points and crossings. Metres.

#include "core/math/vec.h"

#include <algorithm>
#include <limits>
#include <optional>

namespace spacetow {

constexpr double sameStretch = 1e-9; // m: points no further beyond an end count as on the stretch

/// An infinite line.
struct StraightLine {
    Vec2 through{0, 0};
    Vec2 along{1, 0}; // unit
};

struct Stretch {
    StraightLine line;
    double from = 0; // m along the line, from `through`; infinite where there is no end
    double to = 0;

    /// A segment without length is a point.
    static Stretch between(const Vec2& a, const Vec2& b) {
        const double length = (b - a).norm();
        return {{a, length > 0 ? Vec2((b - a) / length) : Vec2(1, 0)}, 0, length};
    }
    static Stretch endless(const Vec2& through, const Vec2& along) {
        constexpr double end = std::numeric_limits<double>::infinity();
        return {{through, along}, -end, end};
    }

    /// The coordinate along the line, m, of the point projected on it.
    double along(const Vec2& point) const { return (point - line.through).dot(line.along); }
    bool reaches(double metres) const { return from - sameStretch <= metres && metres <= to + sameStretch; }
    Vec2 at(double metres) const { return line.through + metres * line.along; }
    Vec2 nearest(const Vec2& point) const { return at(std::clamp(along(point), from, to)); }
    double distanceTo(const Vec2& point) const { return (nearest(point) - point).norm(); }
};

/// Where two stretches cross; nothing when they are parallel.
inline std::optional<Vec2> crossing(const Stretch& a, const Stretch& b) {
    const double turn = cross(a.line.along, b.line.along);
    constexpr double parallel = 1e-9; // rad
    if (std::abs(turn) < parallel) {
        return {};
    }
    const double metres = cross(Vec2(b.line.through - a.line.through), b.line.along) / turn;
    const Vec2 point = a.at(metres);
    return a.reaches(metres) && b.reaches(b.along(point)) ? std::optional(point) : std::nullopt;
}

} // namespace spacetow
