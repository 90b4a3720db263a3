#pragma once
// The lasso: selects what a line drawn round it touches or encloses.

#include "editor/editing/tool.h"

#include <span>
#include <vector>

namespace spacetow {

/// Keys of the objects that touch the area within the closed line, or lie wholly inside it, in the order of the level;
/// not what is hidden or locked.
std::vector<Key> pickedInLasso(const Level& level, std::span<const Vec2> line, bool wholly);

/// Adds to what was selected; with Ctrl only what lies wholly inside.
class LassoGesture : public Gesture {
  public:
    LassoGesture(const Edit& edit, const Vec2& start) : m_edit(edit), m_line{start} {}

    void follow(const Pointer& pointer) override;
    Edit at(const Pointer& pointer) const override;
    Label label() const override { return {}; }
    Overlay overlay(const Pointer& pointer) const override;
    Hint hint(const Pointer& pointer) const override;
    bool edits() const override { return false; }

  private:
    std::vector<Vec2> lineAt(const Pointer& pointer) const;

    Edit m_edit;
    std::vector<Vec2> m_line; // from the start on
};

} // namespace spacetow
