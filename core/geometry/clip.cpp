#include "core/geometry/clip.h"

namespace spacetow {

ClippedSegment clipToFace(const Vec2& start, const Vec2& direction, double length, const std::array<Vec2, 2>& segment) {
    ClippedSegment result;
    const std::array<double, 2> t{direction.dot(segment[0] - start), direction.dot(segment[1] - start)};
    if (std::max(t[0], t[1]) < 0 || std::min(t[0], t[1]) > length) {
        return result;
    }
    const Vec2 along = segment[1] - segment[0];
    const double span = t[1] - t[0];
    for (std::size_t i = 0; i < 2; ++i) {
        ClippedPoint& clipped = result.points[i];
        clipped.point = segment[i];
        if (t[i] < 0 || t[i] > length) {
            clipped.cutAt = t[i] < 0 ? 0 : 1;
            clipped.point = segment[0] + ((clipped.cutAt == 0 ? 0 : length) - t[0]) / span * along;
        }
    }
    result.count = 2;
    return result;
}

} // namespace spacetow
