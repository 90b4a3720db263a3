#pragma once
// The two drags of the select tool: moving objects, and the rubber band.

#include "editor/editing/marquee_gesture.h"
#include "editor/editing/snap_point.h"

namespace spacetow {

/// Moves the selection of the edit it starts with. What snaps to the grid is the place of one object, `reference`, so
/// that what is on the grid stays on it; to other objects the points near the pointer snap too, and the bounds align.
/// Shift keeps to one axis. The pivot goes along.
class MoveGesture : public Gesture {
  public:
    MoveGesture(const ToolContext& context, const Pointer& start, const Vec2& reference);

    Edit at(const Pointer& pointer) const override;
    Label label() const override;
    Overlay overlay(const Pointer& pointer) const override;
    Hint hint(const Pointer& pointer) const override;
    CursorShape cursor(const Pointer&) const override { return CursorShape::Move; }
    std::optional<Affine> map(const Pointer& pointer) const override { return Affine::translation(deltaAt(pointer)); }
    std::optional<SnapAnswer> snapAt(const Pointer& pointer) const override;

  private:
    Vec2 deltaAt(const Pointer& pointer) const { return snapAt(pointer)->point - m_reference; }

    Edit m_edit;
    std::vector<Key> m_keys; // that move: what is locked stays
    Vec2 m_start;
    Vec2 m_reference;
    DraggedSnap m_snap;
};

/// Selects what the band touches, with Alt what lies wholly inside; `extends` adds to what was selected.
class BandGesture : public MarqueeGesture {
  public:
    BandGesture(const Edit& edit, const Vec2& start, bool extends)
        : MarqueeGesture(edit, start, MarqueeShape::Box), m_extends(extends) {}

    Edit at(const Pointer& pointer) const override;
    Hint hint(const Pointer& pointer) const override;

  private:
    bool m_extends;
};

} // namespace spacetow
