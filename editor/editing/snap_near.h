#pragma once
// What there is to snap to in a box: points, segments and rims of visible objects that do not move themselves. Looks
// at what is near only. World coordinates, m.

#include "core/geometry/shape.h"
#include "core/level/level.h"
#include "core/level/nodes.h"
#include "core/math/aabb.h"
#include "editor/editing/snap_answer.h"

#include <vector>

namespace spacetow {

/// What is on the move, to which it does not snap itself, and by which points it snaps.
struct SnapSubject {
    std::vector<Key> keys;      // whole objects, with the members of groups; ascending
    std::vector<NodeRef> nodes; // of others; ascending. The segments that end at them move too
    std::vector<Vec2> points;   // snap as the one that is placed does; as seen from that
    int guide = -1;             // its place in the level
    Aabb box;                   // its sides and its middle align; as seen from that. Empty: only the point itself does

    bool operator==(const SnapSubject&) const = default;
};

struct NearPoint {
    Vec2 at{0, 0};
    SnapKind kind = SnapKind::Vertex; // or Center
    Key key = 0;
};
struct NearSegment {
    Vec2 a{0, 0};
    Vec2 b{1, 0};
    Key key = 0;
};
struct NearRim {
    Circle circle; // world
    Key key = 0;
};

struct Nearby {
    std::vector<NearPoint> points;
    std::vector<NearSegment> segments;
    std::vector<NearRim> rims;
};

Nearby nearby(const Level& level, const SnapSubject& subject, const Aabb& box);

/// Visible, and not on the move.
bool staysInView(const Level& level, const SnapSubject& subject, int object);

} // namespace spacetow
