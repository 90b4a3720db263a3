#include "editor/canvas/label_painter.h"

#include <QFontMetricsF>
#include <QPainter>

#include <algorithm>

namespace spacetow {

QRectF LabelPainter::placed(const QPointF& at, const QSizeF& size, LabelSide side) const {
    constexpr double away = 12; // px, from the point
    constexpr double apart = 2; // px, from other labels and the border
    constexpr int most = 8;     // labels between the point and this one
    const double down = side == LabelSide::Above ? -1 : 1;
    const auto plateAt = [&](double right, double below, int row) {
        const double x = right > 0 ? at.x() + away : at.x() - away - size.width();
        const double y = below > 0 ? at.y() + away : at.y() - away - size.height();
        const Vec2 room(std::max(apart, m_stage.view.size.x() - size.width() - apart),
                        std::max(apart, m_stage.view.size.y() - size.height() - apart));
        // What is out of sight is named at the border, from where rows are counted.
        const double top = std::clamp(y, apart, room.y()) + below * row * (size.height() + 2 * apart);
        return QRectF({std::clamp(x, apart, room.x()), std::clamp(top, apart, room.y())}, size);
    };
    const auto isFree = [&](const QRectF& plate) {
        return std::ranges::none_of(m_plates, [&](const QRectF& other) {
            return other.adjusted(-apart, -apart, apart, apart).intersects(plate);
        });
    };
    for (int row = 0; row < most; ++row) {
        for (const double below : {down, -down}) {
            for (const double right : {1.0, -1.0}) {
                if (const QRectF plate = plateAt(right, below, row); isFree(plate)) {
                    return plate;
                }
            }
        }
    }
    return plateAt(1, down, 0);
}

void LabelPainter::paint(const Vec2& at, const QString& words, LabelSide side) {
    QPainter& painter = m_stage.painter;
    constexpr QRectF unbounded(0, 0, 4000, 4000);
    const QSizeF size = QFontMetricsF(painter.font())
                            .boundingRect(unbounded, Qt::AlignLeft | Qt::AlignTop, words)
                            .adjusted(-6, -3, 6, 3)
                            .size();
    const QRectF plate = placed(m_stage.at(at), size, side);
    m_plates.push_back(plate);
    painter.setPen(Qt::NoPen);
    painter.setBrush(m_stage.theme.halo);
    painter.drawRoundedRect(plate, 4, 4);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(m_stage.theme.text);
    painter.drawText(plate.adjusted(6, 3, -6, -3), Qt::AlignLeft | Qt::AlignVCenter, words);
}

void paintInMiddle(const Stage& stage, const QString& words) {
    constexpr double margin = 16; // px
    constexpr int flags = Qt::AlignCenter | Qt::TextWordWrap;
    const QRectF view(0, 0, stage.view.size.x(), stage.view.size.y());
    const QRectF room = view.adjusted(2 * margin, margin, -2 * margin, -margin);
    const QRectF text = QFontMetricsF(stage.painter.font()).boundingRect(room, flags, words);
    stage.painter.setPen(Qt::NoPen);
    stage.painter.setBrush(stage.theme.halo);
    stage.painter.drawRoundedRect(text.adjusted(-margin, -margin, margin, margin), 6, 6);
    stage.painter.setBrush(Qt::NoBrush);
    stage.painter.setPen(stage.theme.text);
    stage.painter.drawText(room, flags, words);
}

} // namespace spacetow
