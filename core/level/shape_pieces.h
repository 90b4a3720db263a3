#pragma once
// What becomes of a body when one of its shapes is taken apart: the pieces stand in its place, a body without shapes
// goes. Edits of nodes are made with this.

#include "core/level/nodes.h"

#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace spacetow {

/// A level with the nodes that an edit leaves for the next one, ascending.
struct NodeEdit {
    Level level;
    std::vector<NodeRef> nodes;
};

/// Part of what was one shape; of its vertices `nodes` are those to be selected. Local coordinates.
struct ShapePiece {
    LevelShape shape;
    std::vector<int> nodes = {};
};

/// What a shape with these vertices in question becomes: nothing when it stays as it is, no pieces when it goes.
using ShapeChange = std::function<std::optional<std::vector<ShapePiece>>(const BodyObject& body, const NodeRef& first,
                                                                         std::span<const NodeRef> nodes)>;

/// Asks for each shape that has some of the nodes, which are ascending. The first piece takes the place of its shape,
/// the others come last. A body without shapes goes, with its connectors. Shapes that stay keep their nodes.
NodeEdit reshaped(Level level, std::span<const NodeRef> nodes, const ShapeChange& change);

/// A chain or polygon like `shape` with other vertices; a polygon stays closed.
LevelShape withVertices(const LevelShape& shape, std::vector<Vec2> vertices, bool closed);
/// Whether a shape with these vertices would be one: enough of them, and not all in one place.
bool isWhole(const LevelShape& shape);

/// Splits the way through `count` vertices into runs that share the vertices at which it is split. A closed one that
/// is split nowhere has no runs.
std::vector<std::vector<int>> splitRuns(int count, bool closed, const std::vector<bool>& split);
/// The vertices of a run as an open chain like `shape`.
LevelShape chainOf(const LevelShape& shape, const std::vector<int>& run);

} // namespace spacetow
