// What a tool shows while it is at work.
#include "editor/canvas/overlay_painter.h"
#include "editor/canvas/wall_painter.h"

#include <QPainterPath>

#include <ranges>

namespace spacetow {

namespace {

QPen penFor(const Theme& theme, OverlayStyle style) {
    switch (style) {
    case OverlayStyle::Draft:
        return stroke(theme.draft, 2);
    case OverlayStyle::Fault:
        return stroke(theme.overlayVelocity, 3);
    case OverlayStyle::Velocity:
        return stroke(theme.overlayVelocity, 2);
    case OverlayStyle::SolidSide:
        return stroke(theme.rim, 1.4);
    case OverlayStyle::Band:
        return stroke(theme.band, 1.2, Qt::DashLine);
    case OverlayStyle::Handle:
    case OverlayStyle::TurnHandle:
    case OverlayStyle::Pivot:
    case OverlayStyle::Origin:
        return stroke(theme.selection, 1.6);
    case OverlayStyle::HotHandle:
        return stroke(theme.hover, 2.2);
    case OverlayStyle::Snap:
        return stroke(theme.snap, 1.8);
    case OverlayStyle::Measure:
        break;
    }
    return stroke(theme.text, 1, Qt::DotLine);
}

void paintLine(const Stage& stage, const OverlayLine& line) {
    if (line.style == OverlayStyle::SolidSide) {
        const WallRun walls{line.points, line.closed && line.points.size() > 2, line.depth};
        paintRims(stage, {&walls, 1}, stage.theme.rim);
        return;
    }
    if (line.style == OverlayStyle::Band && line.closed) {
        QColor fill = stage.theme.band;
        fill.setAlpha(36);
        stage.painter.setPen(Qt::NoPen);
        stage.painter.setBrush(fill);
        stage.painter.drawPolygon(stage.at(line.points));
        stage.painter.setBrush(Qt::NoBrush);
    }
    stage.painter.setPen(penFor(stage.theme, line.style));
    paintPolyline(stage, line.points, line.closed);
}

void paintPoint(const Stage& stage, const OverlayPoint& point) {
    const QPointF at = stage.at(point.at);
    stage.painter.setPen(penFor(stage.theme, point.style));
    if (point.style == OverlayStyle::Snap) {
        constexpr double arm = 6; // px
        stage.painter.drawLine(at - QPointF(arm, 0), at + QPointF(arm, 0));
        stage.painter.drawLine(at - QPointF(0, arm), at + QPointF(0, arm));
    } else if (point.style == OverlayStyle::TurnHandle) {
        stage.painter.setBrush(stage.theme.background);
        stage.painter.drawEllipse(at, 4.5, 4.5);
    } else if (point.style == OverlayStyle::Pivot) {
        constexpr double arm = 8; // px
        stage.painter.drawEllipse(at, 4, 4);
        stage.painter.drawLine(at - QPointF(arm, 0), at + QPointF(arm, 0));
        stage.painter.drawLine(at - QPointF(0, arm), at + QPointF(0, arm));
    } else if (point.style == OverlayStyle::Origin) {
        constexpr double arm = 5; // px
        const QPen pen = stage.painter.pen();
        for (const QPen& each : {stroke(stage.theme.background, 4), pen}) {
            stage.painter.setPen(each);
            stage.painter.drawLine(at - QPointF(arm, 0), at + QPointF(arm, 0));
            stage.painter.drawLine(at - QPointF(0, arm), at + QPointF(0, arm));
        }
    } else if (point.style == OverlayStyle::HotHandle) {
        stage.painter.setBrush(stage.theme.background);
        stage.painter.drawEllipse(at, 6.5, 6.5);
    } else {
        stage.painter.setBrush(stage.theme.background);
        stage.painter.drawRect(QRectF(at.x() - 3.5, at.y() - 3.5, 7, 7));
    }
    stage.painter.setBrush(Qt::NoBrush);
}

/// Dims all that lies outside the box.
void paintSpotlight(const Stage& stage, const Aabb& box) {
    QPainterPath veil;
    veil.addRect(QRectF(0, 0, stage.view.size.x(), stage.view.size.y()));
    veil.addRect(QRectF(stage.at(Vec2(box.min.x(), box.max.y())), stage.at(Vec2(box.max.x(), box.min.y()))));
    QColor dim = stage.theme.background;
    dim.setAlpha(150);
    stage.painter.fillPath(veil, dim);
    stage.painter.setPen(penFor(stage.theme, OverlayStyle::Measure));
    stage.painter.drawPath(veil);
}

} // namespace

void paintToolOverlay(const Stage& stage, const Overlay& overlay, LabelPainter& labels) {
    stage.painter.save();
    stage.painter.setRenderHint(QPainter::Antialiasing);
    stage.painter.setBrush(Qt::NoBrush);
    if (!overlay.spotlight.isEmpty()) {
        paintSpotlight(stage, overlay.spotlight);
    }
    for (const OverlayLine& line : overlay.lines) {
        paintLine(stage, line);
    }
    for (const OverlayCircle& circle : overlay.circles) {
        stage.painter.setPen(penFor(stage.theme, circle.style));
        const double radius = stage.pixels(circle.radius);
        stage.painter.drawEllipse(stage.at(circle.center), radius, radius);
    }
    for (const OverlayPoint& point : overlay.points) {
        if (point.style != OverlayStyle::Snap || !overlay.snap) {
            paintPoint(stage, point);
        }
    }
    // The last one is the pointer's and stays with it.
    for (const OverlayText& text : std::views::reverse(overlay.texts)) {
        labels.paint(text.at, QString::fromStdString(text.text));
    }
    stage.painter.restore();
}

} // namespace spacetow
