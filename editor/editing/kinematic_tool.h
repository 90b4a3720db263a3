#pragma once
// Draws bodies that move as they are told: a rectangle by a drag, or a polygon corner by corner. Then the arrow of its
// velocity follows the pointer, until a click or a drag sets it; Enter or the secondary button leave the body at rest.

#include "editor/editing/draw_tool.h"

#include <memory>
#include <optional>

namespace spacetow {

class KinematicTool : public Tool {
  public:
    static constexpr auto hints = std::to_array<std::string_view>({
        "draw-kinematic.start",
    });

    std::string code() const override { return "kinematic"; }
    std::unique_ptr<Gesture> press(const ToolContext& context, const Pointer& pointer) override;
    void dragEnded(const ToolContext& context, const Pointer& pointer) override;
    std::optional<FinishedEdit> click(const ToolContext& context, const Pointer& pointer) override;
    std::optional<FinishedEdit> drop(const ToolContext& context, const Pointer& pointer) override;
    std::optional<FinishedEdit> doubleClick(const ToolContext& context, const Pointer& pointer) override;
    std::optional<FinishedEdit> secondaryClick(const ToolContext& context, const Pointer& pointer) override;
    std::optional<FinishedEdit> key(const ToolContext& context, ToolKey key, const Pointer& pointer) override;
    void hover(const ToolContext& context, const Pointer& pointer) override;
    std::optional<TypedMeasures> measures(const ToolContext& context, const Pointer& pointer) const override;
    bool isBusy() const override { return m_outline.isBusy() || m_body != 0; }
    std::optional<Edit> unfinished(const ToolContext& context) const override { return m_outline.unfinished(context); }
    void cancel() override;

    Overlay overlay(const ToolContext& context, const Pointer& pointer) const override;
    Hint hint(const ToolContext& context, const Pointer& pointer) const override;
    CursorShape cursor(const ToolContext& context, const Pointer& pointer) const override;

  private:
    /// Where the arrow begins while it is drawn.
    std::optional<Vec2> arrowFrom(const ToolContext& context) const;
    std::optional<FinishedEdit> drawn(std::optional<FinishedEdit> finished);

    DrawTool m_outline{DrawKind::Kinematic};
    Key m_body = 0;                           // that has been drawn and waits for its velocity; 0 for none
    std::shared_ptr<const Level> m_pressedOn; // the level when the button went down
};

} // namespace spacetow
