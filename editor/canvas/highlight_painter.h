#pragma once
// Marks objects that are not selected but concern the selection: what it would collide with.

#include "core/level/level.h"
#include "editor/canvas/stage.h"

#include <span>

namespace spacetow {

/// The keys are ascending. Only what is in view costs time.
void paintHighlight(const Stage& stage, const Level& level, std::span<const Key> keys);

} // namespace spacetow
