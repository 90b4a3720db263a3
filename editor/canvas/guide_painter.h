#pragma once
// Guides, over the level and under the selection: dash-dotted lines from edge to edge of the view, with a ring at the
// point of each and its name.

#include "core/level/level.h"
#include "editor/canvas/stage.h"

#include <cstddef>
#include <optional>

namespace spacetow {

/// `hot` is the one that the pointer would take.
void paintGuides(const Stage& stage, const Level& level, std::optional<std::size_t> hot);

} // namespace spacetow
