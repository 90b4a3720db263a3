#pragma once
// The parameters of debug drawing: the interface that the host implements, the colours, and the view of the world.

#include "core/math/view_transform.h"
#include "core/physics/query/overlay_flags.h"
#include "core/physics/world/world.h"

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

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
    /// Closed; may be concave. The outline is valid during the call only.
    virtual void polygon(std::span<const Vec2> outline, const Color& color) = 0;
    virtual void filledPolygon(std::span<const Vec2> outline, const Color& color) = 0;
    virtual void line(const Vec2& a, const Vec2& b, const Color& color) = 0;
    virtual void rectangle(const Aabb& box, const Color& color) = 0;
    virtual void filledRectangle(const Aabb& box, const Color& color) = 0;
    /// Beside the point, in the host's font, legible over what is drawn below.
    virtual void text(const Vec2& at, std::string_view text, const Color& color) = 0;
    /// What a body is called, by BodyDef::user: a text of which the host may leave some out.
    virtual void name(const Vec2& at, std::string_view name, const Color& color, std::uint64_t /*user*/) {
        text(at, name, color);
    }
    /// Velocities and normals. By default a line; the host may add a head.
    virtual void arrow(const Vec2& from, const Vec2& to, const Color& color) { line(from, to, color); }
    /// A mark of an overlay has not been drawn there, as it would be no more than a dot; from nearer it can be seen.
    virtual void leftOut(const Vec2& /*at*/) {}
};

struct ShapeColors {
    Color fill, outline;
};

/// The colours of a shape: by kind of body, and by circle, polygon or wall.
ShapeColors shapeColors(BodyKind kind, const Shape& shape);

/// The hue of a connector, 0 … 1/3 of the colour circle: red (0) at half its natural length or less, yellow (1/6) at
/// its natural length, green (1/3) at one and a half of it or more. Yellow too when the natural length is 0.
double connectorHue(double distance, double length);

struct DebugColors {
    Color box{255, 255, 255};
    Color incircle{150, 250, 200};
    Color normal{210, 200, 200, 128};
    Color orientation{0, 255, 255};
    Color velocity{255, 0, 0};
    Color fatBox{130, 150, 190};
    Color depth{210, 200, 200}; // of bands; filled with some of it
    Color staticCell{90, 190, 120}, movingCell{230, 160, 60};
    Color touchPoint{255, 60, 60}, nearPoint{150, 150, 160};
    Color contactNormal{230, 230, 230};
    Color impulse{255, 200, 0};
    Color pressed{255, 0, 0}, natural{255, 255, 0}, pulled{0, 255, 0};
    Color trail{90, 170, 255};
    Color way{146, 190, 255}, lostWay{190, 200, 220};
    Color massCenter{255, 120, 200};
    Color name{240, 240, 240};
    Color asleep{120, 120, 130};
    std::array<Color, 6> islands{
        {{230, 120, 60}, {90, 170, 255}, {110, 220, 110}, {240, 220, 90}, {220, 110, 220}, {80, 220, 220}}};
    Color meets{255, 90, 200}, passes{110, 110, 120};
    Color safe{110, 220, 110}, risky{255, 60, 60};

    bool operator==(const DebugColors&) const = default;
};

/// The colour of `connectorHue`, between those of `colors`.
Color connectorColor(double distance, double length, const DebugColors& colors = {});

/// The path of a body, oldest point first; world coordinates.
struct DebugTrail {
    std::vector<Vec2> points;

    bool operator==(const DebugTrail&) const = default;
};

struct DebugView {
    ViewTransform view;
    bool shapes = true; // the bodies themselves
    OverlayFlags overlays;
    DebugColors colors;
    std::optional<Color> background;   // of the whole picture
    std::function<bool(BodyId)> shows; // false: the body is hidden; without it no body is hidden
    /// The visible part of the world. If set, bodies outside and bodies too small to be seen are not drawn.
    std::optional<Aabb> area;

    // Data of the host about a body, by BodyDef::user.
    std::function<std::string(std::uint64_t user)> nameOf; // without it no body has a name
    std::function<bool(std::uint64_t user)> isSelected;    // without it nothing is selected
    std::function<std::optional<Color>(int tag)> tagColor; // without it no tag has a colour
    std::span<const DebugTrail> trails;                    // lives as long as the view
};

} // namespace spacetow
