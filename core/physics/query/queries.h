#pragma once
// Queries for the debug overlays: the cells of the quadtrees, and the islands. No query changes the world.

#include "core/math/aabb.h"
#include "core/physics/world/world.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace spacetow {

/// A leaf of a quadtree, clipped to the bounds of what it holds.
struct QuadtreeCell {
    Aabb box;
    int held = 0;        // AABBs of shapes that overlap it
    bool moving = false; // of the tree of moving bodies

    bool operator==(const QuadtreeCell&) const = default;
};

/// The leaves of both quadtrees; with `area`, those that overlap it. A pass over all leaves, and a query of the tree
/// for each that is returned.
std::vector<QuadtreeCell> occupiedCells(const World& world, const std::optional<Aabb>& area = {});

/// The group of a body. Awake bodies with the same number may push each other (core/physics/solver/contact_graph.h);
/// sleeping ones wake together (core/physics/sleep/sleep.h). As of the last update; none for a body that nothing can
/// move, and for one that was added since.
std::optional<std::uint32_t> islandOf(const World& world, BodyId body);

} // namespace spacetow
