#pragma once
// Draws chains of one-way walls, chains of two-sided walls, and polygons, point by point. A click places a point, a
// drag adjusts it before it is placed; the first drag also places the point where it began. A click on the first
// point closes the shape; Enter, the secondary button or a double click end it where it is.

#include "editor/editing/tool.h"

namespace spacetow {

enum class DrawKind : std::uint8_t { Edge, Line, Polygon };

class DrawTool : public Tool {
  public:
    explicit DrawTool(DrawKind kind) : m_kind(kind) {}

    std::string code() const override;
    std::unique_ptr<Gesture> press(const ToolContext&, const Pointer&) override { return nullptr; }
    std::optional<FinishedEdit> click(const ToolContext& context, const Pointer& pointer) override;
    std::optional<FinishedEdit> drop(const ToolContext& context, const Pointer& pointer) override;
    std::optional<FinishedEdit> doubleClick(const ToolContext& context, const Pointer& pointer) override;
    std::optional<FinishedEdit> secondaryClick(const ToolContext& context, const Pointer& pointer) override;
    std::optional<FinishedEdit> key(const ToolContext& context, ToolKey key, const Pointer& pointer) override;
    void hover(const ToolContext& context, const Pointer& pointer) override;
    bool isBusy() const override { return !m_points.empty(); }
    void cancel() override;

    Overlay overlay(const ToolContext& context, const Pointer& pointer) const override;
    Hint hint(const ToolContext& context, const Pointer& pointer) const override;
    CursorShape cursor(const ToolContext& context, const Pointer& pointer) const override;

  private:
    std::vector<Vec2> pointsWith(const ToolContext& context) const;
    Vec2 nextPoint(const ToolContext& context, const Pointer& pointer) const;
    bool closesAt(const ToolContext& context, const Pointer& pointer) const;
    std::size_t leastPoints() const { return m_kind == DrawKind::Polygon ? 3 : 2; }
    std::string hintCode(const char* state) const { return "draw-" + code() + "." + state; }
    std::optional<FinishedEdit> end(const ToolContext& context);
    std::optional<FinishedEdit> finish(const ToolContext& context, bool closed);
    std::optional<FinishedEdit> finishPolygon(const ToolContext& context);

    DrawKind m_kind;
    std::vector<Vec2> m_points; // world
    std::string m_refusal;      // code of the hint that says why the last click did nothing
};

} // namespace spacetow
