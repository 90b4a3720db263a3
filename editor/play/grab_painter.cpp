#include "editor/play/grab_painter.h"

#include "editor/canvas/painter_draw.h"

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>

namespace spacetow {
namespace {

constexpr std::size_t shownGhosts = 3; // the newest

struct GrabWords {
    Q_DECLARE_TR_FUNCTIONS(Grab)
};

/// How a path is drawn; among others those of the selection stand out.
struct PathInk {
    QColor color;
    Qt::PenStyle style;
    std::span<const Key> selected;
};

void paintPath(const Stage& stage, const TracedPath& path, const PathInk& ink) {
    const bool stands = std::ranges::find(ink.selected, path.object) != ink.selected.end();
    QColor color = ink.color;
    color.setAlpha(stands ? 255 : ink.selected.empty() ? color.alpha() : color.alpha() / 2);
    constexpr double ring = 4; // px, its radius
    const double width = stands ? 2.5 : 1.5;
    const QPolygonF line = stage.at(path.points);
    const bool isDashed = ink.style != Qt::SolidLine;
    if (const QRectF box = line.boundingRect(); isDashed && std::max(box.width(), box.height()) < 2 * ring) {
        return; // who steps back and goes on gives hardly anything up
    }
    stage.painter.setPen(stroke(color, width, ink.style));
    stage.painter.drawPolyline(line);
    if (isDashed) {
        stage.painter.setPen(stroke(color, width));
        stage.painter.drawEllipse(line.back(), ring, ring);
    }
}

} // namespace

void paintGrab(const Stage& stage, const ShownGrab& grab, LabelPainter& labels) {
    const SavedPainter saved(stage.painter);
    const QPointF from = stage.at(grab.anchor);
    const QPointF to = stage.at(grab.target);
    stage.painter.setPen(stroke(stage.theme.casing, 5));
    stage.painter.drawLine(from, to);
    stage.painter.setPen(stroke(stage.theme.selection, 2));
    stage.painter.drawLine(from, to);
    stage.painter.setBrush(stage.theme.selection);
    stage.painter.drawEllipse(from, 4, 4);
    stage.painter.setBrush(Qt::NoBrush);
    stage.painter.drawEllipse(to, 6, 6);
    const int decimals = grab.force >= 100 ? 0 : grab.force >= 1 ? 1 : 3;
    labels.paint(grab.target, GrabWords::tr("%1 N").arg(QLocale().toString(grab.force, 'f', decimals)));
}

void paintWays(const Stage& stage, const TimelineSummary& timeline, const DebugColors& colors,
               std::span<const Key> selected) {
    const SavedPainter saved(stage.painter);
    const std::size_t ghosts = std::min(shownGhosts, timeline.ghosts.size());
    for (std::size_t i = 0; i < ghosts; ++i) {
        const Ghost& ghost = *timeline.ghosts[timeline.ghosts.size() - ghosts + i];
        QColor color = toQColor(colors.lostWay);
        color.setAlpha(static_cast<int>(200 * (i + 1) / ghosts));
        for (const TracedPath& path : ghost.paths) {
            paintPath(stage, path, {color, Qt::DashLine, selected});
        }
    }
    if (timeline.paths) {
        QColor color = toQColor(colors.way);
        color.setAlpha(170);
        for (const TracedPath& path : *timeline.paths) {
            paintPath(stage, path, {color, Qt::SolidLine, selected});
        }
    }
}

} // namespace spacetow
