#pragma once
// The static bodies' parts, in world coordinates.

#include "core/geometry/part.h"
#include "core/geometry/static_quadtree.h"
#include "core/geometry/wall_back_tree.h"
#include "core/geometry/wall_side.h"
#include "core/math/aabb.h"
#include "core/physics/lanes/wide.h"

#include <cstdint>
#include <vector>

namespace spacetow {

/// Parts of static bodies in world coordinates; immutable, shared between copies of a world.
struct StaticGeometry {
    struct Collider {
        Slot body;
        std::uint32_t part;
        Part shape;
        Aabb bounds;   // of what is solid
        WallSide side; // of an edge
    };
    std::vector<Collider> colliders; // by body and part
    StaticQuadtree tree;             // of their bounds; of edges that are deeper than long without what is behind them
    WallBackTree backs;              // of those
};

/// What has become of static bodies since the geometry of all was made. Likewise immutable.
struct StaticChanges {
    std::vector<Slot> bodies;        // sorted: added, moved, switched or removed since
    std::vector<std::uint32_t> gone; // sorted: colliders of all that count no longer
    StaticGeometry geometry;         // what counts instead: parts of these bodies, and what is or was joined to them
};

} // namespace spacetow
