#include "editor/canvas/snap_painter.h"

#include <QLineF>

namespace spacetow {

namespace {

void addStroke(QPainterPath& path, const QPointF& from, const QPointF& to) {
    path.moveTo(from);
    path.lineTo(to);
}

void addRing(QPainterPath& path, double radius) {
    path.addEllipse(QPointF(0, 0), radius, radius);
}

void addTurned(QPainterPath& path, double size) {
    path.addPolygon(QPolygonF{{0, -size}, {size, 0}, {0, size}, {-size, 0}, {0, -size}});
}

} // namespace

QPainterPath snapMarker(SnapKind kind) {
    constexpr double size = 6; // px
    QPainterPath path;
    switch (kind) {
    case SnapKind::None:
        break;
    case SnapKind::Vertex:
        path.addRect(-size + 1, -size + 1, 2 * size - 2, 2 * size - 2);
        break;
    case SnapKind::Center:
        addRing(path, size);
        addRing(path, 1.2);
        break;
    case SnapKind::Anchor:
        addTurned(path, size);
        addRing(path, 1.2);
        break;
    case SnapKind::Intersection:
        addStroke(path, {-size, -size}, {size, size});
        addStroke(path, {-size, size}, {size, -size});
        break;
    case SnapKind::Midpoint:
        path.addPolygon(QPolygonF{{0, -size}, {size, size - 1}, {-size, size - 1}, {0, -size}});
        break;
    case SnapKind::Perpendicular:
        addStroke(path, {-size, size}, {size, size});
        addStroke(path, {0, size}, {0, -size});
        addStroke(path, {0, 0}, {size, 0});
        addStroke(path, {size, 0}, {size, size});
        break;
    case SnapKind::Edge:
        addTurned(path, size);
        break;
    case SnapKind::Guide:
        addTurned(path, size);
        addStroke(path, {-2 * size, 0}, {-size, 0});
        addStroke(path, {size, 0}, {2 * size, 0});
        break;
    case SnapKind::Alignment:
        addStroke(path, {-size, 0}, {size, 0});
        addStroke(path, {0, -size}, {0, size});
        addRing(path, size / 2);
        break;
    case SnapKind::Angle:
        addStroke(path, {-size, size}, {size, size});
        addStroke(path, {-size, size}, {size - 1, -size});
        path.moveTo(3, size);
        path.quadTo(QPointF(3, 1), QPointF(0, -1));
        break;
    case SnapKind::Grid:
        addStroke(path, {-size, 0}, {size, 0});
        addStroke(path, {0, -size}, {0, size});
        break;
    }
    return path;
}

void paintSnap(const Stage& stage, const SnapAnswer& snap, const QString& name, LabelPainter& labels) {
    QPainter& painter = stage.painter;
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    for (const SnapLine& line : snap.lines) {
        painter.setPen(stroke(stage.theme.snap, 1.2, Qt::DashLine));
        painter.drawLine(QLineF(stage.at(line.from), stage.at(line.to)));
    }
    const QPainterPath marker = snapMarker(snap.kind).translated(stage.at(snap.mark));
    painter.setPen(stroke(stage.theme.halo, 4));
    painter.drawPath(marker);
    painter.setPen(stroke(stage.theme.snap, 1.8));
    painter.drawPath(marker);
    if (!name.isEmpty() && snap.kind != SnapKind::Grid) {
        labels.paint(snap.mark, name, LabelSide::Below);
    }
    painter.restore();
}

} // namespace spacetow
