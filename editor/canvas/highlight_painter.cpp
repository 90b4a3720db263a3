#include "editor/canvas/highlight_painter.h"

#include "core/level/groups.h"
#include "core/level/level_index.h"
#include "core/level/outline.h"

#include <QPainterPath>

#include <algorithm>
#include <array>

namespace spacetow {

void paintHighlight(const Stage& stage, const Level& level, std::span<const Key> keys) {
    if (keys.empty()) {
        return;
    }
    const Outlines outlines{Level()}; // connectors, which need the ends, never collide
    const GroupTree groups(level);
    QPainter& painter = stage.painter;
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    QColor fill = stage.theme.collision;
    fill.setAlpha(50);
    QColor glow = stage.theme.collision; // walls are dark themselves
    glow.setAlpha(90);
    levelIndex(level).visitObjects(stage.view.visible(), [&](int place) {
        const Object& object = level.objects[place];
        if (!std::ranges::binary_search(keys, object.key) || !groups.isVisible(object)) {
            return;
        }
        const Outline outline = outlines.of(object);
        const std::array pens{stroke(glow, 9), stroke(stage.theme.collision, 2.5, Qt::DashLine)};
        for (const OutlinePath& path : outline.paths) {
            QPainterPath line;
            line.addPolygon(stage.at(path.points));
            if (path.closed) {
                line.closeSubpath();
            }
            painter.fillPath(line, path.filled ? QBrush(fill) : QBrush(Qt::NoBrush));
            for (const QPen& pen : pens) {
                painter.strokePath(line, pen);
            }
        }
        for (const Circle& circle : outline.discs) {
            const double radius = stage.pixels(circle.radius);
            painter.setBrush(fill);
            for (const QPen& pen : pens) {
                painter.setPen(pen);
                painter.drawEllipse(stage.at(circle.center), radius, radius);
                painter.setBrush(Qt::NoBrush);
            }
        }
    });
    painter.restore();
}

} // namespace spacetow
