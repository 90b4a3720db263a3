#include "editor/canvas/icons.h"

#include <QFile>
#include <QGuiApplication>
#include <QIconEngine>
#include <QPainter>
#include <QPixmapCache>
#include <QSvgRenderer>

#include <optional>
#include <utility>

namespace spacetow {

namespace {

QByteArray source(const QString& name) {
    QFile file(QStringLiteral(":/icons/%1.svg").arg(name));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

QPixmap drawn(const QByteArray& svg, const QSize& size) {
    QSvgRenderer renderer(svg);
    QPixmap pixmap(size);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    renderer.render(&painter, QRectF(QPointF(0, 0), size));
    return pixmap;
}

struct Inks {
    QColor normal;
    QColor disabled;
    QColor selected; // on the colour of what is selected
};

Inks inksOf(const QPalette& palette) {
    return {palette.color(QPalette::Active, QPalette::ButtonText),
            palette.color(QPalette::Disabled, QPalette::ButtonText),
            palette.color(QPalette::Active, QPalette::HighlightedText)};
}

/// Draws at the size that is asked for, and keeps what it drew: a hundred icons in all sizes would delay the start.
class LineIcon : public QIconEngine {
  public:
    LineIcon(QString name, QByteArray svg, std::optional<Inks> inks)
        : m_name(std::move(name)), m_svg(std::move(svg)), m_inks(std::move(inks)) {}

    void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State state) override {
        const double ratio = painter->device() != nullptr ? painter->device()->devicePixelRatioF() : 1;
        painter->drawPixmap(rect, scaledPixmap(rect.size() * ratio, mode, state, ratio));
    }
    QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
        return scaledPixmap(size, mode, state, 1);
    }
    /// The size is in device pixels.
    QPixmap scaledPixmap(const QSize& size, QIcon::Mode mode, QIcon::State, double scale) override {
        const QString color = ink(mode).name(QColor::HexRgb);
        const QString key =
            QStringLiteral("line-icon %1 %2 %3×%4").arg(m_name, color).arg(size.width()).arg(size.height());
        QPixmap pixmap;
        if (!QPixmapCache::find(key, &pixmap)) {
            QByteArray tinted = m_svg;
            tinted.replace("currentColor", color.toLatin1());
            pixmap = drawn(tinted, size);
            QPixmapCache::insert(key, pixmap);
        }
        pixmap.setDevicePixelRatio(scale);
        return pixmap;
    }
    QSize actualSize(const QSize& size, QIcon::Mode, QIcon::State) override { return size; }
    bool isNull() override { return false; }
    QIconEngine* clone() const override { return new LineIcon(*this); }

  private:
    QColor ink(QIcon::Mode mode) const {
        const Inks inks = m_inks ? *m_inks : inksOf(QGuiApplication::palette());
        return mode == QIcon::Disabled ? inks.disabled : mode == QIcon::Selected ? inks.selected : inks.normal;
    }

    QString m_name;
    QByteArray m_svg;
    std::optional<Inks> m_inks; // none: the application's
};

QIcon lineIcon(const QString& name, const std::optional<Inks>& inks) {
    QByteArray svg = source(name);
    return svg.isEmpty() ? QIcon() : QIcon(new LineIcon(name, std::move(svg), inks)); // the icon owns its engine
}

} // namespace

QIcon icon(const QString& name, const QPalette& palette) {
    return lineIcon(name, inksOf(palette));
}

QIcon livingIcon(const QString& name) {
    return lineIcon(name, {});
}

QIcon icon(const QString& name, const QColor& color) {
    return icon(name, color, color);
}

QIcon icon(const QString& name, const QColor& color, const QColor& onSelection) {
    return lineIcon(name, Inks{color, color, onSelection});
}

QIcon applicationIcon() {
    const QByteArray svg = source(QStringLiteral("spacetow"));
    QIcon result;
    for (const int size : {16, 24, 32, 48, 64, 128, 256}) {
        result.addPixmap(drawn(svg, {size, size}));
    }
    return result;
}

} // namespace spacetow
