#include "editor/editing/draw_tool.h"

#include "core/geometry/polygon.h"
#include "editor/editing/draw_overlay.h"
#include "editor/editing/drawn_body.h"
#include "editor/editing/measure.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace spacetow {

namespace {

constexpr double closePixels = 10;      // how near the first point closes the shape
constexpr double flatShare = 1e-9;      // of the extent: what is nearer to a line lies on it
constexpr std::size_t leastToClose = 3; // two walls there and back enclose nothing

std::vector<Vec2> relativeTo(const Vec2& origin, std::vector<Vec2> points) {
    for (Vec2& point : points) {
        point -= origin;
    }
    return points;
}

/// Whether all points lie on one line through the first. The area would not tell: that of a bow tie is zero too.
bool isFlat(const std::vector<Vec2>& outline) {
    Vec2 way(0, 0);
    for (const Vec2& point : outline) {
        const Vec2 other = point - outline.front();
        way = other.squaredNorm() > way.squaredNorm() ? other : way;
    }
    return std::all_of(outline.begin(), outline.end(), [&](const Vec2& point) {
        return std::abs(cross(way, point - outline.front())) <= flatShare * way.squaredNorm();
    });
}

} // namespace

std::string DrawTool::code() const {
    switch (m_kind) {
    case DrawKind::Edge:
        return "edge";
    case DrawKind::Line:
        return "line";
    case DrawKind::Polygon:
        break;
    }
    return "polygon";
}

/// The points placed so far, and the one that a first drag is about to place.
std::vector<Vec2> DrawTool::pointsWith(const ToolContext& context) const {
    std::vector<Vec2> points = m_points;
    if (points.empty() && context.pressed) {
        points.push_back(snapped(context.snap, *context.pressed));
    }
    return points;
}

Vec2 DrawTool::nextPoint(const ToolContext& context, const Pointer& pointer) const {
    const std::vector<Vec2> points = pointsWith(context);
    return points.empty() ? snapped(context.snap, pointer) : snappedFrom(context.snap, pointer, points.back());
}

bool DrawTool::closesAt(const ToolContext& context, const Pointer& pointer) const {
    return m_points.size() >= leastToClose &&
           ((pointer.world - m_points.front()).norm() <= closePixels * pointer.pixel ||
            nextPoint(context, pointer) == m_points.front());
}

/// Why a point was not placed is of no interest any more once the pointer has moved on; why a shape was not finished
/// is.
void DrawTool::hover(const ToolContext& context, const Pointer& pointer) {
    if (m_refusal == hintCode("same-point") && nextPoint(context, pointer) != m_points.back()) {
        m_refusal.clear();
    }
}

void DrawTool::cancel() {
    m_points.clear();
    m_refusal.clear();
}

std::optional<FinishedEdit> DrawTool::click(const ToolContext& context, const Pointer& pointer) {
    if (closesAt(context, pointer)) {
        return finish(context, true);
    }
    const Vec2 point = nextPoint(context, pointer);
    if (!m_points.empty() && point == m_points.back()) {
        m_refusal = hintCode("same-point");
    } else if (m_kind == DrawKind::Polygon && m_points.size() == 2 && point == m_points.front()) {
        m_refusal = hintCode("too-few");
    } else {
        m_points.push_back(point);
        m_refusal.clear();
    }
    return {};
}

std::optional<FinishedEdit> DrawTool::drop(const ToolContext& context, const Pointer& pointer) {
    const bool first = m_points.empty();
    m_points = pointsWith(context);
    if (first && nextPoint(context, pointer) == m_points.front()) {
        return {}; // a drag that came back is a click
    }
    return click(context, pointer);
}

std::optional<FinishedEdit> DrawTool::end(const ToolContext& context) {
    if (m_points.empty()) {
        return {};
    }
    if (m_points.size() < leastPoints()) {
        m_refusal = hintCode("too-few");
        return {};
    }
    return finish(context, m_kind == DrawKind::Polygon);
}

std::optional<FinishedEdit> DrawTool::doubleClick(const ToolContext& context, const Pointer&) {
    return end(context);
}

std::optional<FinishedEdit> DrawTool::secondaryClick(const ToolContext& context, const Pointer&) {
    return end(context);
}

std::optional<FinishedEdit> DrawTool::key(const ToolContext& context, ToolKey key, const Pointer&) {
    if (key == ToolKey::Enter) {
        return end(context);
    }
    if ((key == ToolKey::Backspace || key == ToolKey::Delete) && !m_points.empty()) {
        m_points.pop_back();
        m_refusal.clear();
    }
    return {};
}

std::optional<FinishedEdit> DrawTool::finish(const ToolContext& context, bool closed) {
    if (m_kind == DrawKind::Polygon) {
        return finishPolygon(context);
    }
    const Vec2 origin = m_points.front();
    std::vector<Vec2> vertices = relativeTo(origin, std::exchange(m_points, {}));
    m_refusal.clear();
    LevelShape shape = LineChain{vertices, closed};
    if (m_kind == DrawKind::Edge) {
        shape = EdgeChain{std::move(vertices), closed, noBack};
    }
    Edit drawn = withDrawnBody(context, std::move(shape), origin);
    return FinishedEdit{{"draw-" + code(), 1}, std::move(drawn)};
}

std::optional<FinishedEdit> DrawTool::finishPolygon(const ToolContext& context) {
    if (isFlat(m_points)) {
        m_refusal = hintCode("flat");
        return {};
    }
    if (!isSimple(m_points)) {
        m_refusal = hintCode("crosses");
        return {};
    }
    const Vec2 origin = m_points.front();
    std::vector<Vec2> vertices = relativeTo(origin, std::exchange(m_points, {}));
    m_refusal.clear();
    if (signedArea(vertices) < 0) {
        std::reverse(vertices.begin() + 1, vertices.end());
    }
    Edit drawn = withDrawnBody(context, Polygon{std::move(vertices)}, origin);
    return FinishedEdit{{"draw-polygon", 1}, std::move(drawn)};
}

Overlay DrawTool::overlay(const ToolContext& context, const Pointer& pointer) const {
    const bool closes = closesAt(context, pointer);
    const std::vector<Vec2> points = pointsWith(context);
    return draftOverlay({points, closes ? points.front() : nextPoint(context, pointer), closes,
                         m_kind == DrawKind::Polygon, m_kind == DrawKind::Edge, pointer.pixel});
}

Hint DrawTool::hint(const ToolContext& context, const Pointer& pointer) const {
    if (!m_refusal.empty()) {
        return {m_refusal, {}};
    }
    const std::vector<Vec2> points = pointsWith(context);
    if (points.empty()) {
        return {hintCode("start"), {}};
    }
    const std::string count = std::to_string(points.size());
    if (closesAt(context, pointer)) {
        return {hintCode("close"), {count}};
    }
    const Vec2 way = nextPoint(context, pointer) - points.back();
    return {hintCode("next"), {count, lengthText(way.norm()), degreesText(directionOf(way))}};
}

CursorShape DrawTool::cursor(const ToolContext& context, const Pointer& pointer) const {
    return closesAt(context, pointer) ? CursorShape::Pointing : CursorShape::Cross;
}

} // namespace spacetow
