#pragma once
// Outlines as far as they can be seen: what lies out of view is drawn together to few points, and so is what is finer
// than a pixel. World coordinates, metres.

#include "core/geometry/segment_tree.h"
#include "core/math/aabb.h"
#include "core/math/transform.h"

#include <span>
#include <vector>

namespace spacetow {

struct SeenOutline {
    std::span<const Vec2> points; // local to the pose
    bool closed = false;
    Transform pose;
    const SegmentTree* tree = nullptr; // of the points; null for outlines that have none
};

struct SeenArea {
    Aabb box;      // what must be right: the view with room for pens and bands
    double finest; // m; what lies closer together may become one
};

/// Points of the outline in the world. In the area they follow it within twice `finest`; outside it they only lead
/// round in a way that leaves what is filled in the area as it is.
std::vector<Vec2> seenPoints(const SeenOutline& outline, const SeenArea& area);

/// Leaves out points as long as those left out lie within `tolerance` of the line that takes their place. Ends stay.
std::vector<Vec2> simplified(std::span<const Vec2> points, double tolerance);

} // namespace spacetow
