#pragma once
// Drawing for inspection: drawWorld tells the host's DebugDraw what there is to see. The call neither changes nor keeps
// anything of the world: two calls with the same world draw the same picture. The host receives coordinates of its
// picture, see ViewTransform.

#include "core/physics/query/debug_view.h"

#include <span>

namespace spacetow {

/// What is drawn of a body; the shapes must outlive it.
struct DebugBody {
    BodyKind kind = BodyKind::Dynamic;
    std::span<const Shape> shapes;
    Transform pose;
    Vec2 massCenter{0, 0}; // world
    Vec2 velocity{0, 0};   // of the centre of mass
    Aabb bounds;           // exact; may be empty
    Aabb fatBounds;        // of the broad phase; empty when it is no other
};

/// Its boxes; each shape, a polygon's incircle between its filling and its outline and a wall's band and normals below
/// the wall; orientation and velocity once. Static walls have no orientation. Shapes without extent are left out.
void drawBody(const DebugBody& body, const DebugView& view, DebugDraw& draw);

/// Background; quadtrees; islands, tags and what meets the selection; static, kinematic, dynamic bodies, each in the
/// order in which they were added; connectors; the risk of walls; trails; contacts; centres of mass and names.
void drawWorld(const World& world, const DebugView& view, DebugDraw& draw);

} // namespace spacetow
