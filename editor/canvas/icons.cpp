#include "editor/canvas/icons.h"

#include <QFile>
#include <QPainter>
#include <QSvgRenderer>

#include <array>

namespace spacetow {

namespace {

constexpr std::array sizes{16, 20, 24, 32, 40, 48, 64};

QByteArray source(const QString& name) {
    QFile file(QStringLiteral(":/icons/%1.svg").arg(name));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

QPixmap drawn(const QByteArray& svg, int size) {
    QSvgRenderer renderer(svg);
    QPixmap pixmap(size, size);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    renderer.render(&painter, QRectF(0, 0, size, size));
    return pixmap;
}

void add(QIcon& icon, const QByteArray& svg, const QColor& color, QIcon::Mode mode) {
    QByteArray tinted = svg;
    tinted.replace("currentColor", color.name(QColor::HexRgb).toLatin1());
    for (const int size : sizes) {
        QPixmap pixmap = drawn(tinted, size);
        icon.addPixmap(pixmap, mode, QIcon::Off);
        icon.addPixmap(pixmap, mode, QIcon::On);
    }
}

} // namespace

QIcon icon(const QString& name, const QPalette& palette) {
    const QByteArray svg = source(name);
    QIcon result;
    if (!svg.isEmpty()) {
        add(result, svg, palette.color(QPalette::Active, QPalette::ButtonText), QIcon::Normal);
        add(result, svg, palette.color(QPalette::Disabled, QPalette::ButtonText), QIcon::Disabled);
    }
    return result;
}

QIcon icon(const QString& name, const QColor& color) {
    const QByteArray svg = source(name);
    QIcon result;
    if (!svg.isEmpty()) {
        add(result, svg, color, QIcon::Normal);
    }
    return result;
}

QIcon applicationIcon() {
    const QByteArray svg = source(QStringLiteral("spacetow"));
    QIcon result;
    for (const int size : {16, 24, 32, 48, 64, 128, 256}) {
        result.addPixmap(drawn(svg, size));
    }
    return result;
}

} // namespace spacetow
