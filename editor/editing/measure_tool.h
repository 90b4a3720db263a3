#pragma once
// Measures: a drag, or two clicks, tell how far it is and in which direction; a third click the angle between the way
// back and the way to it. What was measured stays until Escape or the next measure. The level stays as it is.

#include "editor/editing/tool.h"

#include <array>
#include <string_view>

namespace spacetow {

class MeasureTool : public Tool {
  public:
    static constexpr auto hints = std::to_array<std::string_view>({
        "measure.start",
        "measure.first", // m, m across, m upwards, degrees
        "measure.same-point",
        "measure.done",   // as the first
        "measure.second", // and degrees between the legs
        "measure.angle",  // degrees, m, m
    });

    std::string code() const override { return "measure"; }
    std::unique_ptr<Gesture> press(const ToolContext&, const Pointer&) override { return nullptr; }
    std::optional<FinishedEdit> click(const ToolContext& context, const Pointer& pointer) override;
    /// A drag begins anew.
    std::optional<FinishedEdit> drop(const ToolContext& context, const Pointer& pointer) override;
    std::optional<FinishedEdit> secondaryClick(const ToolContext& context, const Pointer& pointer) override;
    /// Backspace takes the last point back.
    std::optional<FinishedEdit> key(const ToolContext& context, ToolKey key, const Pointer& pointer) override;
    bool isBusy() const override { return !m_points.empty(); }
    void cancel() override { m_points.clear(); }

    Overlay overlay(const ToolContext& context, const Pointer& pointer) const override;
    Hint hint(const ToolContext& context, const Pointer& pointer) const override;
    CursorShape cursor(const ToolContext&, const Pointer&) const override { return CursorShape::Cross; }
    std::optional<SnapAnswer> snapAt(const ToolContext& context, const Pointer& pointer) const override;
    /// What was measured, in full, in signs that need no translation.
    std::string numbers() const override;

  private:
    std::vector<Vec2> placed(const ToolContext& context, const Pointer& pointer) const;
    std::vector<Vec2> withPointer(const ToolContext& context, const Pointer& pointer) const;

    std::vector<Vec2> m_points; // world; three at most
};

/// Of the corner at `at` between the ways to `a` and to `b`, 0 … π.
double angleBetween(const Vec2& a, const Vec2& at, const Vec2& b);

} // namespace spacetow
