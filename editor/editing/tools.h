#pragma once
// Every tool of the program as one table. The toolbox makes its tools from it; what each is called, and its key, stands
// in editor/window/actions_tools.cpp. A new tool is a pair of files, an enumerator and a row in either table; nothing
// else needs to hear of it.

#include "editor/editing/tool.h"

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string_view>

namespace spacetow {

enum class ToolId : std::uint8_t {
    Select,
    Nodes,
    Edge,
    Line,
    Polygon,
    Rectangle,
    Circle,
    Kinematic,
    Connector,
    Ship,
    Payload,
    Finish,
    Knife,
    Measure,
};

struct ToolRow {
    ToolId id;
    std::unique_ptr<Tool> (*make)();
    std::span<const std::string_view> hints; // every code of a hint that it, or others of its class, may give
};

/// In the order of ToolId.
std::span<const ToolRow> toolRows();

/// The things of which a level has one, in the order in which a key goes through them.
inline constexpr std::array placeTools{ToolId::Ship, ToolId::Payload, ToolId::Finish};

/// Whether the level has what that one of them places.
bool hasPlaced(const Level& level, ToolId placeTool);

/// What an empty level is begun with: walls, and two things that fall.
inline constexpr ToolId wallTool = ToolId::Edge;
inline constexpr std::array solidTools{ToolId::Rectangle, ToolId::Circle};

/// Whether the tool draws bodies that may fall; see Toolbox::drawnSolids.
constexpr bool drawsSolids(ToolId tool) {
    return tool == ToolId::Polygon || tool == ToolId::Rectangle || tool == ToolId::Circle;
}

} // namespace spacetow
