#include "editor/canvas/body_painter.h"

#include "core/game/ship.h"
#include "editor/canvas/wall_painter.h"

#include <QPainterPath>
#include <QRadialGradient>

#include <algorithm>
#include <array>
#include <cmath>

namespace spacetow {

namespace {

constexpr double outline = 1.8;          // px
constexpr double kinematicOutline = 2.6; // px
constexpr double hatchFrom = 14;         // px; smaller static shapes are filled plainly
constexpr double leastSize = 3;          // px; smaller shapes are drawn as dots of this size, or nobody would find them

QPen outlinePen(const BodyColors& colors, const BodyStyle& style) {
    const double width = style.kind == BodyKind::Kinematic ? kinematicOutline : outline;
    QPen pen = stroke(colors.line, width, style.tangible ? Qt::SolidLine : Qt::DashLine);
    if (!style.tangible) {
        pen.setDashPattern({4, 3});
    }
    return pen;
}

QBrush bodyBrush(const BodyColors& colors, const BodyStyle& style) {
    QColor fill = colors.fill;
    if (!style.tangible) {
        fill.setAlphaF(fill.alphaF() * 0.25F);
    }
    return fill;
}

/// Hatching tells static bodies from moving ones without colour.
void hatch(const Stage& stage, const QPainterPath& path, const BodyColors& colors, const BodyStyle& style) {
    const QRectF box = path.boundingRect();
    if (style.kind == BodyKind::Static && style.tangible && std::min(box.width(), box.height()) >= hatchFrom) {
        QColor line = colors.line;
        line.setAlpha(60);
        // Fixed to the world, so that pictures put together from strips have no seams. The toolkit scales neither the
        // pattern nor its origin by the ratio of device pixels.
        const double ratio = stage.painter.device()->devicePixelRatioF();
        const QTransform& world = stage.painter.worldTransform();
        const QPointF moved(world.dx(), world.dy());
        const QPointF origin = (stage.at(Vec2(0, 0)) + moved) * ratio;
        constexpr double period = 8; // device pixels
        stage.painter.setBrushOrigin(QPointF(std::fmod(origin.x(), period), std::fmod(origin.y(), period)) - moved);
        stage.painter.fillPath(path, QBrush(line, Qt::BDiagPattern));
        stage.painter.setBrushOrigin(QPointF(0, 0));
    }
}

void paintFilled(const Stage& stage, const QPainterPath& path, const BodyColors& colors, const BodyStyle& style) {
    const QRectF box = path.boundingRect();
    if (std::max(box.width(), box.height()) < leastSize) {
        const QPointF corner(leastSize / 2, leastSize / 2);
        stage.painter.fillRect(QRectF(box.center() - corner, QSizeF(leastSize, leastSize)), colors.line);
        return;
    }
    stage.painter.fillPath(path, bodyBrush(colors, style));
    hatch(stage, path, colors, style);
    stage.painter.setPen(outlinePen(colors, style));
    stage.painter.setBrush(Qt::NoBrush);
    stage.painter.drawPath(path);
}

Aabb boxAround(const Vec2& center, double radius) {
    return Aabb{center, center}.grown(radius);
}

void paintCircle(const Stage& stage, const Circle& circle, const Transform& pose, const BodyStyle& style) {
    const Vec2 center = pose.toWorld(circle.center);
    if (!stage.sees(boxAround(center, circle.radius))) {
        return;
    }
    paintDisc(stage, stage.at(center), stage.pixels(circle.radius), style);
    paintSpoke(stage, circle, pose, style);
}

void paintPolygon(const Stage& stage, const Polygon& polygon, const Transform& pose, const BodyStyle& style) {
    std::vector<Vec2> world;
    Aabb box;
    for (const Vec2& vertex : polygon.vertices) {
        world.push_back(pose.toWorld(vertex));
        box.include(world.back());
    }
    if (world.size() < 2 || !stage.sees(box)) {
        return;
    }
    QPainterPath path;
    path.addPolygon(stage.at(world));
    path.closeSubpath();
    paintFilled(stage, path, stage.theme.body(style.kind, polygon), style);
}

QPainterPath outlineOf(const Stage& stage, const Transform& pose, std::span<const Vec2> local) {
    QPolygonF points;
    for (const Vec2& vertex : local) {
        points << stage.at(pose.toWorld(vertex));
    }
    QPainterPath path;
    path.addPolygon(points);
    path.closeSubpath();
    return path;
}

} // namespace

void paintDisc(const Stage& stage, const QPointF& center, double radius, const BodyStyle& style) {
    QPainterPath path;
    path.addEllipse(center, radius, radius);
    paintFilled(stage, path, stage.theme.body(style.kind, Circle{}), style);
}

void paintSpoke(const Stage& stage, const Circle& circle, const Transform& pose, const BodyStyle& style) {
    constexpr double least = 4; // px, of a radius
    if (style.kind == BodyKind::Static || stage.pixels(circle.radius) <= least) {
        return;
    }
    const Vec2 center = pose.toWorld(circle.center);
    const Vec2 spoke = pose.rotation.up() * circle.radius;
    stage.painter.setPen(outlinePen(stage.theme.body(style.kind, circle), style));
    stage.painter.drawLine(stage.at(center + 0.55 * spoke), stage.at(center + spoke));
}

void paintShape(const Stage& stage, const Shape& shape, const Transform& pose, const BodyStyle& style) {
    if (const auto* circle = std::get_if<Circle>(&shape)) {
        paintCircle(stage, *circle, pose, style);
    } else if (const auto* polygon = std::get_if<Polygon>(&shape)) {
        paintPolygon(stage, *polygon, pose, style);
    } else if (const auto* edge = std::get_if<Edge>(&shape)) {
        const std::array<Vec2, 2> ends{pose.toWorld(edge->a), pose.toWorld(edge->b)};
        paintChain(stage, ends, false, {style, WallKind::OneWay});
    } else if (const auto* line = std::get_if<Line>(&shape)) {
        const std::array<Vec2, 2> ends{pose.toWorld(line->a), pose.toWorld(line->b)};
        paintChain(stage, ends, false, {style, WallKind::TwoWay});
    }
}

void paintChain(const Stage& stage, std::span<const Vec2> world, bool closed, const ChainStyle& style) {
    const bool oneWay = style.kind == WallKind::OneWay;
    const BodyColors colors = stage.theme.body(style.body.kind, oneWay ? Shape(Edge{}) : Shape(Line{}));
    QPen pen = outlinePen(colors, style.body);
    if (!oneWay && style.body.tangible) {
        // A wall that is solid from both sides is drawn as two rails with a dark core.
        pen.setWidthF(pen.widthF() + 2.6);
        stage.painter.setPen(pen);
        paintPolyline(stage, world, closed);
        pen = stroke(stage.theme.background, 1.4);
    }
    stage.painter.setPen(pen);
    paintPolyline(stage, world, closed);
}

void paintKinematicMark(const Stage& stage, const Vec2& at) {
    constexpr double arm = 9;  // px
    constexpr double head = 3; // px
    const QPointF middle = stage.at(at);
    const auto arrows = [&] {
        for (int quarter = 0; quarter < 4; ++quarter) {
            const Rot turn = Rot::fromAngle(quarter * 1.5707963267948966);
            const auto point = [&](double x, double y) {
                const Vec2 p = turn * Vec2(x, y);
                return middle + QPointF(p.x(), p.y());
            };
            stage.painter.drawLine(middle, point(arm, 0));
            stage.painter.drawLine(point(arm, 0), point(arm - head, head));
            stage.painter.drawLine(point(arm, 0), point(arm - head, -head));
        }
    };
    stage.painter.setPen(stroke(stage.theme.halo, 3.5));
    arrows();
    stage.painter.setPen(stroke(stage.theme.text, 1.4));
    arrows();
}

void paintShip(const Stage& stage, const Transform& pose) {
    const Polygon hull = shipHull();
    if (!stage.sees(boxAround(pose.position, 0.5))) {
        return;
    }
    QPainter& painter = stage.painter;
    const QPainterPath path = outlineOf(stage, pose, hull.vertices);
    painter.fillPath(path, stage.theme.shipLight);
    // The half that lies in the shade.
    std::vector<Vec2> shade;
    for (const Vec2& vertex : hull.vertices) {
        if (vertex.x() >= -1e-9) {
            shade.push_back(vertex);
        }
    }
    painter.fillPath(outlineOf(stage, pose, shade), stage.theme.shipDark);
    if (stage.pixels(0.2) > 5) {
        const std::array<Vec2, 4> glass{Vec2(0, 0.135), Vec2(-0.042, 0.04), Vec2(0, 0.01), Vec2(0.042, 0.04)};
        painter.fillPath(outlineOf(stage, pose, glass), stage.theme.shipGlass);
    }
    painter.setBrush(Qt::NoBrush);
    painter.setPen(stroke(stage.theme.shipLine, 1.4));
    painter.drawPath(path);
}

void paintPayload(const Stage& stage, const Vec2& center, double radius) {
    if (!stage.sees(boxAround(center, radius))) {
        return;
    }
    const QPointF middle = stage.at(center);
    const double size = stage.pixels(radius);
    QRadialGradient shine(middle - QPointF(0.35 * size, 0.4 * size), 1.5 * size);
    shine.setColorAt(0, stage.theme.payloadLight);
    shine.setColorAt(1, stage.theme.payloadDark);
    stage.painter.setBrush(shine);
    stage.painter.setPen(stroke(stage.theme.payloadLine, 1.4));
    stage.painter.drawEllipse(middle, size, size);
    stage.painter.setBrush(Qt::NoBrush);
}

void paintFinish(const Stage& stage, const Vec2& a, const Vec2& b) {
    Aabb box{a, a};
    box.include(b);
    if (!stage.sees(box)) {
        return;
    }
    QPainter& painter = stage.painter;
    const QPointF from = stage.at(a);
    const QPointF to = stage.at(b);
    QColor glow = stage.theme.finish;
    glow.setAlpha(44);
    painter.setPen(stroke(glow, 11));
    painter.drawLine(from, to);
    QPen pen = stroke(stage.theme.finish, 3);
    pen.setCapStyle(Qt::FlatCap);
    painter.setPen(pen);
    paintDashed(stage, a, b, {9, 6});
    painter.setPen(stroke(stage.theme.background, 1.5));
    painter.setBrush(stage.theme.finish);
    painter.drawEllipse(from, 5, 5);
    painter.drawEllipse(to, 5, 5);
    painter.setBrush(Qt::NoBrush);
}

void paintConnector(const Stage& stage, const Vec2& a, const Vec2& b, double length) {
    Aabb box{a, a};
    box.include(b);
    if (!stage.sees(box)) {
        return;
    }
    const double distance = (b - a).norm();
    const double ratio = length > 0 ? std::clamp(distance / length, 0.5, 1.5) : 1;
    // Like a rubber band: the longer the thinner, so that the state is not told by hue alone.
    const double width = 2.4 / (ratio * ratio);
    QPainter& painter = stage.painter;
    painter.setPen(stroke(stage.theme.casing, width + 2.5));
    painter.drawLine(stage.at(a), stage.at(b));
    painter.setPen(stroke(Theme::connector(distance, length), width));
    painter.drawLine(stage.at(a), stage.at(b));
    painter.setPen(Qt::NoPen);
    painter.setBrush(Theme::connector(distance, length));
    for (const Vec2& end : {a, b}) {
        painter.drawEllipse(stage.at(end), 2.6, 2.6);
    }
    painter.setBrush(Qt::NoBrush);
}

} // namespace spacetow
