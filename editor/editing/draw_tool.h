#pragma once
// Draws chains of one-way walls, chains of two-sided walls, and polygons, point by point. A click places a point, a
// drag adjusts it before it is placed; the first drag also places the point where it began. A click on the first
// point closes the shape; Enter, the secondary button or a double click end it where it is. What begins at the end of
// an open chain of the same kind goes on with that chain.

#include "core/level/chain_ends.h"
#include "editor/editing/tool.h"

#include <array>
#include <string_view>

namespace spacetow {

enum class DrawKind : std::uint8_t {
    Edge,
    Line,
    Polygon,
    Kinematic, // a polygon that moves as it is told
};

class DrawTool : public Tool {
  public:
    static constexpr auto hints = std::to_array<std::string_view>({
        "draw-edge.start",
        "draw-edge.next",  // number of points, m, degrees
        "draw-edge.close", // number of points
        "draw-edge.too-few",     "draw-edge.same-point", "draw-edge.extend",      "draw-edge.close-chain",
        "draw-line.start",       "draw-line.next",       "draw-line.close",       "draw-line.too-few",
        "draw-line.same-point",  "draw-line.extend",     "draw-line.close-chain", "draw-polygon.start",
        "draw-polygon.next",     "draw-polygon.close",   "draw-polygon.too-few",  "draw-polygon.same-point",
        "draw-polygon.crossing", "draw-polygon.crossed", "draw-polygon.crosses",  "draw-polygon.flat",
    });

    explicit DrawTool(DrawKind kind) : m_kind(kind) {}

    std::string code() const override;
    std::unique_ptr<Gesture> press(const ToolContext&, const Pointer&) override { return nullptr; }
    std::optional<FinishedEdit> click(const ToolContext& context, const Pointer& pointer) override;
    std::optional<FinishedEdit> drop(const ToolContext& context, const Pointer& pointer) override;
    std::optional<FinishedEdit> doubleClick(const ToolContext& context, const Pointer& pointer) override;
    std::optional<FinishedEdit> secondaryClick(const ToolContext& context, const Pointer& pointer) override;
    std::optional<FinishedEdit> key(const ToolContext& context, ToolKey key, const Pointer& pointer) override;
    void hover(const ToolContext& context, const Pointer& pointer) override;
    std::optional<TypedMeasures> measures(const ToolContext& context, const Pointer& pointer) const override;
    bool isBusy() const override { return !m_points.empty(); }
    std::optional<Edit> unfinished(const ToolContext& context) const override;
    void cancel() override;

    Overlay overlay(const ToolContext& context, const Pointer& pointer) const override;
    Hint hint(const ToolContext& context, const Pointer& pointer) const override;
    CursorShape cursor(const ToolContext& context, const Pointer& pointer) const override;
    std::optional<SnapAnswer> snapAt(const ToolContext& context, const Pointer& pointer) const override;

  private:
    /// Where drawing begins: at a point, which may be the end of a chain that is there.
    struct Start {
        Vec2 at{0, 0};
        std::optional<ChainEnd> chain;
    };
    Start startAt(const ToolContext& context, const Pointer& pointer) const;
    void begin(const Start& start);
    /// The start of what is drawn: the placed one, or that of a first drag.
    std::optional<Start> start(const ToolContext& context) const;
    std::vector<Vec2> pointsWith(const ToolContext& context) const;
    Vec2 nextPoint(const ToolContext& context, const Pointer& pointer) const;
    bool closesAt(const ToolContext& context, const Pointer& pointer) const;
    /// The other end of the chain that is drawn on, when the next click closes it.
    std::optional<Vec2> ringAt(const ToolContext& context, const Pointer& pointer) const;
    Overlay startOverlay(const ToolContext& context, const Pointer& pointer) const;
    Hint nextHint(const ToolContext& context, const Pointer& pointer) const;

    bool isPolygon() const { return m_kind == DrawKind::Polygon || m_kind == DrawKind::Kinematic; }
    bool crosses() const { return m_crossed && m_points.size() >= *m_crossed; }
    std::size_t leastPoints() const { return isPolygon() ? 3 : 2; }
    std::string hintCode(const std::string& state) const;
    std::optional<FinishedEdit> refuse(const std::string& state);
    std::optional<FinishedEdit> end(const ToolContext& context);
    std::optional<FinishedEdit> finish(const ToolContext& context, bool closed);
    std::optional<FinishedEdit> finishChain(const ToolContext& context, bool closed);
    std::optional<FinishedEdit> finishPolygon(const ToolContext& context);

    DrawKind m_kind;
    std::vector<Vec2> m_points;           // world
    std::optional<ChainEnd> m_chain;      // that is drawn on, from the first of the points
    std::optional<std::size_t> m_crossed; // with so many points the outline first crossed itself
    std::string m_refusal;                // code of the hint that says why the last click did nothing
};

} // namespace spacetow
