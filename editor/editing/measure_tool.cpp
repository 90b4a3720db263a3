#include "editor/editing/measure_tool.h"

#include "core/math/affine.h"
#include "editor/editing/measure.h"
#include "editor/editing/snap_point.h"

#include <array>
#include <charconv>
#include <cmath>
#include <numbers>

namespace spacetow {

namespace {

constexpr std::size_t mostMeasured = 3;
constexpr double dragAway = 4;   // px from where the button went down
constexpr double arcRadius = 28; // px

/// All digits that there are: for the clipboard.
std::string fullText(double value) {
    std::array<char, 64> text;
    const double shown = std::round(value * 1e6) / 1e6 + 0.0;
    const auto end = std::to_chars(text.data(), text.data() + text.size(), shown);
    return {text.data(), end.ptr};
}

double inDegrees(double radians) {
    return radians * 180 / std::numbers::pi;
}

/// From the first leg round to the second, the shorter way.
std::vector<Vec2> arcBetween(const std::vector<Vec2>& points, double radius) {
    const Vec2 back = points[0] - points[1];
    const Vec2 on = points[2] - points[1];
    const double turn = std::atan2(cross(back, on), back.dot(on));
    const double from = directionOf(back);
    constexpr int steps = 24;
    std::vector<Vec2> arc;
    for (int i = 0; i <= steps; ++i) {
        const double angle = from + turn * i / steps;
        arc.emplace_back(points[1] + radius * Vec2(std::cos(angle), std::sin(angle)));
    }
    return arc;
}

void addLeg(Overlay& overlay, const Vec2& from, const Vec2& to, const Vec2& label) {
    overlay.lines.push_back({OverlayStyle::Measure, {from, {to.x(), from.y()}, to}}); // across, then upwards
    overlay.lines.push_back({OverlayStyle::Draft, {from, to}});
    overlay.texts.push_back({label, wayText(to - from)});
}

std::vector<std::string> wayArguments(const Vec2& way) {
    return {lengthText(way.norm()), lengthText(way.x()), lengthText(way.y()), degreesText(directionOf(way))};
}

} // namespace

double angleBetween(const Vec2& a, const Vec2& at, const Vec2& b) {
    const Vec2 first = a - at;
    const Vec2 second = b - at;
    return std::abs(std::atan2(cross(first, second), first.dot(second)));
}

/// The points that stay when the pointer goes on; a drag begins with the one where the button went down.
std::vector<Vec2> MeasureTool::placed(const ToolContext& context, const Pointer& pointer) const {
    const bool drags = context.pressed && (pointer.screen - context.pressed->screen).norm() > dragAway;
    if (drags) {
        return {snapped(context, *context.pressed)};
    }
    return m_points.size() < mostMeasured ? m_points : std::vector<Vec2>();
}

std::vector<Vec2> MeasureTool::withPointer(const ToolContext& context, const Pointer& pointer) const {
    std::vector<Vec2> points = placed(context, pointer);
    const Vec2 next = points.empty() ? snapped(context, pointer) : snappedFrom(context, pointer, points.back());
    if (points.empty() || next != points.back()) {
        points.push_back(next);
    }
    return points;
}

std::optional<FinishedEdit> MeasureTool::click(const ToolContext& context, const Pointer& pointer) {
    m_points = withPointer(context, pointer);
    return {};
}

std::optional<FinishedEdit> MeasureTool::drop(const ToolContext& context, const Pointer& pointer) {
    m_points = withPointer(context, pointer);
    return {};
}

std::optional<FinishedEdit> MeasureTool::secondaryClick(const ToolContext&, const Pointer&) {
    cancel();
    return {};
}

std::optional<FinishedEdit> MeasureTool::key(const ToolContext&, ToolKey key, const Pointer&) {
    if ((key == ToolKey::Backspace || key == ToolKey::Delete) && !m_points.empty()) {
        m_points.pop_back();
    }
    return {};
}

Overlay MeasureTool::overlay(const ToolContext& context, const Pointer& pointer) const {
    Overlay overlay;
    const bool stands = m_points.size() == mostMeasured && !context.pressed;
    const std::vector<Vec2> points = stands ? m_points : withPointer(context, pointer);
    for (std::size_t i = 1; i < points.size(); ++i) {
        // At the corner of two legs there is their angle to be read.
        const bool atCorner = i + 1 < points.size();
        addLeg(overlay, points[i - 1], points[i], atCorner ? Vec2(0.5 * (points[i - 1] + points[i])) : points[i]);
    }
    for (const Vec2& point : points) {
        overlay.points.push_back({OverlayStyle::Handle, point});
    }
    if (points.size() == mostMeasured) {
        const std::vector<Vec2> arc = arcBetween(points, arcRadius * pointer.pixel);
        overlay.texts.push_back(
            {arc[arc.size() / 2], degreesText(angleBetween(points[0], points[1], points[2])) + "°"});
        overlay.lines.push_back({OverlayStyle::Draft, arc});
    }
    return overlay;
}

Hint MeasureTool::hint(const ToolContext& context, const Pointer& pointer) const {
    if (m_points.size() == mostMeasured && !context.pressed) {
        std::vector<std::string> arguments{degreesText(angleBetween(m_points[0], m_points[1], m_points[2]))};
        arguments.push_back(lengthText((m_points[1] - m_points[0]).norm()));
        arguments.push_back(lengthText((m_points[2] - m_points[1]).norm()));
        return {"measure.angle", std::move(arguments)};
    }
    const std::vector<Vec2> points = withPointer(context, pointer);
    if (points.size() < 2) {
        return {m_points.empty() ? "measure.start" : "measure.same-point", {}};
    }
    std::vector<std::string> arguments = wayArguments(points[1] - points[0]);
    if (m_points.size() < 2 || points.size() < mostMeasured) {
        return {m_points.size() < 2 ? "measure.first" : "measure.done", std::move(arguments)};
    }
    arguments.push_back(degreesText(angleBetween(points[0], points[1], points[2])));
    return {"measure.second", std::move(arguments)};
}

std::optional<SnapAnswer> MeasureTool::snapAt(const ToolContext& context, const Pointer& pointer) const {
    const std::vector<Vec2> points = placed(context, pointer);
    return points.empty() ? snapOf(context, pointer) : snapFrom(context, pointer, points.back());
}

std::string MeasureTool::numbers() const {
    if (m_points.size() < 2) {
        return {};
    }
    std::string text;
    for (std::size_t i = 1; i < m_points.size(); ++i) {
        const Vec2 way = m_points[i] - m_points[i - 1];
        text += fullText(way.norm()) + " m  Δx " + fullText(way.x()) + " m  Δy " + fullText(way.y()) + " m  " +
                fullText(inDegrees(directionOf(way))) + "°\n";
    }
    if (m_points.size() == mostMeasured) {
        text += "∠ " + fullText(inDegrees(angleBetween(m_points[0], m_points[1], m_points[2]))) + "°\n";
    }
    return text;
}

} // namespace spacetow
