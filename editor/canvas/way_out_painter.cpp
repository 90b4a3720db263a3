#include "editor/canvas/way_out_painter.h"

#include <vector>

namespace spacetow {

namespace {

constexpr double arrowSize = 11;  // px
constexpr double arrowEvery = 90; // px; shorter pieces have no arrow of their own

/// At `tip`, in the direction from `from`.
QPolygonF wayArrow(const QPointF& from, const QPointF& tip, double size) {
    const Vec2 way(tip.x() - from.x(), tip.y() - from.y());
    if (way.norm() == 0) {
        return {};
    }
    const Vec2 along = size * way.normalized();
    const Vec2 aside = 0.45 * leftOf(along);
    const QPointF back = tip - QPointF(along.x(), along.y());
    return QPolygonF{{tip, back + QPointF(aside.x(), aside.y()), back - QPointF(aside.x(), aside.y())}};
}

std::vector<QPolygonF> wayArrows(const Stage& stage, std::span<const Vec2> way) {
    std::vector<QPolygonF> heads;
    for (std::size_t i = 0; i + 1 < way.size(); ++i) {
        const bool isLast = i + 2 == way.size();
        if (!isLast && stage.pixels((way[i + 1] - way[i]).norm()) < arrowEvery) {
            continue;
        }
        const Vec2 tip = isLast ? way[i + 1] : Vec2(0.5 * (way[i] + way[i + 1]));
        if (stage.view.visible().grown(arrowSize * stage.view.pixel()).contains(tip)) {
            heads.push_back(wayArrow(stage.at(way[i]), stage.at(tip), isLast ? 1.4 * arrowSize : arrowSize));
        }
    }
    return heads;
}

void paintLines(const Stage& stage, std::span<const Vec2> points, QPen pen) {
    pen.setCapStyle(Qt::FlatCap);
    stage.painter.setPen(pen);
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        paintDashed(stage, points[i], points[i + 1], {9, 6});
    }
}

} // namespace

void paintWayOut(const Stage& stage, std::span<const Vec2> way, QColor color, bool isStrong) {
    Aabb box;
    for (const Vec2& point : way) {
        box.include(point);
    }
    if (box.isEmpty() || !stage.sees(box)) {
        return;
    }
    const SavedPainter saved(stage.painter);
    const double width = isStrong ? 2.5 : 1.5;
    color.setAlpha(isStrong ? 255 : 170);
    paintLines(stage, way, stroke(stage.theme.halo, width + 2.5));
    paintLines(stage, way, stroke(color, width));
    stage.painter.setPen(stroke(stage.theme.halo, 1.2));
    stage.painter.setBrush(color);
    for (const QPolygonF& head : wayArrows(stage, way)) {
        stage.painter.drawPolygon(head);
    }
}

} // namespace spacetow
