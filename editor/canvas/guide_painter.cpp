#include "editor/canvas/guide_painter.h"

#include "core/level/guides.h"

#include <QFontMetricsF>
#include <QLineF>

#include <algorithm>
#include <limits>

namespace spacetow {

namespace {

constexpr double nameMargin = 6; // px from the border of the view

/// The part of the guide that is in view, in pixels; nothing when it passes the view by.
std::optional<QLineF> inView(const Stage& stage, const Guide& guide) {
    const Vec2 at = stage.view.toScreen(guide.point);
    const Vec2 along = stage.view.toScreen(Vec2(guide.point + directionOf(guide) / stage.view.scale)) - at;
    double first = -std::numeric_limits<double>::infinity();
    double last = -first;
    for (const int axis : {0, 1}) {
        const double low = -at[axis];
        const double high = stage.view.size[axis] - at[axis];
        if (std::abs(along[axis]) < 1e-9) {
            if (low > 0 || high < 0) {
                return {};
            }
            continue;
        }
        const auto [near, far] = std::minmax({low / along[axis], high / along[axis]});
        first = std::max(first, near);
        last = std::min(last, far);
    }
    if (!(first < last)) {
        return {};
    }
    const Vec2 a = at + first * along;
    const Vec2 b = at + last * along;
    return QLineF(a.x(), a.y(), b.x(), b.y());
}

void paintName(const Stage& stage, const QLineF& line, const QString& name) {
    const QFontMetricsF metrics(stage.painter.font());
    QRectF plate = metrics.boundingRect(name).adjusted(-4, -1, 4, 1);
    // Where the guide leaves the view on the right, or at the top.
    const QPointF end =
        line.x2() > line.x1() || (line.x2() == line.x1() && line.y2() < line.y1()) ? line.p2() : line.p1();
    plate.moveBottomRight(end - QPointF(nameMargin, nameMargin - 2));
    plate.moveLeft(
        std::clamp(plate.left(), nameMargin, std::max(nameMargin, stage.view.size.x() - plate.width() - nameMargin)));
    plate.moveTop(
        std::clamp(plate.top(), nameMargin, std::max(nameMargin, stage.view.size.y() - plate.height() - nameMargin)));
    stage.painter.setPen(Qt::NoPen);
    stage.painter.setBrush(stage.theme.halo);
    stage.painter.drawRoundedRect(plate, 3, 3);
    stage.painter.setBrush(Qt::NoBrush);
    stage.painter.setPen(stage.theme.guide);
    stage.painter.drawText(plate, Qt::AlignCenter, name);
}

} // namespace

void paintGuides(const Stage& stage, const Level& level, std::optional<std::size_t> hot) {
    stage.painter.save();
    for (std::size_t i = 0; i < level.guides.size(); ++i) {
        const Guide& guide = level.guides[i];
        std::optional<QLineF> line = inView(stage, guide);
        if (!line) {
            continue;
        }
        const Vec2 along = directionOf(guide);
        const bool straight = along.x() == 0 || along.y() == 0;
        stage.painter.setRenderHint(QPainter::Antialiasing, !straight);
        if (straight) { // on whole pixels
            line->translate(along.x() == 0 ? std::floor(line->x1()) + 0.5 - line->x1() : 0,
                            along.y() == 0 ? std::floor(line->y1()) + 0.5 - line->y1() : 0);
        }
        QPen pen = stroke(stage.theme.guide, i == hot ? 2 : 1, Qt::CustomDashLine);
        pen.setDashPattern(i == hot ? QList<qreal>{7, 2, 1, 2} : QList<qreal>{12, 4, 2, 4});
        stage.painter.setPen(pen);
        stage.painter.drawLine(*line);
        stage.painter.setRenderHint(QPainter::Antialiasing);
        stage.painter.setPen(stroke(stage.theme.guide, i == hot ? 2 : 1.2));
        stage.painter.setBrush(stage.theme.background);
        stage.painter.drawEllipse(stage.at(guide.point), 3.5, 3.5);
        stage.painter.setBrush(Qt::NoBrush);
        if (!guide.name.empty()) {
            paintName(stage, *line, QString::fromStdString(guide.name));
        }
    }
    stage.painter.restore();
}

} // namespace spacetow
