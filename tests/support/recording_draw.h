#pragma once
// A DebugDraw that writes down what it is told, as values.

#include "core/physics/query/debug_draw.h"

#include <string>
#include <vector>

namespace spacetow::test {

enum class Form { Circle, FilledCircle, Polygon, FilledPolygon, Line, Rectangle, FilledRectangle, Text };

struct DrawCall {
    Form form;
    std::vector<Vec2> points; // centre, outline, both ends, or the corners `min` and `max`
    double radius;            // 0 unless it is a circle
    Color color;
    std::string text = {};

    bool operator==(const DrawCall&) const = default;
};

class RecordingDraw : public DebugDraw {
  public:
    std::vector<DrawCall> calls;
    int leftOutCount = 0;

    void circle(const Vec2& center, double radius, const Color& color) override {
        calls.push_back({Form::Circle, {center}, radius, color});
    }
    void filledCircle(const Vec2& center, double radius, const Color& color) override {
        calls.push_back({Form::FilledCircle, {center}, radius, color});
    }
    void polygon(std::span<const Vec2> outline, const Color& color) override {
        calls.push_back({Form::Polygon, {outline.begin(), outline.end()}, 0, color});
    }
    void filledPolygon(std::span<const Vec2> outline, const Color& color) override {
        calls.push_back({Form::FilledPolygon, {outline.begin(), outline.end()}, 0, color});
    }
    void line(const Vec2& a, const Vec2& b, const Color& color) override {
        calls.push_back({Form::Line, {a, b}, 0, color});
    }
    void rectangle(const Aabb& box, const Color& color) override {
        calls.push_back({Form::Rectangle, {box.min, box.max}, 0, color});
    }
    void filledRectangle(const Aabb& box, const Color& color) override {
        calls.push_back({Form::FilledRectangle, {box.min, box.max}, 0, color});
    }
    void text(const Vec2& at, std::string_view text, const Color& color) override {
        calls.push_back({Form::Text, {at}, 0, color, std::string(text)});
    }
    void leftOut(const Vec2& /*at*/) override { ++leftOutCount; }
};

/// A picture whose origin is the world's and whose unit is a metre: (x, y) lies at (x, −y).
inline DebugView plainView() {
    DebugView view;
    view.view = {.center = {0, 0}, .scale = 1, .size = {0, 0}};
    view.overlays = {.aabb = true, .incircle = true, .velocity = true, .orientation = true, .normals = true};
    return view;
}

/// Nothing but the bodies and connectors themselves.
inline DebugView bareView() {
    DebugView view = plainView();
    view.overlays = {};
    return view;
}

inline std::vector<DrawCall> recorded(const World& world, const DebugView& view) {
    RecordingDraw draw;
    drawWorld(world, view, draw);
    return draw.calls;
}

/// The same calls with numbers that differ by rounding only.
inline bool sameWithin(double tolerance, const std::vector<DrawCall>& a, const std::vector<DrawCall>& b) {
    const auto samePoint = [tolerance](const Vec2& p, const Vec2& q) {
        return (p - q).cwiseAbs().maxCoeff() <= tolerance;
    };
    const auto sameCall = [&](const DrawCall& c, const DrawCall& d) {
        return c.form == d.form && c.color == d.color && c.text == d.text &&
               std::abs(c.radius - d.radius) <= tolerance &&
               std::equal(c.points.begin(), c.points.end(), d.points.begin(), d.points.end(), samePoint);
    };
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), sameCall);
}

} // namespace spacetow::test
