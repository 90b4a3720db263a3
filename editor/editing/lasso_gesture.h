#pragma once
// The lasso: selects what a line drawn round it touches or encloses.

#include "editor/editing/marquee_gesture.h"

#include <span>
#include <vector>

namespace spacetow {

/// Keys of the objects that touch the area within the closed line, or lie wholly inside it, in the order of the level;
/// not what is hidden or locked.
std::vector<Key> pickedInLasso(const Level& level, std::span<const Vec2> line, bool wholly);

/// Adds to what was selected; with Ctrl only what lies wholly inside.
class LassoGesture : public MarqueeGesture {
  public:
    LassoGesture(const Edit& edit, const Vec2& start) : MarqueeGesture(edit, start, MarqueeShape::Lasso) {}

    Edit at(const Pointer& pointer) const override;
    Hint hint(const Pointer& pointer) const override;
};

} // namespace spacetow
