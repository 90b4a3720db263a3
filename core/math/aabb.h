#pragma once
// Axis-aligned bounding boxes. A default box is empty: it overlaps nothing and grows from the first point on.

#include "core/math/vec.h"

#include <limits>

namespace spacetow {

struct Aabb {
    Vec2 min{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    Vec2 max{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};

    bool isEmpty() const { return !(min.x() <= max.x() && min.y() <= max.y()); }
    Vec2 center() const { return 0.5 * (min + max); }
    Vec2 size() const { return max - min; }

    void include(const Vec2& p) {
        min = min.cwiseMin(p);
        max = max.cwiseMax(p);
    }
    void include(const Aabb& other) {
        min = min.cwiseMin(other.min);
        max = max.cwiseMax(other.max);
    }
    /// The box with each side moved out by `margin` metres.
    Aabb grown(double margin) const { return {min - Vec2(margin, margin), max + Vec2(margin, margin)}; }

    /// Borders count: boxes that only touch overlap.
    bool overlaps(const Aabb& o) const {
        return min.x() <= o.max.x() && o.min.x() <= max.x() && min.y() <= o.max.y() && o.min.y() <= max.y();
    }
    bool contains(const Vec2& p) const {
        return min.x() <= p.x() && p.x() <= max.x() && min.y() <= p.y() && p.y() <= max.y();
    }
    bool contains(const Aabb& o) const {
        return min.x() <= o.min.x() && o.max.x() <= max.x() && min.y() <= o.min.y() && o.max.y() <= max.y();
    }

    bool operator==(const Aabb&) const = default;
};

} // namespace spacetow
