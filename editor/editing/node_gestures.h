#pragma once
// The drags of the node tool: moving nodes, and choosing them with a band or a lasso.

#include "editor/editing/marquee_gesture.h"
#include "editor/editing/snap_point.h"

#include <vector>

namespace spacetow {

/// What is to be moved; the point that snaps is `reference`, the node that was grabbed.
struct NodeDrag {
    std::vector<NodeRef> nodes; // ascending
    Vec2 reference{0, 0};
    Vec2 start{0, 0}; // pointer when the button went down
};

/// Nodes of others at the same places come along, with Alt they stay. Shift keeps to one axis. The selection stays
/// that of the edit it starts with.
class MoveNodesGesture : public Gesture {
  public:
    MoveNodesGesture(const ToolContext& context, NodeDrag drag);

    Edit at(const Pointer& pointer) const override;
    Label label() const override;
    Overlay overlay(const Pointer& pointer) const override;
    Hint hint(const Pointer& pointer) const override;
    CursorShape cursor(const Pointer&) const override { return CursorShape::Move; }
    std::optional<SnapAnswer> snapAt(const Pointer& pointer) const override;

  private:
    Vec2 deltaAt(const Pointer& pointer) const { return snapAt(pointer)->point - m_drag.reference; }

    Edit m_edit;
    NodeDrag m_drag;
    std::vector<NodeRef> m_together; // with those at the same places
    DraggedSnap m_snap;
};

/// Selects the nodes of the objects in edit that lie inside; `extends` adds to those that are selected.
class NodeBandGesture : public MarqueeGesture {
  public:
    NodeBandGesture(const Edit& edit, const Vec2& start, MarqueeShape shape, bool extends);

    Edit at(const Pointer& pointer) const override;
    Overlay overlay(const Pointer& pointer) const override;
    Hint hint(const Pointer& pointer) const override;

  private:
    std::vector<Key> m_keys;
    bool m_extends;
};

} // namespace spacetow
