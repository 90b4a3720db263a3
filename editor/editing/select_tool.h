#pragma once
// Selects by click and rubber band; moves, scales and turns what is selected.

#include "editor/editing/group_picking.h"
#include "editor/editing/handles.h"
#include "editor/editing/velocity_handle.h"

namespace spacetow {

class SelectTool : public Tool {
  public:
    static constexpr auto hints = std::to_array<std::string_view>({
        "select.idle",           "select.object",      "select.group",
        "select.selected-group", // number of objects
        "select.in-group",       // number of objects
        "select.in-named-group", // number of objects, name of the group
        "select.lasso",          // number of objects
        "select.selected",       // number of objects
        "select.moving",         // m to the right, m upwards
        "select.band",           // number of objects
        "select.scale-handle",
        "select.scaling", // width, height in m, width, height in %
        "select.turn-handle",
        "select.turning", // degrees
        "select.pivot-handle",   "select.small-pivot",
        "select.pivot", // x, y in m
        "select.node",           "select.locked",
        "select.all-locked", // number of objects
    });

    std::string code() const override { return "select"; }
    /// A drag of a handle scales or turns; else a drag moves, from empty ground or with Shift it draws a band, with Alt
    /// it moves the selection from anywhere, with both it draws a lasso.
    std::unique_ptr<Gesture> press(const ToolContext& context, const Pointer& pointer) override;
    /// With Shift or Ctrl toggles, with Ctrl in groups by itself, with Alt goes on to the object underneath. On what is
    /// selected it changes between the handles that scale and those that turn.
    std::optional<FinishedEdit> click(const ToolContext& context, const Pointer& pointer) override;
    /// Enters the group under the pointer; on empty ground leaves the one that was entered.
    std::optional<FinishedEdit> doubleClick(const ToolContext& context, const Pointer& pointer) override;
    /// The node tool edits what was hit.
    std::optional<ToolId> toolAfterDoubleClick(const ToolContext& context, const Pointer& pointer) const override;
    /// Selects what the menu that may now open will be about.
    std::optional<FinishedEdit> secondaryClick(const ToolContext& context, const Pointer& pointer) override;

    Overlay overlay(const ToolContext& context, const Pointer& pointer) const override;
    Overlay standing(const ToolContext& context, double pixel) const override;
    Hint hint(const ToolContext& context, const Pointer& pointer) const override;
    CursorShape cursor(const ToolContext& context, const Pointer& pointer) const override;

  private:
    Overlay handles(const ToolContext& context, double pixel, const std::optional<Handle>& hot) const;
    const HandleFrame& frameOf(const ToolContext& context) const;
    bool isAllLocked(const ToolContext& context) const;
    HandleMode modeOf(const ToolContext& context) const;
    std::optional<Handle> handleUnder(const ToolContext& context, const Pointer& pointer) const;
    std::optional<VelocityArrow> velocityUnder(const ToolContext& context, const Pointer& pointer) const;

    std::vector<Key> m_turning; // the selection that shows the handles that turn

    /// A frame takes time with the size of the selection, and is asked for whenever the pointer moves.
    struct Framed {
        Edit edit;
        SnapSettings snap;
        HandleFrame frame;
        bool allLocked = false; // what is selected
    };
    mutable std::optional<Framed> m_framed;
};

} // namespace spacetow
