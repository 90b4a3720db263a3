#pragma once
// Writes on the canvas what each object is: the names of its tags, each after a dot in the tag's colour.

#include "core/level/level.h"
#include "editor/canvas/stage.h"

namespace spacetow {

/// Only of objects in view that are large enough on the screen to carry a label, and of some hundreds at most.
void paintTags(const Stage& stage, const Level& level);

} // namespace spacetow
