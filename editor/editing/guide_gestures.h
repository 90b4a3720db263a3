#pragma once
// Guides under the mouse: a new one comes out of a ruler, one that is there is moved or turned, and goes when it is
// dragged back onto a ruler, which is beyond the upper or left border of the view.

#include "editor/editing/snap_point.h"

#include <cstddef>
#include <optional>

namespace spacetow {

/// The guide that a press here takes, by its index: the nearest one, where no object is in the way.
std::optional<std::size_t> guideInReach(const ToolContext& context, const Pointer& pointer);

/// Out of a ruler; the guide has the given angle in radians.
class NewGuideGesture : public Gesture {
  public:
    NewGuideGesture(const ToolContext& context, double angle);

    Edit at(const Pointer& pointer) const override;
    Label label() const override { return {"add-guide"}; }
    Overlay overlay(const Pointer& pointer) const override;
    Hint hint(const Pointer& pointer) const override;
    std::optional<SnapAnswer> snapAt(const Pointer& pointer) const override;

  private:
    Guide made(const Pointer& pointer) const;

    ToolContext m_context;
    Edit m_start;
    double m_angle;
};

/// The point of the guide follows the pointer; with Shift the guide turns about its point instead, in steps of 15°
/// where points snap.
class MoveGuideGesture : public Gesture {
  public:
    MoveGuideGesture(const ToolContext& context, std::size_t index);

    Edit at(const Pointer& pointer) const override;
    Label label() const override { return {"change-guide"}; }
    bool scrolls() const override { return false; } // rulers are beyond the edges
    Overlay overlay(const Pointer& pointer) const override;
    Hint hint(const Pointer& pointer) const override;
    std::optional<SnapAnswer> snapAt(const Pointer& pointer) const override;

  private:
    Guide changed(const Pointer& pointer) const;

    Edit m_start;
    SnapSettings m_settings;
    std::size_t m_index;
    DraggedSnap m_snap;
};

} // namespace spacetow
