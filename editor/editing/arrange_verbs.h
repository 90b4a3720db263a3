#pragma once
// What menus and keys do to arrange the selection: alignment, order, groups and layers, hiding and locking, copies in
// place, repetition. As in verbs.h each gives the finished edit, or nothing when there is nothing to do.

#include "core/level/arrange.h"
#include "editor/editing/tool.h"

#include <optional>

namespace spacetow {

std::optional<FinishedEdit> alignSelected(const ToolContext& context, AlignTo side);
std::optional<FinishedEdit> distributeSelected(const ToolContext& context, Spread what, bool across);
std::optional<FinishedEdit> orderSelected(const ToolContext& context, OrderTo where);

/// The group is selected.
std::optional<FinishedEdit> groupSelected(const ToolContext& context);
/// The former members are selected.
std::optional<FinishedEdit> ungroupSelected(const ToolContext& context);
/// Of the selection; an empty one when nothing is selected.
std::optional<FinishedEdit> newLayer(const ToolContext& context);
/// To the layer that is drawn next above (1) or below (−1); below the lowest there is no layer.
std::optional<FinishedEdit> selectedToLayer(const ToolContext& context, int step);

/// What is hidden or locked cannot be selected, so nothing is afterwards.
std::optional<FinishedEdit> hideSelected(const ToolContext& context);
std::optional<FinishedEdit> lockSelected(const ToolContext& context);
std::optional<FinishedEdit> isolateSelected(const ToolContext& context);
std::optional<FinishedEdit> showAll(const ToolContext& context);
std::optional<FinishedEdit> unlockAll(const ToolContext& context);

/// The copies lie on their originals and are selected. What is done to them next is repeated with the copying.
std::optional<FinishedEdit> duplicateInPlace(const ToolContext& context);
/// What was last done to a selection by moving, turning, scaling or copying is done to this one.
std::optional<FinishedEdit> repeatLast(const ToolContext& context);

/// All that clicks could select and that is of the same kind as something selected.
Selection sameKind(const Edit& edit);
/// Likewise all bodies with the tags of a selected one, and that collide with the same.
Selection sameTags(const Edit& edit);

} // namespace spacetow
