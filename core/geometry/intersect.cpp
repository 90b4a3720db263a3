#include "core/geometry/intersect.h"

#include <algorithm>

namespace spacetow {

namespace {

/// Where the collinear segments a…b and c…d first share a point, as a fraction of a → b.
std::optional<double> collinearFraction(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
    const Vec2 ab = b - a;
    const double lengthSquared = ab.squaredNorm();
    if (lengthSquared == 0) {
        return (closestOnSegment(c, d, a) - a).squaredNorm() == 0 ? std::optional<double>(0) : std::nullopt;
    }
    const double s = ab.dot(c - a) / lengthSquared;
    const double t = ab.dot(d - a) / lengthSquared;
    const double low = std::max(0.0, std::min(s, t));
    const double high = std::min(1.0, std::max(s, t));
    return low <= high ? std::optional<double>(low) : std::nullopt;
}

/// −1, 0 or 1: on which side of the line through c and d the point p lies.
int sideOf(const Vec2& c, const Vec2& d, const Vec2& p) {
    const double side = cross(d - c, p - c);
    return (side > 0) - (side < 0);
}

} // namespace

Vec2 closestOnSegment(const Vec2& a, const Vec2& b, const Vec2& p) {
    const Vec2 ab = b - a;
    const double lengthSquared = ab.squaredNorm();
    if (!(lengthSquared > 0)) {
        return a;
    }
    const double t = ab.dot(p - a) / lengthSquared;
    if (t <= 0) {
        return a;
    }
    return t >= 1 ? b : Vec2(a + t * ab);
}

bool segmentsMeet(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
    return segmentFraction(a, b, c, d).has_value();
}

std::optional<double> segmentFraction(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
    const int sideA = sideOf(c, d, a);
    const int sideB = sideOf(c, d, b);
    if (sideA == 0 && sideB == 0) {
        // A segment c…d without length has every point on its line: whether a…b passes through it decides.
        return c == d && sideOf(a, b, c) != 0 ? std::nullopt : collinearFraction(a, b, c, d);
    }
    if (sideA * sideB > 0 || sideOf(a, b, c) * sideOf(a, b, d) > 0) {
        return std::nullopt;
    }
    const double along = cross(c - a, d - c);
    const double whole = cross(b - a, d - c);
    return std::clamp(along / whole, 0.0, 1.0);
}

std::optional<Vec2> segmentIntersection(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
    const auto fraction = segmentFraction(a, b, c, d);
    return fraction ? std::optional<Vec2>(a + *fraction * (b - a)) : std::nullopt;
}

// Clips the segment against the four sides of the box (Liang and Barsky, 1984).
bool segmentMeets(const Vec2& a, const Vec2& b, const Aabb& box) {
    double enters = 0;
    double leaves = 1;
    for (int axis = 0; axis < 2; ++axis) {
        const double way = b[axis] - a[axis];
        if (way == 0) {
            if (a[axis] < box.min[axis] || a[axis] > box.max[axis]) {
                return false;
            }
            continue;
        }
        const double first = (box.min[axis] - a[axis]) / way;
        const double second = (box.max[axis] - a[axis]) / way;
        enters = std::max(enters, std::min(first, second));
        leaves = std::min(leaves, std::max(first, second));
    }
    return enters <= leaves;
}

} // namespace spacetow
