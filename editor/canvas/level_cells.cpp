#include "editor/canvas/level_cells.h"

#include "core/level/build.h"

namespace spacetow {

std::vector<QuadtreeCell> levelCells(const Level& level) {
    World world = builtWorld(level).world;
    // The trees are made by an update; one that takes no time to speak of leaves everything where it is.
    world.update({.gravity = Vec2(0, 0), .seconds = 1e-6, .iterations = 1, .substeps = 1});
    return occupiedCells(world);
}

} // namespace spacetow
