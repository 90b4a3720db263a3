#pragma once
// The cells in which a game of the level looks for collisions, for the debug overlay while the level is edited.

#include "core/level/level.h"
#include "core/physics/query/queries.h"

#include <vector>

namespace spacetow {

/// Those of both quadtrees at the start of the game, with how many boxes they hold; without ship and payload. Builds
/// the world: a millisecond for a thousand walls.
std::vector<QuadtreeCell> levelCells(const Level& level);

} // namespace spacetow
