#include "editor/canvas/label_painter.h"

#include <QFontMetricsF>

#include <algorithm>

namespace spacetow {

void paintLabel(const Stage& stage, const Vec2& at, const QString& words, LabelSide side) {
    const QFontMetricsF metrics(stage.painter.font());
    constexpr QRectF unbounded(0, 0, 4000, 4000);
    QRectF plate = metrics.boundingRect(unbounded, Qt::AlignLeft | Qt::AlignTop, words).adjusted(-6, -3, 6, 3);
    constexpr double away = 12; // px
    if (side == LabelSide::Above) {
        plate.moveBottomLeft(stage.at(at) + QPointF(away, -away));
    } else {
        plate.moveTopLeft(stage.at(at) + QPointF(away, away));
    }
    plate.moveLeft(std::clamp(plate.left(), 2.0, std::max(2.0, stage.view.size.x() - plate.width() - 2)));
    plate.moveTop(std::clamp(plate.top(), 2.0, std::max(2.0, stage.view.size.y() - plate.height() - 2)));
    stage.painter.setPen(Qt::NoPen);
    stage.painter.setBrush(stage.theme.halo);
    stage.painter.drawRoundedRect(plate, 4, 4);
    stage.painter.setBrush(Qt::NoBrush);
    stage.painter.setPen(stage.theme.text);
    stage.painter.drawText(plate.adjusted(6, 3, -6, -3), Qt::AlignLeft | Qt::AlignVCenter, words);
}

} // namespace spacetow
