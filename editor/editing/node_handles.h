#pragma once
// The handles around two or more selected nodes: eight that scale them, or four that turn them. World coordinates, m.

#include "editor/editing/tool.h"

#include <memory>
#include <optional>
#include <vector>

namespace spacetow {

/// To the left, in the middle or to the right of the bounds (−1, 0, 1); likewise below to above.
struct NodeHandle {
    int x = 0;
    int y = 0;
    Vec2 at{0, 0};
};

/// Those that could do anything. `pixel` is the size of one, m.
std::vector<NodeHandle> nodeHandles(const Edit& edit, bool turns, double pixel);
std::optional<NodeHandle> nodeHandleAt(const Edit& edit, bool turns, const Pointer& pointer);
/// Scales about the opposite side, with Shift about the middle, with Ctrl in proportion; Alt inverts the grid. Or turns
/// about the pivot or the middle, with Ctrl in steps of 15°. Nodes of others at the same places come along.
std::unique_ptr<Gesture> dragOfNodeHandle(const ToolContext& context, const NodeHandle& handle, bool turns,
                                          const Pointer& start);

} // namespace spacetow
