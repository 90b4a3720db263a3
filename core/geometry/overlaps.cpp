#include "core/geometry/overlaps.h"

#include "core/geometry/closest.h"
#include "core/geometry/collide.h"

namespace spacetow {

bool overlaps(const Part& a, const Transform& poseA, const Part& b, const Transform& poseB) {
    if (closestPoints(a, poseA, b, poseB).distance <= 0) {
        return true;
    }
    // What is inside the depth of an edge touches it without meeting its face.
    const bool wallInvolved = std::holds_alternative<WallPart>(a) || std::holds_alternative<WallPart>(b);
    return wallInvolved && collide(a, poseA, b, poseB, 0).count > 0;
}

} // namespace spacetow
