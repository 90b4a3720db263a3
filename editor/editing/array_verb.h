#pragma once
// Arrays of what is selected.

#include "core/level/arrays.h"
#include "editor/editing/tool.h"

#include <optional>

namespace spacetow {

/// The originals and all copies are selected. Nothing when there is nothing to copy, or far too much of it; see
/// arraySize.
std::optional<FinishedEdit> arraySelected(const ToolContext& context, const ArraySpec& spec);

} // namespace spacetow
