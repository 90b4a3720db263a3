#pragma once
// Nodes: the vertices of chains, lines and polygons, and the ends of the finish. World coordinates, m.

#include "core/level/level.h"
#include "core/math/affine.h"

#include <optional>
#include <span>
#include <vector>

namespace spacetow {

/// One node of an object. The finish has one shape (0) with the vertices 0 and 1.
struct NodeRef {
    Key key = 0;
    int shape = 0;
    int vertex = 0;

    auto operator<=>(const NodeRef&) const = default; // NOLINT(modernize-use-nullptr): clang-tidy 14 sees a 0 in it
};

/// The nodes of one shape in the order of its vertices.
struct NodePath {
    int shape = 0;
    std::vector<Vec2> points; // world
    bool closed = false;      // the last node is joined to the first

    /// Segment i leads from node i to the next.
    int segments() const {
        const int count = static_cast<int>(points.size());
        return closed ? count : std::max(0, count - 1);
    }
    const Vec2& end(int segment) const { return points[static_cast<std::size_t>(segment + 1) % points.size()]; }
};

/// The vertices of a shape, local to its body; null for a circle.
std::vector<Vec2>* verticesOf(LevelShape& shape);
const std::vector<Vec2>* verticesOf(const LevelShape& shape);
/// Whether the last vertex is joined to the first.
bool isClosed(const LevelShape& shape);

/// Of all shapes that have nodes; circles, ship, payload, connectors and groups have none.
std::vector<NodePath> nodePaths(const ObjectData& data);
bool hasNode(const ObjectData& data, int shape, int vertex);
/// Nothing when there is no such node. Looks the object up by its key.
std::optional<Vec2> nodePosition(const Level& level, const NodeRef& node);
/// Every node of the objects, ascending.
std::vector<NodeRef> allNodes(const Level& level, std::span<const Key> keys);

/// The nodes go where the map (of the world) sends them; all else stays. The nodes are ascending.
Level withMappedNodes(Level level, std::span<const NodeRef> nodes, const Affine& map);

} // namespace spacetow
