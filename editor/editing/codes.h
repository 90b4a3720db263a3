#pragma once
// The codes that the editing layer hands to editor/window/messages, so that a test can ask for a sentence for each. The
// comment names the arguments of the hints that have any.

#include "core/level/codes.h"

#include <array>
#include <string_view>

namespace spacetow {

/// Hints that come from no single tool. Those of a tool stand in its class.
inline constexpr auto sharedHintCodes = std::to_array<std::string_view>({
    "velocity.drawing",  // m/s, degrees
    "velocity.dragging", // m/s, degrees
    "velocity.handle",
    "typing.length-angle",
    "typing.speed-angle",
    "typing.width-height",
    "typing.radius",
    "typing.no-number", // what was typed
    "typing.no-angle",  // what was typed
    "typing.too-small", // what was typed
    "guide.hover",
    "guide.new", // x, y in m, degrees
    "guide.outside",
    "guide.moving", // x, y in m, degrees
    "guide.delete",
});

/// What edits are called, also those that panels and windows make.
inline constexpr std::string_view labelCodes[] = {
    "draw-edge",
    "draw-line",
    "draw-polygon",
    "draw-circle",
    "draw-rectangle",
    "draw-kinematic",
    "draw-connector",
    "set-velocity",
    "extend-chain",
    "place-ship",
    "place-payload",
    "place-finish",
    "reopen",
    "move",
    "rotate",
    "scale",
    "flip",
    "align",
    "distribute",
    "order",
    "group",
    "ungroup",
    "to-layer",
    "regroup",
    "rename",
    "show",
    "unlock",
    "hide",
    "isolate",
    "lock",
    "repeat",
    "new-layer",
    "show-all",
    "unlock-all",
    "array",
    "union",
    "difference",
    "intersection",
    "fix-all",
    "hide-problem",
    "show-problem",
    "reverse",
    "take-over",
    "run-edits",
    "end-run",
    "keep-level",
    "keep-added",
    "keep-removed",
    "keep-moved",
    "keep-tags",
    "keep-order",
    "keep-change",
    "delete",
    "move-nodes",
    "rotate-nodes",
    "scale-nodes",
    "insert-nodes",
    "delete-nodes",
    "delete-segments",
    "join-nodes",
    "break-nodes",
    "reverse-part",
    "straighten-nodes",
    "knife",
    "duplicate",
    "cut",
    "change",
    "change-level",
    "change-tags",
    "change-tag",
    "paste",
    "reload",
    "recover",
    "open-backup",
    "import",
    "add-guide",
    "change-guide",
    "delete-guide",
    "clear-guides",
};

using LabelCode = FixCode::And<labelCodes>;

} // namespace spacetow
