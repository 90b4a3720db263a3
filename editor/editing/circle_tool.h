#pragma once
// Draws circles: by a drag from the centre, or by a click on the centre and one on the rim.

#include "editor/editing/tool.h"

#include <array>
#include <string_view>

namespace spacetow {

class CircleTool : public Tool {
  public:
    static constexpr auto hints = std::to_array<std::string_view>({
        "draw-circle.start",
        "draw-circle.radius", // m
        "draw-circle.too-small",
    });

    std::string code() const override { return "circle"; }
    std::unique_ptr<Gesture> press(const ToolContext& context, const Pointer& pointer) override;
    std::optional<FinishedEdit> click(const ToolContext& context, const Pointer& pointer) override;
    std::optional<FinishedEdit> key(const ToolContext& context, ToolKey key, const Pointer& pointer) override;
    void hover(const ToolContext& context, const Pointer& pointer) override;
    std::optional<TypedMeasures> measures(const ToolContext& context, const Pointer& pointer) const override;
    bool isBusy() const override { return m_center.has_value(); }
    void cancel() override;

    Overlay overlay(const ToolContext& context, const Pointer& pointer) const override;
    Hint hint(const ToolContext& context, const Pointer& pointer) const override;
    CursorShape cursor(const ToolContext&, const Pointer&) const override { return CursorShape::Cross; }
    std::optional<SnapAnswer> snapAt(const ToolContext& context, const Pointer& pointer) const override;

  private:
    std::optional<Vec2> m_center; // world
    bool m_tooSmall = false;      // the last click was refused
};

} // namespace spacetow
