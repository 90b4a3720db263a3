#pragma once
// Objects as text on the way to the clipboard and back; the text is that of level files, so it may be mailed.

#include "editor/editing/tool.h"

#include <optional>
#include <string>
#include <string_view>

namespace spacetow {

/// Empty when nothing is selected.
std::string copied(const Edit& edit);
/// Removes the selection; take copied() first.
std::optional<FinishedEdit> cut(const ToolContext& context);
/// The objects in the text with fresh keys, selected, their middle near `at`, or where they were without it; moved by
/// whole grid steps while the grid is on, so that what was on the grid stays on it. Connectors come along when both
/// their ends do. A ship, payload or finish comes along when the level has none. In a group that has been entered they
/// become members of it, but for layers, which stay at the top; who pastes one has left the group. Tags are those of
/// the same name; what the level does not have is made, and the notes tell of it. Nothing when the text holds no object
/// that can be pasted.
std::optional<FinishedEdit> pasted(const ToolContext& context, std::string_view text, const std::optional<Vec2>& at);

} // namespace spacetow
