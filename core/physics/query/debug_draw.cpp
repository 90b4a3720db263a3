#include "core/physics/query/debug_draw.h"

#include "core/geometry/bounds.h"
#include "core/geometry/polygon.h"
#include "core/physics/query/debug_layers.h"
#include "core/physics/state/world_data.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace spacetow {

namespace {

bool isWall(const Shape& shape) {
    return std::holds_alternative<Edge>(shape) || std::holds_alternative<Line>(shape);
}

/// Draws the shapes of one body.
class ShapeDrawing {
  public:
    ShapeDrawing(const DebugBody& body, const DebugView& view, DebugDraw& draw)
        : m_body(body), m_view(view), m_draw(draw) {}

    void operator()(const Circle& circle) const {
        if (m_view.shapes) {
            const ShapeColors colors = shapeColors(m_body.kind, circle);
            const double radius = m_view.view.toView(circle.radius);
            m_draw.filledCircle(at(circle.center), radius, colors.fill);
            m_draw.circle(at(circle.center), radius, colors.outline);
        }
    }

    void operator()(const Polygon& polygon) const {
        if (polygon.vertices.size() < 3 || !(m_view.shapes || m_view.overlays.incircle)) {
            return;
        }
        std::vector<Vec2> outline;
        outline.reserve(polygon.vertices.size());
        for (const Vec2& vertex : polygon.vertices) {
            outline.push_back(at(vertex));
        }
        const ShapeColors colors = shapeColors(m_body.kind, polygon);
        if (m_view.shapes) {
            m_draw.filledPolygon(outline, colors.fill);
        }
        if (m_view.overlays.incircle) {
            const Vec2 center = centroid(polygon.vertices);
            const double radius = incircleRadius(polygon.vertices, center);
            m_draw.circle(at(center), m_view.view.toView(radius), m_view.colors.incircle);
        }
        if (m_view.shapes) {
            m_draw.polygon(outline, colors.outline);
        }
    }

    void operator()(const Edge& edge) const {
        if (m_view.overlays.normals) {
            band(edge);
        }
        wall(edge, false);
    }
    void operator()(const Line& line) const { wall(line, true); }

  private:
    Vec2 at(const Vec2& local) const { return m_view.view.toView(m_body.pose.toWorld(local)); }

    /// Draws the solid band behind an edge. A band of infinite depth is drawn as a strip without a far border.
    void band(const Edge& edge) const {
        constexpr double open = 14; // units of the picture
        constexpr std::uint8_t faint = 60;
        const double length = (edge.b - edge.a).norm();
        const bool ends = edge.depth != noBack;
        const double depth = ends ? edge.depth : open / m_view.view.scale;
        if (!(length > 0) || !(depth > 0) || isTiny(std::max(length, depth), edge.a)) {
            return;
        }
        const Vec2 back = -depth * leftOf((edge.b - edge.a) / length);
        const std::array<Vec2, 4> outline{at(edge.a), at(edge.b), at(edge.b + back), at(edge.a + back)};
        Color fill = m_view.colors.depth;
        fill.alpha = static_cast<std::uint8_t>(fill.alpha * faint / 255);
        m_draw.filledPolygon(outline, fill);
        if (ends) {
            m_draw.line(outline[2], outline[3], m_view.colors.depth);
        }
    }

    /// Whether an extent in metres, at a point of the body, is too small to be drawn; then tells the host.
    bool isTiny(double extent, const Vec2& local) const {
        const bool tiny = m_view.area && m_view.view.toView(extent) < leastExtent;
        if (tiny) {
            m_draw.leftOut(at(local));
        }
        return tiny;
    }

    template <class Wall>
    void wall(const Wall& wall, bool bothSides) const {
        const Vec2 along = wall.b - wall.a;
        const double length = along.norm();
        if (!(length > 0)) {
            return;
        }
        if (const Vec2 middle = 0.5 * (wall.a + wall.b); m_view.overlays.normals && !isTiny(1, middle)) {
            const Vec2 normal = leftOf(along / length);
            m_draw.arrow(at(middle), at(middle + normal), m_view.colors.normal);
            if (bothSides) {
                m_draw.arrow(at(middle), at(middle - normal), m_view.colors.normal);
            }
        }
        if (m_view.shapes) {
            m_draw.line(at(wall.a), at(wall.b), shapeColors(m_body.kind, wall).outline);
        }
    }

    const DebugBody& m_body;
    const DebugView& m_view;
    DebugDraw& m_draw;
};

} // namespace

void drawBody(const DebugBody& body, const DebugView& view, DebugDraw& draw) {
    if (view.overlays.aabb && !body.fatBounds.isEmpty()) {
        draw.rectangle(view.view.toView(body.fatBounds), view.colors.fatBox);
    }
    if (view.overlays.aabb && !body.bounds.isEmpty()) {
        draw.rectangle(view.view.toView(body.bounds), view.colors.box);
    }
    const ShapeDrawing drawing(body, view, draw);
    if (view.shapes || view.overlays.incircle || view.overlays.normals) {
        for (const Shape& shape : body.shapes) {
            if (!view.area || boundsOf(shape, body.pose).grown(1).overlaps(*view.area)) {
                std::visit(drawing, shape);
            }
        }
    }
    const bool turns = body.kind != BodyKind::Static || !std::all_of(body.shapes.begin(), body.shapes.end(), isWall);
    if (view.overlays.orientation && turns) {
        const Vec2& from = body.pose.position;
        draw.line(view.view.toView(from), view.view.toView(from + body.pose.rotation.up()), view.colors.orientation);
    }
    const double speed = body.velocity.norm();
    if (view.overlays.velocity && speed > 0 && !isLeftOut(view, speed, body.massCenter, draw)) {
        draw.arrow(view.view.toView(body.massCenter), view.view.toView(body.massCenter + body.velocity),
                   view.colors.velocity);
    }
}

namespace {

/// Bounds of all that is drawn of one body.
Aabb reachOf(const BodyState& state, const Aabb& bounds) {
    Aabb box = bounds.isEmpty() ? Aabb{state.massCenter, state.massCenter} : bounds;
    box.include(state.massCenter + state.velocity);
    return box.grown(1);
}

/// The visible bodies: static, kinematic, dynamic, each in the order of creation.
std::vector<BodyId> seenBodies(const World& world, const DebugView& view) {
    std::vector<BodyId> seen;
    const std::vector<BodyId> bodies = world.bodies();
    for (const BodyKind kind : {BodyKind::Static, BodyKind::Kinematic, BodyKind::Dynamic}) {
        for (const BodyId id : bodies) {
            if (world.data().bodies.records[id.index].kind == kind && (!view.shows || view.shows(id)) &&
                (!view.area || reachOf(world.body(id), world.bounds(id)).overlaps(*view.area))) {
                seen.push_back(id);
            }
        }
    }
    return seen;
}

DebugBody bodyOf(const World& world, BodyId id, const DebugView& view) {
    const BodyState state = world.body(id);
    DebugBody body{state.kind, world.shapes(id), state.pose, state.massCenter, state.velocity, {}, {}};
    if (view.overlays.aabb) {
        constexpr double rounding = 1e-9; // m
        for (const Shape& shape : body.shapes) {
            body.bounds.include(boundsOf(shape, state.pose));
        }
        const Aabb fat = world.bounds(id);
        body.fatBounds = body.bounds.grown(rounding).contains(fat) ? Aabb{} : fat;
    }
    return body;
}

/// Draws the overlays below the bodies.
void drawGround(const World& world, std::span<const BodyId> seen, const DebugView& view, DebugDraw& draw) {
    if (view.overlays.quadtree) {
        drawTrees(world, view, draw);
    }
    for (const BodyId id : seen) {
        if (view.overlays.islands) {
            drawIsland(world, id, view, draw);
        }
        if (view.overlays.tags) {
            drawTags(world, id, view, draw);
        }
    }
    if (view.overlays.collides) {
        drawCollisions(world, view, draw);
    }
}

/// Draws the overlays above the bodies.
void drawMarks(const World& world, std::span<const BodyId> seen, const DebugView& view, DebugDraw& draw) {
    if (view.overlays.risk) {
        drawRisks(world, view, draw);
    }
    if (view.overlays.trails) {
        drawTrails(view, draw);
    }
    if (view.overlays.contacts) {
        drawContacts(world, view, draw);
    }
    for (const BodyId id : seen) {
        const BodyState state = world.body(id);
        if (view.overlays.masses && state.kind != BodyKind::Static) {
            drawMassCenter(state, view, draw);
        }
        if (view.overlays.names) {
            drawName(world, id, view, draw);
        }
    }
}

} // namespace

void drawWorld(const World& world, const DebugView& view, DebugDraw& draw) {
    if (view.background) {
        draw.filledRectangle({Vec2(0, 0), view.view.size}, *view.background);
    }
    const std::vector<BodyId> seen = seenBodies(world, view);
    drawGround(world, seen, view, draw);
    const OverlayFlags& on = view.overlays;
    if (view.shapes || on.aabb || on.incircle || on.velocity || on.orientation || on.normals) {
        for (const BodyId id : seen) {
            drawBody(bodyOf(world, id, view), view, draw);
        }
    }
    if (view.overlays.tension) {
        drawConnectors(world, view, draw);
    } else if (view.shapes) {
        for (const ConnectorId id : world.connectors()) {
            const ConnectorState state = world.connector(id);
            draw.line(view.view.toView(state.anchorA), view.view.toView(state.anchorB),
                      connectorColor((state.anchorB - state.anchorA).norm(), state.length, view.colors));
        }
    }
    drawMarks(world, seen, view, draw);
}

} // namespace spacetow
