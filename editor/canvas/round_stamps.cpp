#include "editor/canvas/round_stamps.h"

#include <QImage>
#include <QPaintDevice>

#include <cmath>
#include <map>
#include <vector>

namespace spacetow {

namespace {

constexpr int stampParts = 2;          // of a device pixel, in which sizes are told apart
constexpr double largestStamp = 64;    // device pixels: above, copying takes as long as painting
constexpr std::size_t worthAStamp = 8; // of a size, that a stamp is worth it

QImage stampOf(const QPainter& like, double side, double ratio) {
    const double room = like.pen().style() == Qt::NoPen ? 1 : like.pen().widthF() + 1;
    const auto all = static_cast<int>(std::ceil(side + 2 * room * ratio));
    QImage stamp(all, all, QImage::Format_ARGB32_Premultiplied);
    stamp.setDevicePixelRatio(ratio);
    stamp.fill(Qt::transparent);
    QPainter painter(&stamp);
    painter.setRenderHint(QPainter::Antialiasing); // it costs nothing here
    painter.setPen(like.pen());
    painter.setBrush(like.brush());
    const double middle = 0.5 * all / ratio;
    painter.drawEllipse(QPointF(middle, middle), 0.5 * side / ratio, 0.5 * side / ratio);
    return stamp;
}

} // namespace

void stampEllipses(QPainter& painter, std::span<const QRectF> boxes) {
    const double ratio = painter.device()->devicePixelRatioF();
    std::map<int, std::vector<QPointF>> centers; // by their size, in parts
    for (const QRectF& box : boxes) {
        if (const double side = ratio * box.width(); side <= largestStamp) {
            centers[static_cast<int>(std::lround(stampParts * side))].push_back(box.center());
        } else {
            painter.drawEllipse(box);
        }
    }
    for (const auto& [size, places] : centers) {
        const double side = static_cast<double>(size) / stampParts;
        const QPointF half(0.5 * side / ratio, 0.5 * side / ratio);
        if (places.size() < worthAStamp) {
            for (const QPointF& center : places) {
                painter.drawEllipse(QRectF(center - half, center + half));
            }
            continue;
        }
        const QImage stamp = stampOf(painter, side, ratio);
        const double middle = 0.5 * stamp.width() / ratio;
        for (const QPointF& center : places) {
            painter.drawImage(center - QPointF(middle, middle), stamp);
        }
    }
}

} // namespace spacetow
