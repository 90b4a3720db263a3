#pragma once
// Edits of nodes: inserted, removed, joined, broken, straightened, turned round. As all edits they leave their input
// as it is; nodes that are not in the level are ignored. `nodes` are ascending, points are of the world, in metres.
// What falls under its least number of points goes, a body with its last shape. A polygon may come to cross itself:
// see faultAt.

#include "core/level/shape_pieces.h"

namespace spacetow {

/// A node on the segment that begins at `segment`. The new node is what is left to be selected.
NodeEdit withNode(Level level, const NodeRef& segment, const Vec2& at);
/// A node in the middle of each segment with both ends among the nodes. Those and the new ones are selected.
NodeEdit withMidpoints(Level level, std::span<const NodeRef> nodes);
/// Neighbours of what goes are joined. The finish keeps its ends.
Level withoutNodes(Level level, std::span<const NodeRef> nodes);
/// Segments with both ends among the nodes go, and the chain is open there. Polygons stay.
NodeEdit withoutSegments(Level level, std::span<const NodeRef> nodes);
/// Chains are split at the nodes, closed ones opened. Both ends of each break are selected.
NodeEdit brokenAt(Level level, std::span<const NodeRef> nodes);
/// Segments with both ends among the nodes run the other way; what is part of a chain becomes a chain of its own in the
/// same body.
NodeEdit reversedPart(Level level, std::span<const NodeRef> nodes);
/// Segments with both ends among the nodes get the nearest multiple of 15° as their direction and keep their lengths.
/// The first node of a row of such segments stays where it is, and so does all beyond its last node.
NodeEdit straightened(Level level, std::span<const NodeRef> nodes);

enum class JoinWay : std::uint8_t {
    Weld,    // into one node in the middle
    Segment, // by a new segment; ends in one place become one node
};
/// Two ends of one chain close it; ends of two chains of a kind make one chain out of them, which keeps the direction
/// and the body of the one that comes first in the level. Two neighbours are welded into one.
bool canJoin(const Level& level, std::span<const NodeRef> nodes, JoinWay way);
/// The level as it is when they cannot be joined.
NodeEdit joined(Level level, std::span<const NodeRef> nodes, JoinWay way);

/// All nodes at these points that are not hidden or locked, ascending. Does not look through the level.
std::vector<NodeRef> nodesAt(const Level& level, std::span<const Vec2> points);

enum class NodeFault : std::uint8_t {
    None,
    Together, // a node has come to lie on the next one
    Crosses,  // a polygon crosses itself
};
/// What is wrong with the shapes that have these nodes; the worst of it.
NodeFault faultAt(const Level& level, std::span<const NodeRef> nodes);

} // namespace spacetow
