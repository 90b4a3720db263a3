#include "editor/editing/tools.h"

#include "editor/editing/circle_tool.h"
#include "editor/editing/connector_tool.h"
#include "editor/editing/draw_tool.h"
#include "editor/editing/kinematic_tool.h"
#include "editor/editing/knife_tool.h"
#include "editor/editing/measure_tool.h"
#include "editor/editing/node_tool.h"
#include "editor/editing/place_tool.h"
#include "editor/editing/rectangle_tool.h"
#include "editor/editing/select_tool.h"

#include <algorithm>

namespace spacetow {

namespace {

template <class Made, auto... arguments>
constexpr ToolRow row(ToolId id) {
    return {id, [] { return std::unique_ptr<Tool>(std::make_unique<Made>(arguments...)); }, Made::hints};
}

constexpr ToolRow rows[] = {
    row<SelectTool>(ToolId::Select),
    row<NodeTool>(ToolId::Nodes),
    row<DrawTool, DrawKind::Edge>(ToolId::Edge),
    row<DrawTool, DrawKind::Line>(ToolId::Line),
    row<DrawTool, DrawKind::Polygon>(ToolId::Polygon),
    row<RectangleTool>(ToolId::Rectangle),
    row<CircleTool>(ToolId::Circle),
    row<KinematicTool>(ToolId::Kinematic),
    row<ConnectorTool>(ToolId::Connector),
    row<PlaceTool, PlaceKind::Ship>(ToolId::Ship),
    row<PlaceTool, PlaceKind::Payload>(ToolId::Payload),
    row<PlaceTool, PlaceKind::Finish>(ToolId::Finish),
    row<KnifeTool>(ToolId::Knife),
    row<MeasureTool>(ToolId::Measure),
};

constexpr bool areInOrder() {
    for (std::size_t i = 0; i < std::size(rows); ++i) {
        if (static_cast<std::size_t>(rows[i].id) != i) {
            return false;
        }
    }
    return true;
}
static_assert(areInOrder(), "a row for each ToolId, in their order");

} // namespace

std::span<const ToolRow> toolRows() {
    return rows;
}

bool hasPlaced(const Level& level, ToolId placeTool) {
    const std::array<const Object*, placeTools.size()> placed{firstOf<ShipObject>(level), firstOf<PayloadObject>(level),
                                                              firstOf<FinishObject>(level)};
    const auto which = std::ranges::find(placeTools, placeTool) - placeTools.begin();
    return placed[static_cast<std::size_t>(which)] != nullptr;
}

} // namespace spacetow
