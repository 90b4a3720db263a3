#pragma once
// Edits the nodes of the selected objects, which are those in edit.

#include "editor/editing/pick.h"
#include "editor/editing/tool.h"

#include <array>
#include <string_view>

namespace spacetow {

class NodeTool : public Tool {
  public:
    static constexpr auto hints = std::to_array<std::string_view>({
        "nodes.none",
        "nodes.without",
        "nodes.idle",
        "nodes.object",
        "nodes.selected", // number of nodes
        "nodes.one-selected",
        "nodes.node",
        "nodes.segment",
        "nodes.insert",
        "nodes.moving",          // m to the right, m upwards
        "nodes.moving-together", // m to the right, m upwards
        "nodes.together",
        "nodes.crosses",
        "nodes.scale-handle",
        "nodes.turn-handle",
        "nodes.scaling", // width, height in m
        "nodes.turning", // degrees
        "nodes.band",    // number of nodes
        "nodes.lasso",   // number of nodes
    });

    std::string code() const override { return "nodes"; }
    /// A drag moves the selected nodes, or both ends of a segment; from empty ground or with Shift it draws a band,
    /// with Shift and Alt a lasso.
    std::unique_ptr<Gesture> press(const ToolContext& context, const Pointer& pointer) override;
    /// A click on one of several selected nodes changes between handles that scale them and handles that turn them.
    /// Selects a node, or both ends of a segment, or goes on to another object; with Shift it adds or takes away. With
    /// Ctrl and Alt it puts a node on a segment.
    std::optional<FinishedEdit> click(const ToolContext& context, const Pointer& pointer) override;
    /// Puts a node on a segment.
    std::optional<FinishedEdit> doubleClick(const ToolContext& context, const Pointer& pointer) override;
    std::optional<FinishedEdit> secondaryClick(const ToolContext& context, const Pointer& pointer) override;

    Overlay overlay(const ToolContext& context, const Pointer& pointer) const override;
    Overlay standing(const ToolContext& context, double pixel) const override;
    Hint hint(const ToolContext& context, const Pointer& pointer) const override;
    CursorShape cursor(const ToolContext& context, const Pointer& pointer) const override;

  private:
    bool m_turns = false; // what the handles do
};

/// A node on the segment under the pointer, of an outline that is in edit, and selected.
std::optional<FinishedEdit> insertNode(const ToolContext& context, const Pointer& pointer);

/// What looks like a handle is one, whatever the tool: the drag of the node under the pointer, when it belongs to the
/// one object that is selected. Nothing where the object is so small that it could no longer be moved itself.
std::unique_ptr<Gesture> dragOfNode(const ToolContext& context, const Pointer& pointer);
/// Whether that would be a drag.
bool isOnNode(const ToolContext& context, const Pointer& pointer);

} // namespace spacetow
