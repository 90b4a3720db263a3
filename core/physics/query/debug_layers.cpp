#include "core/physics/query/debug_layers.h"

#include "core/geometry/bounds.h"
#include "core/physics/broad_phase/collision_rules.h"
#include "core/physics/query/contact_manifolds.h"
#include "core/physics/query/queries.h"
#include "core/physics/query/tunnelling.h"
#include "core/physics/state/world_data.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace spacetow {

namespace {

constexpr double earthGravity = 9.81; // m/s²
constexpr double dotRadius = 3;       // radius of points, in units of the picture
constexpr double armLength = 5;       // half of the arms of a cross
constexpr double beside = 6;          // distance of a text from its object
constexpr double roomy = 40;          // least width with room for a number

Color withAlpha(Color color, int alpha) {
    color.alpha = static_cast<std::uint8_t>(std::clamp(alpha, 0, 255));
    return color;
}

std::string written(const char* format, double value) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), format, value);
    return text.data();
}

bool isSeen(const DebugView& view, const Vec2& world) {
    return !view.area || view.area->contains(world);
}

/// Whether the box is in the area, and large enough to be drawn; else tells the host.
bool isSeen(const DebugView& view, const Aabb& world, DebugDraw& draw) {
    if (!view.area->overlaps(world)) {
        return false;
    }
    const bool isLarge = view.view.toView(world.size().maxCoeff()) >= leastExtent;
    if (!isLarge) {
        draw.leftOut(view.view.toView(world.center()));
    }
    return isLarge;
}

/// The length of a force arrow, m, from the force in weights of the lighter body. Logarithmic above one weight, so that
/// the arrows below a pile do not cover the picture.
double forceLength(double weights) {
    return weights <= 1 ? weights : 1 + std::log10(weights);
}

/// Draws the outlines of a body, or fills them.
struct OutlineDrawing {
    const Transform& pose;
    const DebugView& view;
    DebugDraw& draw;
    Color color;
    bool filled;

    Vec2 at(const Vec2& local) const { return view.view.toView(pose.toWorld(local)); }
    void operator()(const Circle& circle) const {
        const double radius = view.view.toView(circle.radius);
        filled ? draw.filledCircle(at(circle.center), radius, color) : draw.circle(at(circle.center), radius, color);
    }
    void operator()(const Polygon& polygon) const {
        std::vector<Vec2> outline;
        outline.reserve(polygon.vertices.size());
        for (const Vec2& vertex : polygon.vertices) {
            outline.push_back(at(vertex));
        }
        filled ? draw.filledPolygon(outline, color) : draw.polygon(outline, color);
    }
    void operator()(const Edge& edge) const { draw.line(at(edge.a), at(edge.b), color); }
    void operator()(const Line& line) const { draw.line(at(line.a), at(line.b), color); }
};

struct Ink {
    Color color;
    bool filled = false;
};

struct PosedShapes {
    const std::vector<Shape>& shapes;
    const Transform& pose;
};

void drawOutline(const PosedShapes& body, const Ink& ink, const DebugView& view, DebugDraw& draw) {
    const OutlineDrawing drawing{body.pose, view, draw, ink.color, ink.filled};
    for (const Shape& shape : body.shapes) {
        if (!view.area || isSeen(view, boundsOf(shape, body.pose), draw)) {
            std::visit(drawing, shape);
        }
    }
}

/// A line that is wider than lines are, from a to b in the picture.
void drawStrip(const Vec2& a, const Vec2& b, const Color& color, DebugDraw& draw) {
    constexpr double halfWidth = 1.5;
    const double length = (b - a).norm();
    if (length > 0) {
        const Vec2 across = halfWidth * leftOf((b - a) / length);
        const std::array<Vec2, 4> strip{a + across, b + across, b - across, a - across};
        draw.filledPolygon(strip, color);
    }
}

void drawCell(const QuadtreeCell& cell, const DebugView& view, DebugDraw& draw) {
    constexpr int lightest = 8; // alpha
    constexpr int each = 4;
    constexpr int fullest = 60;
    const Color color = cell.moving ? view.colors.movingCell : view.colors.staticCell;
    const Aabb box = view.view.toView(cell.box);
    if (cell.held > 0) {
        draw.filledRectangle(box, withAlpha(color, std::min(lightest + each * cell.held, fullest)));
    }
    draw.rectangle(box, color);
    if (cell.held > 0 && box.size().minCoeff() >= roomy) {
        draw.text(box.min + Vec2(beside, 2 * beside + (cell.moving ? 2 * beside : 0)), std::to_string(cell.held),
                  color);
    }
}

/// Whether the bodies have contacts when they touch.
bool haveContacts(const WorldData& data, BodyId a, BodyId b) {
    const bool active = data.bodies.records[a.index].active && data.bodies.records[b.index].active;
    return active && areTangible(data.bodies, a.index, b.index) &&
           mayCollide(data.bodies, data.forces, a.index, b.index);
}

struct DrawnForce {
    Vec2 from;          // world
    Vec2 along;         // a unit vector
    double weights = 0; // negative ones point the other way
};

void drawForce(const DrawnForce& force, const DebugView& view, DebugDraw& draw) {
    const double length = std::copysign(forceLength(std::abs(force.weights)), force.weights);
    if (force.weights != 0 && std::isfinite(force.weights) && !isLeftOut(view, length, force.from, draw)) {
        const Vec2 tip = force.from + length * force.along;
        draw.arrow(view.view.toView(force.from), view.view.toView(tip), view.colors.impulse);
    }
}

/// The mass of the lighter dynamic body, kg; infinite if neither body is dynamic.
double lighterMass(const World& world, const ContactManifold& contact) {
    double least = std::numeric_limits<double>::infinity();
    for (const BodyId id : {contact.a, contact.b}) {
        const BodyRecord& body = world.data().bodies.records[id.index];
        least = body.kind == BodyKind::Dynamic ? std::min(least, body.mass) : least;
    }
    return least;
}

void drawContact(const World& world, const ContactManifold& contact, const DebugView& view, DebugDraw& draw) {
    const UpdateParameters& parameters = world.parameters();
    const double lighter = lighterMass(world, contact);
    const double weights = parameters.iterations / (parameters.seconds * lighter * earthGravity); // per N s
    for (const ContactManifold::Point& point :
         std::span(contact.points).first(static_cast<std::size_t>(contact.count))) {
        const Vec2 at = view.view.toView(point.at);
        if (!contact.touching) {
            draw.circle(at, dotRadius, view.colors.nearPoint);
            continue;
        }
        constexpr double normalLength = 16;
        draw.line(at, at + normalLength * Vec2(contact.normal.x(), -contact.normal.y()), view.colors.contactNormal);
        drawForce({point.at, contact.normal, weights * point.normalImpulse}, view, draw);
        draw.filledCircle(at, dotRadius, view.colors.touchPoint);
    }
    if (contact.touching) {
        drawForce({contact.points[0].at, leftOf(contact.normal), weights * contact.tangentImpulse}, view, draw);
    }
}

} // namespace

void drawTrees(const World& world, const DebugView& view, DebugDraw& draw) {
    for (const QuadtreeCell& cell : occupiedCells(world, view.area)) {
        if (!cell.box.isEmpty()) {
            drawCell(cell, view, draw);
        }
    }
}

void drawIsland(const World& world, BodyId body, const DebugView& view, DebugDraw& draw) {
    constexpr int faint = 130; // alpha
    const std::optional<std::uint32_t> island = islandOf(world, body);
    if (!island) {
        return;
    }
    const Color own = view.colors.islands[*island % view.colors.islands.size()];
    const BodyState state = world.body(body);
    const PosedShapes posed{world.shapes(body), state.pose};
    drawOutline(posed, {withAlpha(state.asleep ? view.colors.asleep : own, faint), true}, view, draw);
    drawOutline(posed, {own, false}, view, draw);
}

void drawTags(const World& world, BodyId body, const DebugView& view, DebugDraw& draw) {
    if (!view.tagColor) {
        return;
    }
    constexpr double least = 12; // of a body that has room for dots
    const BodyState state = world.body(body);
    const bool isRoomy = !view.area || view.view.toView(world.bounds(body).size().maxCoeff()) >= least;
    Vec2 at = view.view.toView(state.massCenter);
    bool isFirst = true;
    for (int tag = 0; tag < 32; ++tag) {
        const std::optional<Color> color = state.filter.tags.contains(tag) ? view.tagColor(tag) : std::nullopt;
        if (!color) {
            continue;
        }
        if (isFirst) {
            drawOutline({world.shapes(body), state.pose}, {*color, false}, view, draw);
        } else if (isRoomy) {
            draw.filledCircle(at, dotRadius, *color);
            at.x() += 3 * dotRadius;
        }
        isFirst = false;
    }
}

void drawCollisions(const World& world, const DebugView& view, DebugDraw& draw) {
    std::vector<BodyId> selected;
    for (const BodyId id : world.bodies()) {
        if (view.isSelected && view.isSelected(world.data().bodies.records[id.index].user)) {
            selected.push_back(id);
        }
    }
    if (selected.empty()) {
        return;
    }
    for (const BodyId id : world.bodies()) {
        const bool isOne = std::ranges::find(selected, id) != selected.end();
        if ((isOne && selected.size() == 1) || (view.area && !world.bounds(id).overlaps(*view.area))) {
            continue;
        }
        const Transform pose = world.body(id).pose;
        const bool meets =
            std::ranges::any_of(selected, [&](BodyId other) { return haveContacts(world.data(), id, other); });
        drawOutline({world.shapes(id), pose}, {meets ? view.colors.meets : view.colors.passes, false}, view, draw);
    }
}

void drawConnectors(const World& world, const DebugView& view, DebugDraw& draw) {
    for (const ConnectorId id : world.connectors()) {
        const ConnectorState state = world.connector(id);
        Aabb box{state.anchorA, state.anchorA};
        box.include(state.anchorB);
        if (view.area && !view.area->overlaps(box)) {
            continue;
        }
        const Vec2 a = view.view.toView(state.anchorA);
        const Vec2 b = view.view.toView(state.anchorB);
        const Color color = connectorColor((state.anchorB - state.anchorA).norm(), state.length, view.colors);
        drawStrip(a, b, color, draw);
        if ((b - a).norm() >= roomy) {
            draw.text(0.5 * (a + b) + Vec2(beside, -beside), written("%.3g N", state.tension), color);
        }
    }
}

void drawRisks(const World& world, const DebugView& view, DebugDraw& draw) {
    for (const WallRisk& wall : wallRisks(world, view.area)) {
        const Vec2 a = view.view.toView(wall.a);
        const Vec2 b = view.view.toView(wall.b);
        const double share = std::min(wall.risk, 1.0);
        const auto mix = [share](std::uint8_t safe, std::uint8_t risky) {
            return static_cast<std::uint8_t>(std::lround(safe + share * (risky - safe)));
        };
        const Color& safe = view.colors.safe;
        const Color& risky = view.colors.risky;
        const Color color{mix(safe.red, risky.red), mix(safe.green, risky.green), mix(safe.blue, risky.blue)};
        drawStrip(a, b, color, draw);
        if ((b - a).norm() >= roomy) {
            draw.text(0.5 * (a + b) + Vec2(beside, -beside), written("%.2g", wall.risk), color);
        }
    }
}

void drawTrails(const DebugView& view, DebugDraw& draw) {
    constexpr int oldest = 40; // alpha
    for (const DebugTrail& trail : view.trails) {
        std::size_t from = 0;
        for (std::size_t to = 1; to < trail.points.size(); ++to) {
            const Vec2& a = trail.points[from];
            const Vec2& b = trail.points[to];
            if (isDot(view, (b - a).norm())) {
                continue; // too short to be seen: goes on from the same point
            }
            from = to;
            if (isSeen(view, a) || isSeen(view, b)) {
                // In eight steps, so that the host has few colours to change.
                const auto age = static_cast<int>(8 * to / trail.points.size());
                draw.line(view.view.toView(a), view.view.toView(b),
                          withAlpha(view.colors.trail, oldest + age * (255 - oldest) / 7));
            }
        }
    }
}

void drawContacts(const World& world, const DebugView& view, DebugDraw& draw) {
    for (const ContactManifold& contact : contactManifolds(world, view.area)) {
        drawContact(world, contact, view, draw);
    }
}

void drawMassCenter(const BodyState& state, const DebugView& view, DebugDraw& draw) {
    const Vec2 at = view.view.toView(state.massCenter);
    const Vec2 up = state.pose.rotation.up();
    const Vec2 along = armLength * Vec2(up.x(), -up.y());
    draw.line(at - along, at + along, view.colors.massCenter);
    draw.line(at - leftOf(along), at + leftOf(along), view.colors.massCenter);
}

void drawName(const World& world, BodyId body, const DebugView& view, DebugDraw& draw) {
    const BodyState state = world.body(body);
    const std::string name = view.nameOf ? view.nameOf(state.user) : std::string();
    if (name.empty()) {
        return;
    }
    Vec2 at = state.massCenter;
    if (state.kind == BodyKind::Static) { // a static body has no centre of mass: at its first shape
        const std::vector<Shape>& shapes = world.shapes(body);
        at = shapes.empty() ? at : boundsOf(shapes.front(), state.pose).center();
    }
    draw.name(view.view.toView(at) + Vec2(beside, -beside), name, view.colors.name, state.user);
}

} // namespace spacetow
