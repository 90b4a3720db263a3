#pragma once
// What menus and keys do to the selected nodes, as verbs.h for objects. Each answers with nothing when there is nothing
// to do.

#include "editor/editing/tool.h"

#include <optional>

namespace spacetow {

std::optional<FinishedEdit> removeNodes(const ToolContext& context);
/// Of the selected segments; with less than two nodes selected, of all segments of the objects in edit.
std::optional<FinishedEdit> insertMidpoints(const ToolContext& context);
std::optional<FinishedEdit> removeSegments(const ToolContext& context);
std::optional<FinishedEdit> joinNodes(const ToolContext& context);
std::optional<FinishedEdit> joinBySegment(const ToolContext& context);
std::optional<FinishedEdit> breakNodes(const ToolContext& context);
/// The selected part of chains.
std::optional<FinishedEdit> reverseNodes(const ToolContext& context);
std::optional<FinishedEdit> straightenNodes(const ToolContext& context);
/// By `delta` metres, with those of others at the same places. Repeated within a second it stays one history entry.
std::optional<FinishedEdit> nudgeNodes(const ToolContext& context, const Vec2& delta);
/// Anticlockwise about the middle of their bounds, likewise.
std::optional<FinishedEdit> rotateNodes(const ToolContext& context, double radians);

Selection selectAllNodes(const Edit& edit);
Selection invertedNodes(const Edit& edit);
/// The node after the last selected one, or before the first, in the order of the objects in edit; round at the end.
Selection nextNode(const Edit& edit, int direction);

} // namespace spacetow
