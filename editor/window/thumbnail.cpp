#include "editor/window/thumbnail.h"

#include "core/level/bounds.h"
#include "editor/canvas/scene_painter.h"

#include <QPainter>

namespace spacetow {

QImage thumbnailOf(const Level& level, const QSize& size, const Theme& theme) {
    QImage image(size, QImage::Format_RGB32);
    Viewport view;
    view.size = Vec2(size.width(), size.height());
    view = view.showing(boundsOf(level));
    image.fill(theme.background);
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    paintLevel({painter, view, theme}, level, Selection());
    return image;
}

} // namespace spacetow
