#pragma once
// What the drawing tools put into the level: a static body with the tag of walls, selected.

#include "editor/editing/tool.h"

namespace spacetow {

/// `shape` in coordinates relative to `position`; the seed of the context chooses the key.
Edit withDrawnBody(const ToolContext& context, LevelShape shape, const Vec2& position);

} // namespace spacetow
