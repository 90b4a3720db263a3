#include "editor/canvas/reach_painter.h"

#include <QCoreApplication>
#include <QLocale>

namespace spacetow {

namespace {

struct ReachWords {
    Q_DECLARE_TR_FUNCTIONS(Reach)
};

/// Where the outline of `seconds` is named: at its top, where it can be seen.
void paintTime(const Stage& stage, const QPolygonF& outline, double seconds, const QColor& color) {
    QPointF top = outline.front();
    for (const QPointF& point : outline) {
        top = point.y() < top.y() ? point : top;
    }
    const QString text = ReachWords::tr("%1 s").arg(QLocale().toString(seconds));
    const QRectF box = QRectF(stage.painter.fontMetrics().boundingRect(text)).translated(top + QPointF(0, -4));
    const QRectF placed = box.translated(-box.width() / 2, 0);
    stage.painter.fillRect(placed.adjusted(-3, -1, 3, 1), stage.theme.halo);
    stage.painter.setPen(color);
    stage.painter.drawText(placed, Qt::AlignCenter | Qt::TextDontClip, text);
}

void paintPath(const Stage& stage, const std::vector<Vec2>& path, const QColor& color) {
    if (path.size() > 1) {
        const QPolygonF points = stage.at(path);
        stage.painter.setPen(stroke(stage.theme.halo, 5));
        stage.painter.drawPolyline(points);
        stage.painter.setPen(stroke(color, 2));
        stage.painter.drawPolyline(points);
    }
}

} // namespace

void paintReach(const Stage& stage, const ShownReach& reach) {
    constexpr int veil = 22; // of 255, of each outline; they lie above each other
    const SavedPainter saved(stage.painter);
    QColor ship = stage.theme.shipLine;
    QColor payload = stage.theme.payloadLine;
    if (stage.theme.shade == Shade::Light) { // where the game's own would not be seen
        ship = stage.theme.shipDark.darker(180);
        payload = stage.theme.payloadDark.darker(130);
    }
    for (const ReachOutline& outline : reach.outlines) {
        QColor fill = ship;
        fill.setAlpha(veil);
        const QPolygonF corners = stage.at(outline.ship);
        stage.painter.setPen(stroke(ship, 1.25));
        stage.painter.setBrush(fill);
        stage.painter.drawPolygon(corners);
        stage.painter.setBrush(Qt::NoBrush);
        if (!outline.payload.empty()) {
            stage.painter.setPen(stroke(payload, 1.25, Qt::DashLine));
            stage.painter.drawPolygon(stage.at(outline.payload));
        }
        paintTime(stage, corners, outline.seconds, stage.theme.text);
    }
    paintPath(stage, reach.path.payload, payload);
    paintPath(stage, reach.path.ship, ship);
}

} // namespace spacetow
