#include "editor/canvas/level_picture.h"

#include "core/level/bounds.h"
#include "editor/canvas/scene_painter.h"

namespace spacetow {

Viewport pictureView(const Level& level, const QSize& logical) {
    Viewport view;
    view.size = Vec2(logical.width(), logical.height());
    return view.showing(boundsOf(level));
}

QImage levelPicture(const Level& level, const PictureSize& size, Shade shade) {
    QImage image(size.logical * size.ratio, QImage::Format_RGB32);
    image.setDevicePixelRatio(size.ratio);
    const Theme& theme = editingTheme(shade);
    image.fill(theme.background);
    const Viewport view = pictureView(level, size.logical);
    QPainter painter(&image);
    paintLevel(Stage{painter, view, theme}, level, Selection());
    return image;
}

} // namespace spacetow
