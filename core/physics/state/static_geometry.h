#pragma once
// The static bodies' parts, in world coordinates.

#include "core/geometry/part.h"
#include "core/geometry/static_quadtree.h"
#include "core/geometry/wall_back.h"
#include "core/geometry/wall_side.h"
#include "core/math/aabb.h"
#include "core/physics/lanes/wide.h"

#include <cstdint>
#include <vector>

namespace spacetow {

/// The parts of all static bodies in world coordinates; immutable, shared between copies of a world.
struct StaticGeometry {
    struct Collider {
        Slot body;
        std::uint32_t part;
        Part shape;
        Aabb bounds;   // of what is solid; the tree's boxes of edges are larger
        WallSide side; // of an edge
        int back = -1; // index in `backs`
    };
    struct Back {
        std::uint32_t collider;
        WallBack region;
    };
    std::vector<Collider> colliders;
    std::vector<Back> backs; // of edges that have none: solid however deep
    Aabb area;               // within which the tree knows of them
    StaticQuadtree tree;
};

} // namespace spacetow
