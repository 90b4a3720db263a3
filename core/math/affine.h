#pragma once
// Affine maps of the plane: move, rotate, scale, shear, mirror, and what they make together.

#include "core/math/rot.h"

#include <cmath>

namespace spacetow {

/// p ↦ origin + (p.x · x + p.y · y): where the axes go, and where the origin goes.
struct Affine {
    Vec2 x{1, 0};
    Vec2 y{0, 1};
    Vec2 origin{0, 0};

    Vec2 operator()(const Vec2& point) const { return origin + linear(point); }
    /// Of a difference of points: without the translation.
    Vec2 linear(const Vec2& vector) const { return vector.x() * x + vector.y() * y; }
    /// How areas grow; negative when left and right change places.
    double determinant() const { return cross(x, y); }

    static Affine translation(const Vec2& delta) { return {{1, 0}, {0, 1}, delta}; }
    /// The map that does `x` and `y` and leaves `pivot` where it is.
    static Affine about(const Vec2& pivot, const Vec2& x, const Vec2& y) {
        const Affine linear{x, y};
        return {x, y, pivot - linear.linear(pivot)};
    }
    /// Anticlockwise. Quarter turns are exact.
    static Affine rotation(const Vec2& pivot, double radians);
    static Affine scaling(const Vec2& pivot, const Vec2& factors) {
        return about(pivot, {factors.x(), 0}, {0, factors.y()});
    }
};

/// First `b`, then `a`.
inline Affine operator*(const Affine& a, const Affine& b) {
    return {a.linear(b.x), a.linear(b.y), a(b.origin)};
}

inline Affine Affine::rotation(const Vec2& pivot, double radians) {
    constexpr double quarter = 1.5707963267948966;
    const double quarters = std::round(radians / quarter);
    Rot turn = Rot::fromAngle(radians);
    if (std::abs(radians - quarters * quarter) < 1e-12) {
        turn = {std::round(turn.c), std::round(turn.s)};
    }
    return about(pivot, {turn.c, turn.s}, {-turn.s, turn.c});
}

/// The decimal number of nine places that `value` misses by rounding errors only, else `value`. Edits hand out what
/// they compute through this function, so that what was on the grid stays on it to the last bit.
inline double tidied(double value) {
    constexpr double places = 1e9;
    const double decimal = std::round(value * places) / places;
    return std::abs(value - decimal) <= 1e-12 * std::fmax(1.0, std::abs(value)) ? decimal + 0.0 : value;
}
inline Vec2 tidied(const Vec2& value) {
    return {tidied(value.x()), tidied(value.y())};
}

} // namespace spacetow
