#include "core/physics/query/debug_view.h"

#include <algorithm>
#include <cmath>

namespace spacetow {

namespace {

Color between(const Color& a, const Color& b, double share) {
    const auto channel = [share](std::uint8_t from, std::uint8_t to) {
        return static_cast<std::uint8_t>(std::lround(from + share * (to - from)));
    };
    return {channel(a.red, b.red), channel(a.green, b.green), channel(a.blue, b.blue)};
}

} // namespace

ShapeColors shapeColors(BodyKind kind, const Shape& shape) {
    const bool round = std::holds_alternative<Circle>(shape);
    const bool wall = std::holds_alternative<Edge>(shape) || std::holds_alternative<Line>(shape);
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

Color connectorColor(double distance, double length, const DebugColors& colors) {
    const double sixths = 6 * connectorHue(distance, length); // 0 pressed, 1 natural, 2 pulled
    return sixths < 1 ? between(colors.pressed, colors.natural, sixths)
                      : between(colors.natural, colors.pulled, sixths - 1);
}

} // namespace spacetow
