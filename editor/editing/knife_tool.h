#pragma once
// Cuts along a line that is dragged: what is selected, or everything where nothing is.

#include "editor/editing/tool.h"

#include <array>
#include <string_view>

namespace spacetow {

class KnifeTool : public Tool {
  public:
    static constexpr auto hints = std::to_array<std::string_view>({
        "knife.idle",
        "knife.selected", // number of objects
        "knife.cutting",  // number of places
        "knife.nothing",
    });

    std::string code() const override { return "knife"; }
    std::unique_ptr<Gesture> press(const ToolContext& context, const Pointer& pointer) override;

    Overlay overlay(const ToolContext& context, const Pointer& pointer) const override;
    Hint hint(const ToolContext& context, const Pointer& pointer) const override;
    CursorShape cursor(const ToolContext&, const Pointer&) const override { return CursorShape::Cross; }
    std::optional<SnapAnswer> snapAt(const ToolContext& context, const Pointer& pointer) const override;
};

} // namespace spacetow
