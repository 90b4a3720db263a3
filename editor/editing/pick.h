#pragma once
// Which objects lie under a point or in a box; their nodes and segments are found by node_pick.h, which answers with
// the Hit of here. What is hidden or locked is not picked.

#include "core/level/level.h"
#include "core/math/aabb.h"

#include <span>
#include <vector>

namespace spacetow {

enum class HitKind : std::uint8_t { Node, Segment };

/// A part of an object under the pointer.
struct Hit {
    HitKind kind = HitKind::Node;
    Key key = 0;
    int shape = -1;
    int index = -1;      // vertex, or segment (it begins at the vertex of that index)
    Vec2 at{0, 0};       // world: the node, or the nearest point
    double distance = 0; // m, from the point that was asked for

    bool operator==(const Hit&) const = default;
};

struct PickQuery {
    Vec2 point{0, 0};
    double tolerance = 0;           // m
    std::span<const Key> nodesOf{}; // the objects whose nodes and segments count, ascending
};

/// Keys of the objects within `tolerance` metres of the point: outlines count by distance, filled shapes inside too.
/// The best pick comes first: things like ship and payload before walls, small before large, later before earlier.
std::vector<Key> picked(const Level& level, const Vec2& point, double tolerance);
/// Whether something that is seen, but locked, lies there.
bool isLockedAt(const Level& level, const Vec2& point, double tolerance);
/// Keys of the objects that touch the box, or that lie wholly inside it, in the order of the level.
std::vector<Key> pickedIn(const Level& level, const Aabb& box, bool wholly);

} // namespace spacetow
