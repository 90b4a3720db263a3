#include "editor/editing/outline_faults.h"

#include "core/geometry/intersect.h"

#include <algorithm>
#include <cmath>

namespace spacetow {

bool isFlat(std::span<const Vec2> outline) {
    constexpr double flatShare = 1e-9; // of the extent: what is nearer to a line lies on it
    // The area would not tell: that of a bow tie is zero too.
    Vec2 way(0, 0);
    for (const Vec2& point : outline) {
        const Vec2 other = point - outline.front();
        way = other.squaredNorm() > way.squaredNorm() ? other : way;
    }
    return std::ranges::all_of(outline, [&](const Vec2& point) {
        return std::abs(cross(way, point - outline.front())) <= flatShare * way.squaredNorm();
    });
}

bool crossesEarlier(std::span<const Vec2> points, const Vec2& next) {
    const std::size_t count = points.size();
    if (count < 2 || next == points.back()) {
        return false;
    }
    for (std::size_t i = 0; i + 2 < count; ++i) {
        if (segmentsMeet(points[i], points[i + 1], points[count - 1], next)) {
            return true;
        }
    }
    // The side before shares its end; it clashes when this one runs back over it.
    const Vec2 back = points[count - 2] - points[count - 1];
    const Vec2 on = next - points[count - 1];
    return cross(back, on) == 0 && back.dot(on) > 0;
}

} // namespace spacetow
