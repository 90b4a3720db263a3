#pragma once
// Drawing for inspection: the host implements DebugDraw, and drawWorld tells it what there is to see.
// Nothing of the world is changed or kept, so that every call gives the same picture of the same world. The host
// receives coordinates of its picture, see ViewTransform.

#include "core/math/view_transform.h"
#include "core/physics/world/world.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <span>

namespace spacetow {

struct Color {
    std::uint8_t red = 0, green = 0, blue = 0;
    std::uint8_t alpha = 255; // opaque

    bool operator==(const Color&) const = default;
};

class DebugDraw {
  public:
    virtual ~DebugDraw() = default;

    virtual void circle(const Vec2& center, double radius, const Color& color) = 0;
    virtual void filledCircle(const Vec2& center, double radius, const Color& color) = 0;
    /// Closed, may be concave; the outline is valid during the call only.
    virtual void polygon(std::span<const Vec2> outline, const Color& color) = 0;
    virtual void filledPolygon(std::span<const Vec2> outline, const Color& color) = 0;
    virtual void line(const Vec2& a, const Vec2& b, const Color& color) = 0;
    virtual void rectangle(const Aabb& box, const Color& color) = 0;
    virtual void filledRectangle(const Aabb& box, const Color& color) = 0;
    /// Velocities and normals: a line, to which the host may give a head.
    virtual void arrow(const Vec2& from, const Vec2& to, const Color& color) { line(from, to, color); }
};

struct ShapeColors {
    Color fill, outline;
};

/// Circles, polygons and walls of each kind of body differ.
ShapeColors shapeColors(BodyKind kind, const Shape& shape);

/// 0 … 1/3 of the colour circle: red when pressed to half its length or less, yellow (1/6) at its natural length or
/// when it has none, green when pulled to one and a half or more.
double connectorHue(double distance, double length);
/// The full colour of that hue.
Color connectorColor(double distance, double length);

struct DebugColors {
    Color box{255, 255, 255};
    Color incircle{150, 250, 200};
    Color normal{210, 200, 200, 128};
    Color orientation{0, 255, 255};
    Color velocity{255, 0, 0};
};

struct DebugView {
    ViewTransform view;
    bool shapes = true;       // the bodies themselves
    bool boxes = true;        // of the broad phase
    bool velocities = true;   // where the centre of mass would be a second later
    bool orientations = true; // one metre along the body's "up"
    bool incircles = true;    // of polygons, about their centroid
    bool normals = true;      // free sides of walls, one metre
    DebugColors colors;
    std::optional<Color> background;   // of the whole picture
    std::function<bool(BodyId)> shows; // of a hidden body nothing is drawn; without it none is hidden
};

/// What is drawn of a body; the shapes must outlive it.
struct DebugBody {
    BodyKind kind = BodyKind::Dynamic;
    std::span<const Shape> shapes;
    Transform pose;
    Vec2 massCenter{0, 0}; // world
    Vec2 velocity{0, 0};   // of the centre of mass
    Aabb bounds;           // may be empty
};

/// Its box; each shape, a polygon's incircle between its filling and its outline and a wall's normals below the wall;
/// orientation and velocity once. Static walls have no orientation. Shapes without extent are left out.
void drawBody(const DebugBody& body, const DebugView& view, DebugDraw& draw);

/// Background; static, kinematic, dynamic bodies, each in the order in which they were added; connectors.
void drawWorld(const World& world, const DebugView& view, DebugDraw& draw);

} // namespace spacetow
