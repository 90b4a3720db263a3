#pragma once
// Vectors in the plane, in metres unless said otherwise; y is up. The only include of Eigen.

#include <Eigen/Core>

#include <cmath>

namespace spacetow {

using Vec2 = Eigen::Vector2d;

/// z component of the cross product; positive when `b` lies anticlockwise of `a`.
inline double cross(const Vec2& a, const Vec2& b) {
    return a.x() * b.y() - a.y() * b.x();
}
/// Velocity of the point `r` of a body that turns with `w` rad/s about the origin.
inline Vec2 cross(double w, const Vec2& r) {
    return {-w * r.y(), w * r.x()};
}
/// `v` turned by 90° anticlockwise: the left side of something that travels along `v`.
inline Vec2 leftOf(const Vec2& v) {
    return {-v.y(), v.x()};
}
/// |x| + |y|: an upper bound of the length without a square root.
inline double oneNorm(const Vec2& v) {
    return std::abs(v.x()) + std::abs(v.y());
}
inline bool isFinite(const Vec2& v) {
    return std::isfinite(v.x()) && std::isfinite(v.y());
}

} // namespace spacetow
