#pragma once
// Transforms parts to other coordinates.

#include "core/geometry/part.h"
#include "core/math/transform.h"

namespace spacetow {

/// The pose of `inner` in the local coordinates of `outer`.
inline Transform relative(const Transform& inner, const Transform& outer) {
    return {outer.toLocal(inner.position), outer.rotation.inverse() * inner.rotation};
}

inline Circle moved(const Circle& circle, const Transform& pose) {
    return {pose.toWorld(circle.center), circle.radius};
}

inline WallPart moved(const WallPart& wall, const Transform& pose) {
    WallPart result = wall;
    result.a = pose.toWorld(wall.a);
    result.b = pose.toWorld(wall.b);
    result.beforeA = pose.toWorld(wall.beforeA);
    result.afterB = pose.toWorld(wall.afterB);
    return result;
}

inline ConvexPart moved(const ConvexPart& part, const Transform& pose) {
    ConvexPart result;
    result.count = part.count;
    result.outerFaces = part.outerFaces;
    result.center = pose.toWorld(part.center);
    for (std::size_t i = 0; i < static_cast<std::size_t>(part.count); ++i) {
        result.corners[i] = pose.toWorld(part.corners[i]);
        result.normals[i] = pose.rotation * part.normals[i];
    }
    if (isCut(part)) {
        result.whole = pose.toWorld(part.whole);
        for (std::size_t i = 0; i < static_cast<std::size_t>(part.count); ++i) {
            result.normalsBeyond[i] = pose.rotation * part.normalsBeyond[i];
        }
    }
    return result;
}

} // namespace spacetow
