#include "core/geometry/polygon_at_wall.h"

#include "core/geometry/clip.h"
#include "core/geometry/collide_pairs.h"

namespace spacetow {

namespace {

/// Whether what of the polygon is over the line lies mostly to its right.
bool leansRight(const WallPart& line, const ConvexPart& convex) {
    const WallSide side = faceOf(line, false);
    double sum = 0;
    for (int i = 0; i < convex.count; ++i) {
        const auto clipped = clipToFace(side.start.point, side.direction, side.length,
                                        {cornerOf(convex, i), cornerOf(convex, cornerAfter(convex, i))});
        for (int k = 0; k < clipped.count; ++k) {
            sum += side.above(clipped.points[static_cast<std::size_t>(k)].point);
        }
    }
    return sum < 0;
}

} // namespace

Extent extentAlong(const WallSide& side, const ConvexPart& convex) {
    Extent extent;
    for (int i = 0; i < convex.count; ++i) {
        const double t = side.along(cornerOf(convex, i));
        extent.from = std::min(extent.from, t);
        extent.to = std::max(extent.to, t);
    }
    return extent;
}

bool isMostlyOnRight(const WallPart& line, const ConvexPart& convex) {
    const bool right = cross(line.b - line.a, convex.center - line.a) < 0;
    return right == isOnRight(line, convex.center) ? right : leansRight(line, convex);
}

bool isHeld(const WallSide& side, const ConvexPart& convex) {
    const bool wholeInside =
        isCut(convex) && side.above(convex.whole) >= -side.depth && side.above(convex.whole) <= onTheFace;
    return side.holds(convex.center) || (wholeInside && side.spans(convex.center));
}

} // namespace spacetow
