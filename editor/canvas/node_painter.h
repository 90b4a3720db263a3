#pragma once
// The nodes of objects in edit: squares, circles at the ends of open chains, a diamond at the first node; arrow heads
// on one-way walls tell their direction.

#include "editor/canvas/stage.h"
#include "editor/editing/overlay.h"
#include "editor/editing/selection.h"

namespace spacetow {

/// Looks at what is in view only; nodes that would run together are left out unless selected.
void paintNodes(const Stage& stage, const Level& level, const Selection& selection, const OverlayNodes& nodes);

} // namespace spacetow
