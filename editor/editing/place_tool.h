#pragma once
// Puts down the things of which a level has one: ship, payload, finish. Placing again moves the one that is there.

#include "editor/editing/tool.h"

#include <array>
#include <string_view>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

namespace spacetow {

/// What a place tool puts down.
enum class PlaceKind : std::uint8_t { Ship, Payload, Finish };

class PlaceTool : public Tool {
  public:
    static constexpr auto hints = std::to_array<std::string_view>({
        "place-ship.start",
        "place-ship.turning", // degrees
        "place-payload.start",
        "place-payload.moving", // x, y in m
        "place-finish.start",
        "place-finish.end", // m, degrees
        "place-finish.too-short",
    });

    explicit PlaceTool(PlaceKind kind) : m_kind(kind) {}

    std::string code() const override;
    /// Drags turn the ship, carry the payload or draw the finish.
    std::unique_ptr<Gesture> press(const ToolContext& context, const Pointer& pointer) override;
    std::optional<FinishedEdit> click(const ToolContext& context, const Pointer& pointer) override;
    std::optional<FinishedEdit> key(const ToolContext& context, ToolKey key, const Pointer& pointer) override;
    void hover(const ToolContext& context, const Pointer& pointer) override;
    std::optional<TypedMeasures> measures(const ToolContext& context, const Pointer& pointer) const override;
    bool isBusy() const override { return m_finishStart.has_value(); }
    void cancel() override;

    Overlay overlay(const ToolContext& context, const Pointer& pointer) const override;
    Hint hint(const ToolContext& context, const Pointer& pointer) const override;
    CursorShape cursor(const ToolContext&, const Pointer&) const override { return CursorShape::Cross; }
    std::optional<SnapAnswer> snapAt(const ToolContext& context, const Pointer& pointer) const override;

  private:
    std::optional<FinishedEdit> clickFinish(const ToolContext& context, const Pointer& pointer);

    PlaceKind m_kind;
    std::optional<Vec2> m_finishStart; // world; the first of two clicks
    bool m_tooShort = false;           // the last click was refused
};

} // namespace spacetow
