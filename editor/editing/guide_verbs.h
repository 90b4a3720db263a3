#pragma once
// What is done to guides without dragging them.

#include "editor/editing/tool.h"

#include <cstddef>
#include <optional>

namespace spacetow {

/// A level guide through the point, which snaps as points do. It is the last of the level.
FinishedEdit addGuide(const ToolContext& context, const Vec2& point);
/// Nothing when there is no such guide or it would stay as it is. Repeated within a second it stays one history entry.
std::optional<FinishedEdit> changeGuide(const Edit& edit, std::size_t index, const Guide& guide);
std::optional<FinishedEdit> deleteGuide(const Edit& edit, std::size_t index);
/// Nothing when there is none.
std::optional<FinishedEdit> clearGuides(const ToolContext& context);

} // namespace spacetow
