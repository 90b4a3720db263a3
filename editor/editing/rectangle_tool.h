#pragma once
// Draws rectangles, which are polygons of four corners: by a drag from corner to corner, or by a click on each. With
// Shift the first point is the middle, with Ctrl the sides are equal.

#include "editor/editing/tool.h"

#include <array>
#include <string_view>

#include <memory>
#include <optional>

namespace spacetow {

class RectangleTool : public Tool {
  public:
    static constexpr auto hints = std::to_array<std::string_view>({
        "draw-rectangle.start",
        "draw-rectangle.size", // width, height in m
        "draw-rectangle.too-small",
    });

    std::string code() const override { return "rectangle"; }
    std::unique_ptr<Gesture> press(const ToolContext& context, const Pointer& pointer) override;
    std::optional<FinishedEdit> click(const ToolContext& context, const Pointer& pointer) override;
    std::optional<FinishedEdit> key(const ToolContext& context, ToolKey key, const Pointer& pointer) override;
    void hover(const ToolContext& context, const Pointer& pointer) override;
    std::optional<TypedMeasures> measures(const ToolContext& context, const Pointer& pointer) const override;
    bool isBusy() const override { return m_start.has_value(); }
    void cancel() override;

    Overlay overlay(const ToolContext& context, const Pointer& pointer) const override;
    Hint hint(const ToolContext& context, const Pointer& pointer) const override;
    CursorShape cursor(const ToolContext&, const Pointer&) const override { return CursorShape::Cross; }
    std::optional<SnapAnswer> snapAt(const ToolContext& context, const Pointer& pointer) const override;

  private:
    std::optional<Vec2> m_start; // world; the first of two clicks
    bool m_tooSmall = false;     // the last click was refused
};

/// The drag that draws a rectangle from where it starts.
std::unique_ptr<Gesture> dragOfRectangle(const ToolContext& context, const Pointer& start, BodyKind kind);

} // namespace spacetow
