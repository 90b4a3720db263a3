#include "editor/exchange/svg_shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace spacetow {

namespace {

/// Reads the lengths of an element.
struct ShapeLengths {
    const XmlElement& element;
    const Vec2& window;
    double fontSize;
    bool whole = true;

    std::optional<double> given(const char* name, LengthAxis axis) {
        const std::string& text = element.attribute(name);
        if (text.empty() || text == "auto") {
            return {};
        }
        const double diagonal = window.norm() / std::numbers::sqrt2;
        const double base = axis == LengthAxis::X ? window.x() : axis == LengthAxis::Y ? window.y() : diagonal;
        const std::optional<double> length = lengthFromText(text, {base, fontSize});
        whole = whole && length;
        return length;
    }
    double of(const char* name, LengthAxis axis) { return given(name, axis).value_or(0); }
};

DrawnPath roundedRectangle(const Vec2& corner, const Vec2& size, const Vec2& radii) {
    const Vec2 far = corner + size;
    const Vec2 u(radii.x(), 0);
    const Vec2 v(0, radii.y());
    const auto arc = [&](double x, double y, int quarter, const Vec2& to) {
        return ArcPiece{{x, y}, u, v, quarter * std::numbers::pi / 2, std::numbers::pi / 2, to};
    };
    const double left = corner.x() + radii.x();
    const double right = far.x() - radii.x();
    const double top = corner.y() + radii.y();
    const double bottom = far.y() - radii.y();
    return {{left, corner.y()},
            {LinePiece{{right, corner.y()}}, arc(right, top, 3, {far.x(), top}), LinePiece{{far.x(), bottom}},
             arc(right, bottom, 0, {right, far.y()}), LinePiece{{left, far.y()}},
             arc(left, bottom, 1, {corner.x(), bottom}), LinePiece{{corner.x(), top}},
             arc(left, top, 2, {left, corner.y()})},
            true};
}

void addRectangle(ShapeLengths& lengths, SvgShape& shape) {
    const Vec2 corner(lengths.of("x", LengthAxis::X), lengths.of("y", LengthAxis::Y));
    const Vec2 size(lengths.of("width", LengthAxis::X), lengths.of("height", LengthAxis::Y));
    if (!(size.x() > 0 && size.y() > 0)) {
        return;
    }
    const std::optional<double> rx = lengths.given("rx", LengthAxis::X);
    const std::optional<double> ry = lengths.given("ry", LengthAxis::Y);
    const Vec2 wanted(rx.value_or(ry.value_or(0)), ry.value_or(rx.value_or(0)));
    const Vec2 radii = wanted.cwiseMin(size / 2).cwiseMax(Vec2(0, 0));
    if (radii.x() > 0 && radii.y() > 0) {
        shape.paths.push_back(roundedRectangle(corner, size, radii));
    } else {
        const Vec2 far = corner + size;
        shape.paths.push_back(polygonPath({corner, {far.x(), corner.y()}, far, {corner.x(), far.y()}}, true));
    }
}

void addEllipse(ShapeLengths& lengths, SvgShape& shape) {
    const Vec2 center(lengths.of("cx", LengthAxis::X), lengths.of("cy", LengthAxis::Y));
    if (lengths.element.name == "circle") {
        const double radius = lengths.of("r", LengthAxis::Diagonal);
        if (radius > 0) {
            shape.circle = Circle{center, radius};
        }
        return;
    }
    const std::optional<double> rx = lengths.given("rx", LengthAxis::X);
    const std::optional<double> ry = lengths.given("ry", LengthAxis::Y);
    const Vec2 radii(rx.value_or(ry.value_or(0)), ry.value_or(rx.value_or(0)));
    if (radii.x() > 0 && radii.y() > 0) {
        shape.paths.push_back(ellipsePath(center, {radii.x(), 0}, {0, radii.y()}));
    }
}

constexpr std::array<std::string_view, 7> shapeElements{"path", "line",   "polyline", "polygon",
                                                        "rect", "circle", "ellipse"};

} // namespace

bool isSvgShape(std::string_view element) {
    return std::ranges::find(shapeElements, element) != shapeElements.end();
}

std::optional<double> svgLength(const XmlElement& element, const char* attribute, LengthAxis axis, const Vec2& window) {
    return ShapeLengths{element, window, 16}.given(attribute, axis);
}

SvgShape svgShape(const XmlElement& element, const Vec2& window, double fontSize) {
    SvgShape shape;
    ShapeLengths lengths{element, window, fontSize};
    const std::string& name = element.name;
    if (name == "path") {
        PathReading reading = readPathData(element.attribute("d"));
        shape.paths = std::move(reading.paths);
        shape.whole = reading.whole;
    } else if (name == "polyline" || name == "polygon") {
        PathReading reading = readPointList(element.attribute("points"), name == "polygon");
        shape.paths = std::move(reading.paths);
        shape.whole = reading.whole;
    } else if (name == "line") {
        const Vec2 from(lengths.of("x1", LengthAxis::X), lengths.of("y1", LengthAxis::Y));
        const Vec2 to(lengths.of("x2", LengthAxis::X), lengths.of("y2", LengthAxis::Y));
        shape.paths.push_back(polygonPath({from, to}, false));
        shape.fillable = false;
    } else if (name == "rect") {
        addRectangle(lengths, shape);
    } else {
        addEllipse(lengths, shape);
    }
    shape.whole = shape.whole && lengths.whole;
    return shape;
}

} // namespace spacetow
