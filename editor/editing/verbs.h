#pragma once
// What menus and keys do to the selection, without a drag. Each gives the finished edit, or nothing when there is
// nothing to do; Toolbox::finish makes it a history entry. Where nodes are selected, removing, nudging, turning and
// reversing is done to them; see node_verbs.h.

#include "core/level/arrange.h"
#include "editor/editing/tool.h"

#include <optional>

namespace spacetow {

/// About which the selection turns: its pivot, or without one the middle of its points, on the grid while points snap
/// to it, so that quarter turns keep on the grid what is on it. A single body whose place is about its middle turns
/// about that, as when its angle is typed; so do ship, payload, and what moves by itself. Nothing when nothing in it
/// has a place.
std::optional<Vec2> turningPoint(const ToolContext& context);

/// What is locked stays, here and below.
std::optional<FinishedEdit> removeSelected(const ToolContext& context);
/// Copies one grid step to the right and down; the copies are selected.
std::optional<FinishedEdit> duplicateSelected(const ToolContext& context);
/// By `delta` metres. Repeated within a second it stays one history entry.
std::optional<FinishedEdit> nudgeSelected(const ToolContext& context, const Vec2& delta);
/// Anticlockwise about the turning point, which the selection remembers as its pivot, so that four quarters bring back
/// every bit. Repeated within a second it stays one history entry.
std::optional<FinishedEdit> rotateSelected(const ToolContext& context, double radians);
/// Mapped; `code` is that of the label. The determinant is not zero. The pivot goes along.
std::optional<FinishedEdit> mapSelected(const ToolContext& context, LabelCode code, const Affine& map);
/// Mirrored about the middle of its bounds.
std::optional<FinishedEdit> flipSelected(const ToolContext& context, FlipAxis axis);
/// Turns the solid side of the selected one-way walls round.
std::optional<FinishedEdit> reverseSelected(const ToolContext& context);

/// What clicks could select in the group that was entered; see selectableKeys.
Selection selectAll(const Edit& edit);
Selection invertedSelection(const Edit& edit);

} // namespace spacetow
