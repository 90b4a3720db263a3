#pragma once
// The bodies that a connector joins, and where on them it is anchored. World coordinates, m.

#include "editor/editing/tool.h"

#include <optional>
#include <string>

namespace spacetow {

struct ConnectorEnd {
    Key body = 0;
    Vec2 at{0, 0};
    SnapKind kind = SnapKind::None; // what of the body it has snapped to, or the grid
};

/// The end that a connector would have at the pointer: on the topmost body there, at its nearest node, middle or anchor
/// when one is near, else on the grid where that lies on the body. Where no body is, at the anchor of one that is
/// there; else nothing.
std::optional<ConnectorEnd> connectorEndAt(const ToolContext& context, const Pointer& pointer);
/// For the marker.
std::optional<SnapAnswer> snapAnswerOf(const std::optional<ConnectorEnd>& end);
/// Whether something that is no body lies under the pointer: a ship, a payload, a finish.
bool isOnOtherThing(const ToolContext& context, const Pointer& pointer);

/// How much a connector can do between two bodies.
enum class ConnectorFault : std::uint8_t { None, SameBody, NothingMoves };
ConnectorFault faultBetween(const Level& level, Key a, Key b);

/// A connector as long as its ends are apart, selected. Anchors are turned with their bodies.
Edit withConnector(const ToolContext& context, const ConnectorEnd& a, const ConnectorEnd& b);

} // namespace spacetow
