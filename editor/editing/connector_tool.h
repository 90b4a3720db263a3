#pragma once
// Draws connectors from body to body: by a drag, or by a click on each.

#include "editor/editing/connector_ends.h"

#include <optional>
#include <string>

namespace spacetow {

class ConnectorTool : public Tool {
  public:
    static constexpr auto hints = std::to_array<std::string_view>({
        "connector.start",
        "connector.from-named", // name of the body
        "connector.from-static",
        "connector.from-kinematic",
        "connector.from-dynamic",
        "connector.to-named",  // m, name of the body
        "connector.to-static", // m
        "connector.to-kinematic",
        "connector.to-dynamic",
        "connector.nothing-moves", // m
        "connector.same-body",
        "connector.no-body",
        "connector.nothing-here",
        "connector.began-nowhere",
        "connector.ended-nowhere",
    });

    std::string code() const override { return "connector"; }
    std::unique_ptr<Gesture> press(const ToolContext& context, const Pointer& pointer) override;
    void dragEnded(const ToolContext& context, const Pointer& pointer) override;
    std::optional<FinishedEdit> click(const ToolContext& context, const Pointer& pointer) override;
    std::optional<FinishedEdit> drop(const ToolContext& context, const Pointer& pointer) override;
    std::optional<FinishedEdit> secondaryClick(const ToolContext& context, const Pointer& pointer) override;
    std::optional<FinishedEdit> key(const ToolContext& context, ToolKey key, const Pointer& pointer) override;
    void hover(const ToolContext& context, const Pointer& pointer) override;
    bool isBusy() const override { return m_from.has_value(); }
    void cancel() override;

    Overlay overlay(const ToolContext& context, const Pointer& pointer) const override;
    Hint hint(const ToolContext& context, const Pointer& pointer) const override;
    CursorShape cursor(const ToolContext& context, const Pointer& pointer) const override;
    std::optional<SnapAnswer> snapAt(const ToolContext& context, const Pointer& pointer) const override;

  private:
    /// The first end, while its body is there.
    std::optional<ConnectorEnd> from(const ToolContext& context) const;

    std::optional<ConnectorEnd> m_from;       // the first of two clicks
    std::shared_ptr<const Level> m_pressedOn; // the level when the button went down
    std::string m_refusal;                    // code of the hint that says why the last click or drag did nothing
    Vec2 m_refusedAt{0, 0};                   // pixels, where the pointer was then
};

} // namespace spacetow
