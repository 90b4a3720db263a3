#pragma once
// Every code that the editing layer hands to editor/window/messages, so that a test can ask for a sentence for each.
// The comment names the arguments of the hints that have any.

#include <array>
#include <string_view>

namespace spacetow {

inline constexpr auto hintCodes = std::to_array<std::string_view>({
    "select.idle",
    "select.object",
    "select.group",
    "select.selected-group", // number of objects
    "select.in-group",       // number of objects
    "select.in-named-group", // number of objects, name of the group
    "select.lasso",          // number of objects
    "select.selected",       // number of objects
    "select.moving",         // m to the right, m upwards
    "select.band",           // number of objects
    "select.scale-handle",
    "select.scaling", // width, height in m, width, height in %
    "select.turn-handle",
    "select.turning", // degrees
    "select.pivot-handle",
    "select.pivot", // x, y in m
    "select.node",
    "nodes.none",
    "nodes.without",
    "nodes.idle",
    "nodes.object",
    "nodes.selected", // number of nodes
    "nodes.node",
    "nodes.segment",
    "nodes.insert",
    "nodes.moving",          // m to the right, m upwards
    "nodes.moving-together", // m to the right, m upwards
    "nodes.together",
    "nodes.crosses",
    "nodes.scale-handle",
    "nodes.turn-handle",
    "nodes.scaling", // width, height in m
    "nodes.turning", // degrees
    "nodes.band",    // number of nodes
    "nodes.lasso",   // number of nodes
    "knife.idle",
    "knife.selected", // number of objects
    "knife.cutting",  // number of places
    "knife.nothing",
    "draw-edge.start",
    "draw-edge.next",  // number of points, m, degrees
    "draw-edge.close", // number of points
    "draw-edge.too-few",
    "draw-edge.same-point",
    "draw-edge.extend",
    "draw-edge.close-chain",
    "draw-line.start",
    "draw-line.next",
    "draw-line.close",
    "draw-line.too-few",
    "draw-line.same-point",
    "draw-line.extend",
    "draw-line.close-chain",
    "draw-polygon.start",
    "draw-polygon.next",
    "draw-polygon.close",
    "draw-polygon.too-few",
    "draw-polygon.same-point",
    "draw-polygon.crossing",
    "draw-polygon.crossed",
    "draw-polygon.crosses",
    "draw-polygon.flat",
    "draw-rectangle.start",
    "draw-rectangle.size", // width, height in m
    "draw-rectangle.too-small",
    "draw-kinematic.start",
    "velocity.drawing",  // m/s, degrees
    "velocity.dragging", // m/s, degrees
    "velocity.handle",
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
    "typing.length-angle",
    "typing.speed-angle",
    "typing.width-height",
    "typing.radius",
    "typing.no-number", // what was typed
    "typing.no-angle",  // what was typed
    "typing.too-small", // what was typed
    "draw-circle.start",
    "draw-circle.radius", // m
    "draw-circle.too-small",
    "place-ship.start",
    "place-ship.turning", // degrees
    "place-payload.start",
    "place-payload.moving", // x, y in m
    "place-finish.start",
    "place-finish.end", // m, degrees
    "place-finish.too-short",
    "measure.start",
    "measure.first", // m, m across, m upwards, degrees
    "measure.same-point",
    "measure.done",   // as the first
    "measure.second", // and degrees between the legs
    "measure.angle",  // degrees, m, m
    "guide.hover",
    "guide.new", // x, y in m, degrees
    "guide.outside",
    "guide.moving", // x, y in m, degrees
    "guide.delete",
});

inline constexpr auto labelCodes = std::to_array<std::string_view>({
    "draw-edge",      "draw-line",       "draw-polygon",
    "draw-circle",    "draw-rectangle",  "draw-kinematic",
    "draw-connector", "set-velocity",    "extend-chain",
    "place-ship",     "place-payload",   "place-finish",
    "move",           "rotate",          "scale",
    "flip",           "align",           "distribute",
    "order",          "group",           "ungroup",
    "new-layer",      "to-layer",        "hide",
    "isolate",        "show-all",        "lock",
    "unlock-all",     "repeat",          "array",
    "union",          "difference",      "intersection",
    "reverse",        "delete",          "move-nodes",
    "rotate-nodes",   "scale-nodes",     "insert-nodes",
    "delete-nodes",   "delete-segments", "join-nodes",
    "break-nodes",    "reverse-part",    "straighten-nodes",
    "knife",          "duplicate",       "cut",
    "regroup",        "rename",          "show",
    "unlock",         "paste",           "add-guide",
    "change-guide",   "delete-guide",    "clear-guides",
});

} // namespace spacetow
