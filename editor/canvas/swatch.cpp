#include "editor/canvas/swatch.h"

#include "editor/canvas/painter_draw.h"

#include <QPainter>
#include <QPixmap>

namespace spacetow {

QIcon swatch(std::span<const Color> colors, int side) {
    QPixmap pixmap(side, side);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    const double wide = static_cast<double>(side) / static_cast<double>(colors.size());
    for (std::size_t i = 0; i < colors.size(); ++i) {
        painter.fillRect(QRectF(static_cast<double>(i) * wide, 0, wide, side), toQColor(colors[i]));
    }
    painter.setPen(QColor(128, 128, 128));
    painter.drawRect(0, 0, side - 1, side - 1);
    return pixmap;
}

} // namespace spacetow
