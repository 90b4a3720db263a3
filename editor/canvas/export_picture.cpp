#include "editor/canvas/export_picture.h"

#include "editor/canvas/grid_painter.h"
#include "editor/canvas/overlay_painter.h"
#include "editor/canvas/scene_painter.h"

#include <QBuffer>
#include <QImage>
#include <QSvgGenerator>

#include <cmath>

namespace spacetow {

namespace {

QSize sizeOf(const PictureSpec& spec) {
    return {static_cast<int>(spec.view.size.x()), static_cast<int>(spec.view.size.y())};
}

} // namespace

std::optional<PictureFormat> pictureFormat(const QString& path) {
    if (path.endsWith(QLatin1String(".png"), Qt::CaseInsensitive)) {
        return PictureFormat::Png;
    }
    return path.endsWith(QLatin1String(".svg"), Qt::CaseInsensitive) ? std::optional(PictureFormat::Svg) : std::nullopt;
}

std::optional<QSize> pictureSize(const Aabb& box, double pixelsPerMetre) {
    if (box.isEmpty()) {
        return {};
    }
    const Vec2 size = (box.size() * pixelsPerMetre).array().ceil();
    const bool isUsable = size.x() >= 1 && size.y() >= 1 && size.x() <= largestPicture && size.y() <= largestPicture &&
                          size.x() * size.y() <= mostPixels;
    return isUsable ? std::optional(QSize(static_cast<int>(size.x()), static_cast<int>(size.y()))) : std::nullopt;
}

void paintPicture(QPainter& painter, const Level& level, const PictureSpec& spec) {
    const Theme& theme = spec.theme != nullptr ? *spec.theme : canvasTheme();
    painter.setRenderHint(QPainter::Antialiasing);
    if (!spec.transparent) {
        painter.fillRect(QRect(QPoint(0, 0), sizeOf(spec)), theme.background);
    }
    const Stage stage{painter, spec.view, theme};
    if (spec.gridStep > 0) {
        paintGrid(stage, spec.gridStep);
    }
    paintLevel(stage, level, Selection());
    if (spec.overlays.any()) {
        paintLevelOverlays(stage, *overlayWorlds(level, spec.overlays),
                           {.flags = spec.overlays, .palette = spec.palette, .level = &level});
    }
}

QByteArray pictureBytes(PictureFormat format, const PictureSpec& spec, const std::function<void(QPainter&)>& paint) {
    QByteArray bytes;
    QBuffer out(&bytes);
    out.open(QIODevice::WriteOnly);
    if (format == PictureFormat::Svg) {
        QSvgGenerator generator;
        generator.setOutputDevice(&out);
        constexpr int pixelsPerInch = 96; // those of SVG itself, so that a pixel here is one there
        generator.setResolution(pixelsPerInch);
        generator.setSize(sizeOf(spec));
        generator.setViewBox(QRect(QPoint(0, 0), sizeOf(spec)));
        generator.setTitle(spec.title);
        QPainter painter(&generator);
        paint(painter);
        painter.end();
        return bytes;
    }
    QImage image(sizeOf(spec), QImage::Format_ARGB32_Premultiplied);
    if (image.isNull()) {
        return {};
    }
    image.fill(Qt::transparent);
    QPainter painter(&image);
    paint(painter);
    painter.end();
    return image.save(&out, "PNG") ? bytes : QByteArray();
}

QByteArray pictureBytes(PictureFormat format, const Level& level, const PictureSpec& spec) {
    return pictureBytes(format, spec, [&](QPainter& painter) { paintPicture(painter, level, spec); });
}

} // namespace spacetow
