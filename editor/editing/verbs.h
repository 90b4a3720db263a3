#pragma once
// What menus and keys do to the selection, without a drag. Each gives the finished edit, or nothing when there is
// nothing to do; Toolbox::finish makes it a history entry. Where nodes are selected, removing, nudging, turning and
// reversing is done to them; see node_verbs.h.

#include "editor/editing/tool.h"

#include <optional>

namespace spacetow {

std::optional<FinishedEdit> removeSelected(const ToolContext& context);
/// Copies one grid step to the right and down; the copies are selected.
std::optional<FinishedEdit> duplicateSelected(const ToolContext& context);
/// By `delta` metres. Repeated within a second it stays one history entry.
std::optional<FinishedEdit> nudgeSelected(const ToolContext& context, const Vec2& delta);
/// Anticlockwise about the pivot of the selection. Without one it is the middle of the selection's points, on the grid
/// while points snap to it, so that quarter turns keep on the grid what is on it; the selection remembers that pivot,
/// so that four quarters bring back every bit. Repeated within a second it stays one history entry.
std::optional<FinishedEdit> rotateSelected(const ToolContext& context, double radians);
/// Turns the solid side of the selected one-way walls round.
std::optional<FinishedEdit> reverseSelected(const ToolContext& context);

/// What clicks could select in the group that was entered; see selectableKeys.
Selection selectAll(const Edit& edit);
Selection invertedSelection(const Edit& edit);

} // namespace spacetow
