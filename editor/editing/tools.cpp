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

namespace spacetow {

namespace {

template <class Made, auto... arguments>
std::unique_ptr<Tool> make() {
    return std::make_unique<Made>(arguments...);
}

constexpr ToolRow rows[] = {
    {ToolId::Select, make<SelectTool>},
    {ToolId::Nodes, make<NodeTool>},
    {ToolId::Edge, make<DrawTool, DrawKind::Edge>},
    {ToolId::Line, make<DrawTool, DrawKind::Line>},
    {ToolId::Polygon, make<DrawTool, DrawKind::Polygon>},
    {ToolId::Rectangle, make<RectangleTool>},
    {ToolId::Circle, make<CircleTool>},
    {ToolId::Kinematic, make<KinematicTool>},
    {ToolId::Connector, make<ConnectorTool>},
    {ToolId::Ship, make<PlaceTool, PlaceKind::Ship>},
    {ToolId::Payload, make<PlaceTool, PlaceKind::Payload>},
    {ToolId::Finish, make<PlaceTool, PlaceKind::Finish>},
    {ToolId::Knife, make<KnifeTool>},
    {ToolId::Measure, make<MeasureTool>},
};

} // namespace

std::span<const ToolRow> toolRows() {
    return rows;
}

} // namespace spacetow
