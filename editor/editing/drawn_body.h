#pragma once
// What the drawing tools put into the level: a body with the tag of walls, selected.

#include "editor/editing/tool.h"

#include <span>

namespace spacetow {

/// `shape` in coordinates relative to `position`; the seed of the context chooses the key.
Edit withDrawnBody(const ToolContext& context, LevelShape shape, const Vec2& position,
                   BodyKind kind = BodyKind::Static);
/// A polygon through these points of the world, which are in either order. Its position, about which it turns, is its
/// middle, on the grid while points snap to it and the grid has a point in it; of a kinematic one exactly.
Edit withDrawnPolygon(const ToolContext& context, std::vector<Vec2> outline, BodyKind kind);

} // namespace spacetow
