#pragma once
// Selects by click and rubber band, and moves what is selected.

#include "editor/editing/tool.h"

namespace spacetow {

/// How near the pointer must be to something to mean it, in pixels.
constexpr double grabPixels = 6;

class SelectTool : public Tool {
  public:
    std::string code() const override { return "select"; }
    /// A drag moves, from empty ground or with Shift it draws a band, with Alt it moves the selection from anywhere.
    std::unique_ptr<Gesture> press(const ToolContext& context, const Pointer& pointer) override;
    /// With Shift or Ctrl toggles, with Alt goes on to the object underneath.
    std::optional<FinishedEdit> click(const ToolContext& context, const Pointer& pointer) override;
    /// The node tool edits what was hit.
    std::optional<ToolId> toolAfterDoubleClick(const ToolContext& context, const Pointer& pointer) const override;
    /// Selects what the menu that may now open will be about.
    std::optional<FinishedEdit> secondaryClick(const ToolContext& context, const Pointer& pointer) override;

    Overlay overlay(const ToolContext& context, const Pointer& pointer) const override;
    Hint hint(const ToolContext& context, const Pointer& pointer) const override;
    CursorShape cursor(const ToolContext& context, const Pointer& pointer) const override;
};

} // namespace spacetow
