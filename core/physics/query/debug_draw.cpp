#include "core/physics/query/debug_draw.h"

#include "core/geometry/polygon.h"

#include <algorithm>
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
        if (polygon.vertices.size() < 3 || !(m_view.shapes || m_view.incircles)) {
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
        if (m_view.incircles) {
            const Vec2 center = centroid(polygon.vertices);
            const double radius = incircleRadius(polygon.vertices, center);
            m_draw.circle(at(center), m_view.view.toView(radius), m_view.colors.incircle);
        }
        if (m_view.shapes) {
            m_draw.polygon(outline, colors.outline);
        }
    }

    void operator()(const Edge& edge) const { wall(edge, false); }
    void operator()(const Line& line) const { wall(line, true); }

  private:
    Vec2 at(const Vec2& local) const { return m_view.view.toView(m_body.pose.toWorld(local)); }

    template <class Wall>
    void wall(const Wall& wall, bool bothSides) const {
        const Vec2 along = wall.b - wall.a;
        const double length = along.norm();
        if (!(length > 0)) {
            return;
        }
        if (m_view.normals) {
            const Vec2 middle = 0.5 * (wall.a + wall.b);
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

std::uint8_t channel(double share) {
    return static_cast<std::uint8_t>(std::lround(255 * std::clamp(share, 0.0, 1.0)));
}

} // namespace

ShapeColors shapeColors(BodyKind kind, const Shape& shape) {
    const bool round = std::holds_alternative<Circle>(shape);
    const bool wall = isWall(shape);
    switch (kind) {
    case BodyKind::Static:
        return {{210, 200, 200, 128}, {220, 210, 210}};
    case BodyKind::Kinematic:
        return round  ? ShapeColors{{75, 75, 200, 128}, {75, 75, 255}}
               : wall ? ShapeColors{{100, 200, 100, 128}, {55, 200, 55}}
                      : ShapeColors{{200, 150, 150, 128}, {255, 100, 100}};
    case BodyKind::Dynamic:
        break;
    }
    return round  ? ShapeColors{{150, 200, 150, 128}, {150, 250, 200}}
           : wall ? ShapeColors{{200, 200, 100, 128}, {250, 250, 75}}
                  : ShapeColors{{150, 150, 200, 128}, {200, 150, 255}};
}

double connectorHue(double distance, double length) {
    const double ratio = length > 0 ? distance / length : 1;
    return ((std::isfinite(ratio) ? std::clamp(ratio, 0.5, 1.5) : 1.5) - 0.5) / 3;
}

Color connectorColor(double distance, double length) {
    const double sixths = 6 * connectorHue(distance, length); // 0 red, 1 yellow, 2 green
    return {channel(2 - sixths), channel(sixths), 0};
}

void drawBody(const DebugBody& body, const DebugView& view, DebugDraw& draw) {
    if (view.boxes && !body.bounds.isEmpty()) {
        draw.rectangle(view.view.toView(body.bounds), view.colors.box);
    }
    const ShapeDrawing drawing(body, view, draw);
    for (const Shape& shape : body.shapes) {
        std::visit(drawing, shape);
    }
    const bool turns = body.kind != BodyKind::Static || !std::all_of(body.shapes.begin(), body.shapes.end(), isWall);
    if (view.orientations && turns) {
        const Vec2& from = body.pose.position;
        draw.line(view.view.toView(from), view.view.toView(from + body.pose.rotation.up()), view.colors.orientation);
    }
    if (view.velocities && body.velocity.squaredNorm() > 0) {
        draw.arrow(view.view.toView(body.massCenter), view.view.toView(body.massCenter + body.velocity),
                   view.colors.velocity);
    }
}

void drawWorld(const World& world, const DebugView& view, DebugDraw& draw) {
    if (view.background) {
        draw.filledRectangle({Vec2(0, 0), view.view.size}, *view.background);
    }
    const std::vector<BodyId> bodies = world.bodies();
    for (const BodyKind kind : {BodyKind::Static, BodyKind::Kinematic, BodyKind::Dynamic}) {
        for (const BodyId id : bodies) {
            const BodyState state = world.body(id);
            if (state.kind != kind || (view.shows && !view.shows(id))) {
                continue;
            }
            const Aabb bounds = view.boxes ? world.bounds(id) : Aabb{};
            drawBody({kind, world.shapes(id), state.pose, state.massCenter, state.velocity, bounds}, view, draw);
        }
    }
    for (const ConnectorId id : world.connectors()) {
        const ConnectorState state = world.connector(id);
        draw.line(view.view.toView(state.anchorA), view.view.toView(state.anchorB),
                  connectorColor((state.anchorB - state.anchorA).norm(), state.length));
    }
}

} // namespace spacetow
