#pragma once
// A rotation as a unit complex number: it never grows, and turning a vector needs no trigonometry.

#include "core/math/trig.h"
#include "core/math/vec.h"

#include <cmath>

namespace spacetow {

/// Angle 0 is the identity; positive angles turn anticlockwise.
struct Rot {
    double c = 1; // cosine
    double s = 0; // sine

    static Rot fromAngle(double radians) {
        const SinCos sc = sinCos(radians);
        return {sc.cos, sc.sin};
    }

    /// In (−π, π].
    double angle() const { return arcTangent(s, c); }
    Vec2 right() const { return {c, s}; }
    Vec2 up() const { return {-s, c}; }
    Rot inverse() const { return {c, -s}; }

    bool operator==(const Rot&) const = default;
};

inline Vec2 operator*(const Rot& r, const Vec2& v) {
    return {r.c * v.x() - r.s * v.y(), r.s * v.x() + r.c * v.y()};
}
inline Rot operator*(const Rot& a, const Rot& b) {
    return {a.c * b.c - a.s * b.s, a.s * b.c + a.c * b.s};
}

/// The rotation by a small angle: Taylor's series, exact to the last bits up to an eighth.
inline Rot smallTurn(double radians) {
    const double x2 = radians * radians;
    const double s =
        radians * (1 - x2 * (1.0 / 6) * (1 - x2 * (1.0 / 20) * (1 - x2 * (1.0 / 42) * (1 - x2 * (1.0 / 72)))));
    const double c = 1 - x2 * 0.5 * (1 - x2 * (1.0 / 12) * (1 - x2 * (1.0 / 30) * (1 - x2 * (1.0 / 56))));
    return {c, s};
}

/// `r` turned on by `radians`, with the length brought back to one by a step of Newton's method for 1/√.
inline Rot turned(const Rot& r, double radians) {
    const Rot t = (std::abs(radians) <= 0.125 ? smallTurn(radians) : Rot::fromAngle(radians)) * r;
    const double scale = 1.5 - 0.5 * (t.c * t.c + t.s * t.s);
    return {t.c * scale, t.s * scale};
}

} // namespace spacetow
