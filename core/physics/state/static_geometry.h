#pragma once
// Geometry of static bodies: colliders in world coordinates, and their trees.

#include "core/geometry/part.h"
#include "core/geometry/static_quadtree.h"
#include "core/geometry/wall_back_tree.h"
#include "core/geometry/wall_side.h"
#include "core/math/aabb.h"
#include "core/physics/lanes/wide.h"

#include <cstdint>
#include <vector>

namespace spacetow {

/// Colliders of static bodies in world coordinates, m. Immutable once built; copies of a world share the geometry.
struct StaticGeometry {
    /// One part of a static body.
    struct Collider {
        Slot body;
        std::uint32_t part; // index in the parts of the body
        Part shape;
        Aabb bounds;   // with the solid band behind an edge
        WallSide side; // an edge from its free side, with joints; not set for other shapes
    };
    std::vector<Collider> colliders; // sorted by body and part
    /// Over `bounds`, extended behind hollow joints. A deep edge (depth > length) has the AABB of its segment only.
    StaticQuadtree tree;
    WallBackTree backs; // over the solid regions behind deep edges
};

/// The changes of static bodies since the full geometry (`BroadPhase::statics`) was built. Immutable once built, too.
struct StaticChanges {
    std::vector<Slot> bodies;        // sorted: added, moved, (de)activated or removed
    std::vector<std::uint32_t> gone; // sorted: outdated colliders of the full geometry, by index
    StaticGeometry geometry;         // replaces `gone`: parts of `bodies`, and parts joined to them now or before
};

} // namespace spacetow
