#pragma once
// The drags of the handles around a selection: scaling, turning, and placing the pivot. See handles.h.

#include "core/math/affine.h"
#include "editor/editing/handles.h"
#include "editor/editing/snap_point.h"

namespace spacetow {

/// A handle that is being dragged.
struct HandleDrag {
    ToolContext context;
    HandleFrame frame;
    HandleSide side;
    Vec2 start; // pointer when the button went down
};

/// About the opposite side; with Shift about the pivot, or the middle where none was set. Ctrl keeps the proportions,
/// Alt inverts the grid, on which the dragged side lands; sides that slant have no grid, but their lengths are
/// multiples of its step. Through zero it mirrors, at zero it stops just before.
class ScaleGesture : public Gesture {
  public:
    explicit ScaleGesture(const HandleDrag& drag);

    Edit at(const Pointer& pointer) const override;
    Label label() const override;
    Overlay overlay(const Pointer& pointer) const override;
    Hint hint(const Pointer& pointer) const override;
    CursorShape cursor(const Pointer&) const override {
        return handleCursor(m_drag.side, HandleMode::Scale, m_drag.frame.turn);
    }
    std::optional<Affine> map(const Pointer& pointer) const override;
    std::optional<SnapAnswer> snapAt(const Pointer& pointer) const override;

  private:
    Vec2 fixedPoint(const Pointer& pointer) const;
    Vec2 inFrame(const Vec2& world) const { return m_drag.frame.turn.inverse() * world; }
    Vec2 targetAt(const Pointer& pointer) const; // in the axes of the frame
    Vec2 inSteps(const Pointer& pointer, const Vec2& target) const;
    Vec2 factorsAt(const Pointer& pointer) const;
    bool keepsShape(const Pointer& pointer) const { return pointer.modifiers.ctrl || m_drag.frame.keepsShape; }

    HandleDrag m_drag;
    std::vector<Key> m_keys;
    DraggedSnap m_snap;
};

/// About the pivot, with Shift about the opposite corner; Ctrl keeps to multiples of 15°.
class TurnGesture : public Gesture {
  public:
    explicit TurnGesture(const HandleDrag& drag);

    Edit at(const Pointer& pointer) const override;
    Label label() const override;
    Overlay overlay(const Pointer& pointer) const override;
    Hint hint(const Pointer& pointer) const override;
    CursorShape cursor(const Pointer&) const override { return CursorShape::Pointing; }
    std::optional<Affine> map(const Pointer& pointer) const override;

  private:
    Vec2 pivotAt(const Pointer& pointer) const;
    double angleAt(const Pointer& pointer) const;

    HandleDrag m_drag;
    std::vector<Key> m_keys;
};

/// Places the pivot: on corners, middles of sides and the middle of the bounds when near them, else where points snap.
class PivotGesture : public Gesture {
  public:
    explicit PivotGesture(const HandleDrag& drag) : m_drag(drag), m_snap(drag.context, {}, drag.frame.pivot) {}

    Edit at(const Pointer& pointer) const override;
    Label label() const override { return {}; }
    Overlay overlay(const Pointer& pointer) const override;
    Hint hint(const Pointer& pointer) const override;
    CursorShape cursor(const Pointer&) const override { return CursorShape::Move; }
    bool edits() const override { return false; }
    std::optional<SnapAnswer> snapAt(const Pointer& pointer) const override;

  private:
    Vec2 placeAt(const Pointer& pointer) const { return snapAt(pointer)->point; }

    HandleDrag m_drag;
    DraggedSnap m_snap;
};

} // namespace spacetow
