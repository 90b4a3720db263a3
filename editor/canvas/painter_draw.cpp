#include "editor/canvas/painter_draw.h"

namespace spacetow {

namespace {

constexpr double boxWidth = 1;    // px
constexpr double lineWidth = 1.5; // px
constexpr double arrowHead = 6;   // px
constexpr double spare = 8;       // px, for pens and arrow heads

QColor toQColor(const Color& color) {
    return {color.red, color.green, color.blue, color.alpha};
}

QPointF toPoint(const Vec2& point) {
    return {point.x(), point.y()};
}

QPolygonF toPolygon(std::span<const Vec2> outline) {
    QPolygonF points;
    points.reserve(static_cast<qsizetype>(outline.size()));
    for (const Vec2& point : outline) {
        points << toPoint(point);
    }
    return points;
}

QRectF toRect(const Aabb& box) {
    return {toPoint(box.min), toPoint(box.max)};
}

Aabb boxOf(std::span<const Vec2> points) {
    Aabb box;
    for (const Vec2& point : points) {
        box.include(point);
    }
    return box;
}

Aabb boxOf(const Vec2& a, const Vec2& b) {
    return {a.cwiseMin(b), a.cwiseMax(b)};
}

} // namespace

Color toColor(const QColor& color) {
    const auto channel = [](int value) { return static_cast<std::uint8_t>(value); };
    return {channel(color.red()), channel(color.green()), channel(color.blue()), channel(color.alpha())};
}

PainterDraw::PainterDraw(const Stage& stage)
    : m_painter(stage.painter), m_visible(Aabb{Vec2(0, 0), stage.view.size}.grown(spare)) {}

void PainterDraw::circle(const Vec2& center, double radius, const Color& color) {
    if (sees(Aabb{center, center}.grown(radius))) {
        m_painter.setBrush(Qt::NoBrush);
        m_painter.setPen(stroke(toQColor(color), lineWidth));
        m_painter.drawEllipse(toPoint(center), radius, radius);
    }
}

void PainterDraw::filledCircle(const Vec2& center, double radius, const Color& color) {
    if (sees(Aabb{center, center}.grown(radius))) {
        m_painter.setBrush(toQColor(color));
        m_painter.setPen(Qt::NoPen);
        m_painter.drawEllipse(toPoint(center), radius, radius);
    }
}

void PainterDraw::polygon(std::span<const Vec2> outline, const Color& color) {
    if (sees(boxOf(outline))) {
        m_painter.setBrush(Qt::NoBrush);
        m_painter.setPen(stroke(toQColor(color), lineWidth));
        m_painter.drawPolygon(toPolygon(outline));
    }
}

void PainterDraw::filledPolygon(std::span<const Vec2> outline, const Color& color) {
    if (sees(boxOf(outline))) {
        m_painter.setBrush(toQColor(color));
        m_painter.setPen(Qt::NoPen);
        m_painter.drawPolygon(toPolygon(outline));
    }
}

void PainterDraw::line(const Vec2& a, const Vec2& b, const Color& color) {
    if (sees(boxOf(a, b))) {
        m_painter.setPen(stroke(toQColor(color), lineWidth));
        m_painter.drawLine(toPoint(a), toPoint(b));
    }
}

void PainterDraw::rectangle(const Aabb& box, const Color& color) {
    if (sees(box)) {
        m_painter.setBrush(Qt::NoBrush);
        m_painter.setPen(stroke(toQColor(color), boxWidth));
        m_painter.drawRect(toRect(box));
    }
}

void PainterDraw::filledRectangle(const Aabb& box, const Color& color) {
    if (sees(box)) {
        m_painter.fillRect(toRect(box), toQColor(color));
    }
}

void PainterDraw::arrow(const Vec2& from, const Vec2& to, const Color& color) {
    line(from, to, color);
    const Vec2 way = to - from;
    const double length = way.norm();
    if (length > 2 * arrowHead && sees(boxOf(to, to))) {
        const Vec2 along = way * (arrowHead / length);
        const Vec2 across = 0.5 * leftOf(along);
        m_painter.drawLine(toPoint(to), toPoint(to - along + across));
        m_painter.drawLine(toPoint(to), toPoint(to - along - across));
    }
}

} // namespace spacetow
