#pragma once
// Debug drawing: drawWorld() draws a world with the DebugDraw of the host. It neither changes nor keeps the world: two
// calls with the same world draw the same picture. The host receives coordinates of its picture, see ViewTransform.

#include "core/physics/query/debug_view.h"

#include <span>

namespace spacetow {

/// The data of a body that is drawn. `shapes` is a view.
struct DebugBody {
    BodyKind kind = BodyKind::Dynamic;
    std::span<const Shape> shapes;
    Transform pose;
    Vec2 massCenter{0, 0}; // world
    Vec2 velocity{0, 0};   // of the centre of mass
    Aabb bounds;           // exact; may be empty
    Aabb fatBounds;        // of the broad phase; empty when equal to `bounds`
};

/// Draws the AABBs of a body, then its shapes, then orientation and velocity. The incircle of a polygon lies between
/// filling and outline; the band and the normals of a wall lie below the wall. A static body of walls alone has no
/// orientation. Shapes without extent are not drawn.
void drawBody(const DebugBody& body, const DebugView& view, DebugDraw& draw);

/// Draws, from bottom to top: background; quadtrees; islands, tags and collisions of the selection; static, kinematic
/// and dynamic bodies, each in the order of creation; connectors; tunnelling risks; trails; contacts; centres of mass
/// and names.
void drawWorld(const World& world, const DebugView& view, DebugDraw& draw);

} // namespace spacetow
