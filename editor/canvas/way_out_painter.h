#pragma once
// Shows how the ship gets out of its cave: a dashed line with arrows from where it starts to the outside.

#include "editor/canvas/stage.h"

#include <span>

namespace spacetow {

/// The way in world coordinates, m. `isStrong`: it is what the user looks at. Only what is in view costs time.
void paintWayOut(const Stage& stage, std::span<const Vec2> way, QColor color, bool isStrong);

} // namespace spacetow
