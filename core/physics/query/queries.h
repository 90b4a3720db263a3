#pragma once
// Questions about where things are in a world. None of them changes it, and all see bodies where they are now, added
// and moved ones included. What is inactive is not there; what is intangible is. Walls are segments, whatever their
// depth, except where boxes are asked for.

#include "core/math/aabb.h"
#include "core/physics/world/world.h"

#include <limits>
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
/// Bodies whose exact bounding box overlaps `box`, in the order in which they were added. A body has one box for all
/// of its shapes.
std::vector<BodyId> bodiesIn(const World& world, const Aabb& box);

struct NearestPoint {
    BodyId body;
    Vec2 point;      // world: on the body, or the point asked for when it is inside
    double distance; // m, 0 inside
};

/// What to look for: bodies no farther away than `reach` metres whose tags meet `mask`.
struct SearchLimits {
    double reach = std::numeric_limits<double>::infinity();
    TagMask mask = TagMask::all();
};

/// The body nearest to `point`; of several that are equally near the one that was added first.
std::optional<NearestPoint> closestBody(const World& world, const Vec2& point, const SearchLimits& limits = {});

/// The cells of both quadtrees, for the debug overlay: the leaves, clipped to the bounds of what they hold.
std::vector<Aabb> quadtreeCells(const World& world);

struct QuadtreeCell {
    Aabb box;
    int held = 0;        // boxes of shapes that overlap it
    bool moving = false; // of the tree of moving bodies

    bool operator==(const QuadtreeCell&) const = default;
};

/// Those that overlap `area`, with what they hold: linear in these.
std::vector<QuadtreeCell> occupiedCells(const World& world, const std::optional<Aabb>& area = {});

/// What a body belongs to: bodies that are awake and have the same number may push each other, those that sleep wake
/// together; see core/physics/solver/contact_graph.h. As the last update had it; none for what nothing can move, and
/// for what is new.
std::optional<std::uint32_t> islandOf(const World& world, BodyId body);

} // namespace spacetow
