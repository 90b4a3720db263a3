#pragma once
// Questions about where things are in a world. None of them changes it.

#include "core/math/aabb.h"
#include "core/physics/world.h"

#include <optional>
#include <vector>

namespace spacetow {

struct RayHit {
    BodyId body;
    Vec2 point;      // world
    Vec2 normal;     // unit, out of the surface hit
    double fraction; // 0 at the start, 1 at the end
};

/// The first active body on the way from → to whose tags meet `mask`; one-way edges are hit from the front only.
std::optional<RayHit> rayCast(const World& world, const Vec2& from, const Vec2& to, TagMask mask = TagMask::all());
/// Bodies that contain the point (circles and polygons), in the order in which they were added.
std::vector<BodyId> bodiesAt(const World& world, const Vec2& point);
/// Bodies whose exact bounding box overlaps `box`, in the order in which they were added.
std::vector<BodyId> bodiesIn(const World& world, const Aabb& box);

/// The cells of both quadtrees, for the debug overlay: the leaves, clipped to the bounds of what they hold.
std::vector<Aabb> quadtreeCells(const World& world);

} // namespace spacetow
