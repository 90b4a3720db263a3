#pragma once
// The handles around a selection: eight that scale it, or four that turn it and the pivot about which they do. They
// stand a little outside its bounds, so that they never cover what they belong to; around a single body that is turned
// they are turned with it. World coordinates, m.

#include "editor/editing/tool.h"

#include <memory>
#include <optional>
#include <vector>

namespace spacetow {

/// After a second click they turn. What has no size turns from the first one on: without a pivot, which would lie on
/// it.
enum class HandleMode : std::uint8_t { Scale, TurnAtOnce, Turn };

/// What the handles of a selection act on.
struct HandleFrame {
    Aabb box;                // of all that is selected and not locked, without connectors; empty: no handles
    Rot turn;                // of the axes in which the box is one: those of a single body
    Vec2 pivot{0, 0};        // about which it turns
    bool scales = false;     // something in it has a size that may change: not the ship
    bool keepsShape = false; // a single ball stays one

    bool isTurned() const { return turn != Rot(); }
};

/// Which handle: to the left, in the middle or to the right (−1, 0, 1), likewise below to above; the middle of both is
/// the pivot.
struct HandleSide {
    int x = 0;
    int y = 0;

    bool isPivot() const { return x == 0 && y == 0; }
    bool isCorner() const { return x != 0 && y != 0; }
    bool operator==(const HandleSide&) const = default;
};

struct Handle {
    HandleSide side;
    Vec2 at;
};

HandleFrame handleFrame(const ToolContext& context);
/// The point of the box to which the handle belongs.
Vec2 pointOf(const Aabb& box, const HandleSide& side);
/// Of the frame, in the world.
Vec2 pointOf(const HandleFrame& frame, const HandleSide& side);
/// Along the axes of the frame; the point stays where it is.
Affine scalingIn(const HandleFrame& frame, const Vec2& fixed, const Vec2& factors);
/// None that could do nothing: no height, no handles above and below. `pixel` is the size of one, m.
std::vector<Handle> handlesOf(const HandleFrame& frame, HandleMode mode, double pixel);
/// Whether the pivot lies on something so small that it would be in the way of every drag: then it goes with Shift
/// only.
bool coversSelection(const HandleFrame& frame, double pixel);
/// The nearest one under the pointer that a press would take.
std::optional<Handle> handleAt(const HandleFrame& frame, HandleMode mode, const Pointer& pointer);

/// The drag of that handle.
std::unique_ptr<Gesture> dragOf(const Handle& handle, HandleMode mode, const ToolContext& context,
                                const Pointer& start);

Overlay handleOverlay(const HandleFrame& frame, HandleMode mode, double pixel, const std::optional<Handle>& hot);
CursorShape handleCursor(const HandleSide& side, HandleMode mode, const Rot& turn);
Hint handleHint(const Handle& handle, HandleMode mode);

} // namespace spacetow
