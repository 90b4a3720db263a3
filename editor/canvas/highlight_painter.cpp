#include "editor/canvas/highlight_painter.h"

#include "core/level/level_index.h"
#include "core/level/outline.h"

#include <QPainterPath>

#include <algorithm>

namespace spacetow {

void paintHighlight(const Stage& stage, const Level& level, std::span<const Key> keys) {
    if (keys.empty()) {
        return;
    }
    const Outlines outlines{Level()}; // connectors, which need the ends, never collide
    QPainter& painter = stage.painter;
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    QColor fill = stage.theme.collision;
    fill.setAlpha(50);
    levelIndex(level).visitObjects(stage.view.visible(), [&](int place) {
        const Object& object = level.objects[place];
        if (!std::ranges::binary_search(keys, object.key)) {
            return;
        }
        const Outline outline = outlines.of(object);
        painter.setPen(stroke(stage.theme.collision, 2.5, Qt::DashLine));
        for (const OutlinePath& path : outline.paths) {
            QPainterPath line;
            line.addPolygon(stage.at(path.points));
            if (path.closed) {
                line.closeSubpath();
            }
            painter.setBrush(path.filled ? QBrush(fill) : QBrush(Qt::NoBrush));
            painter.drawPath(line);
        }
        painter.setBrush(fill);
        for (const Circle& circle : outline.discs) {
            const double radius = stage.pixels(circle.radius);
            painter.drawEllipse(stage.at(circle.center), radius, radius);
        }
    });
    painter.restore();
}

} // namespace spacetow
