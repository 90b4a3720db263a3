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

inline Vec2 operator*(const Rot& r, const Vec2& v) { return {r.c * v.x() - r.s * v.y(), r.s * v.x() + r.c * v.y()}; }
inline Rot operator*(const Rot& a, const Rot& b) { return {a.c * b.c - a.s * b.s, a.s * b.c + a.c * b.s}; }

/// `r` turned on by `radians`, with the length brought back to one.
inline Rot turned(const Rot& r, double radians) {
    const Rot t = Rot::fromAngle(radians) * r;
    const double scale = 1 / std::sqrt(t.c * t.c + t.s * t.s);
    return {t.c * scale, t.s * scale};
}

} // namespace spacetow
