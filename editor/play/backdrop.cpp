#include "editor/play/backdrop.h"

#include "core/base/random.h"

#include <QImage>
#include <QPixmapCache>
#include <QRadialGradient>

#include <array>
#include <cmath>

namespace spacetow {
namespace {

constexpr int tile = 768; // logical pixels, also the period of the sky

struct Sheet {
    double speed; // share of the camera's speed
    int stars;
    double radius;  // pixels, of the smallest
    int brightness; // 0 … 255, of the brightest
};
constexpr std::array<Sheet, 3> sheets{{{0.04, 150, 0.5, 120}, {0.1, 60, 0.7, 170}, {0.2, 22, 0.9, 230}}};

QColor starColor(Random& random, int brightness) {
    const std::array<QColor, 4> tints{QColor(255, 255, 255), QColor(190, 214, 255), QColor(255, 226, 190),
                                      QColor(206, 240, 255)};
    QColor color = tints[random.below(tints.size())];
    color.setAlpha(static_cast<int>(random.uniform(0.35, 1) * brightness));
    return color;
}

/// Drawn at all nine places from which it reaches into the tile, so that the tiles join without a seam.
template <class Paint>
void wrapped(Paint paint) {
    for (int dx = -tile; dx <= tile; dx += tile) {
        for (int dy = -tile; dy <= tile; dy += tile) {
            paint(dx, dy);
        }
    }
}

void paintGlow(QPainter& painter, Random& random) {
    const std::array<QColor, 4> tints{QColor(54, 84, 160), QColor(96, 54, 140), QColor(24, 104, 128),
                                      QColor(54, 84, 160)};
    for (const QColor& tint : tints) {
        const double x = random.uniform(0, tile);
        const double y = random.uniform(0, tile);
        const double radius = random.uniform(170, 330);
        wrapped([&](int dx, int dy) {
            QRadialGradient gradient(x + dx, y + dy, radius);
            QColor color = tint;
            color.setAlpha(38);
            gradient.setColorAt(0, color);
            color.setAlpha(0);
            gradient.setColorAt(1, color);
            painter.fillRect(QRectF(x + dx - radius, y + dy - radius, 2 * radius, 2 * radius), gradient);
        });
    }
}

QPixmap sheetPixmap(std::size_t index, const QColor& background, double ratio) {
    const QString key = QStringLiteral("spacetow/stars/%1/%2/%3").arg(index).arg(background.rgba()).arg(ratio);
    QPixmap pixmap;
    if (QPixmapCache::find(key, &pixmap)) {
        return pixmap;
    }
    const int pixels = static_cast<int>(std::ceil(tile * ratio));
    QImage image(pixels, pixels, QImage::Format_ARGB32_Premultiplied);
    image.setDevicePixelRatio(pixels / static_cast<double>(tile));
    image.fill(index == 0 ? background : QColor(Qt::transparent));
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    Random random(17 + index);
    if (index == 0) {
        paintGlow(painter, random);
    }
    const Sheet& sheet = sheets[index];
    for (int i = 0; i < sheet.stars; ++i) {
        const double x = random.uniform(0, tile);
        const double y = random.uniform(0, tile);
        const double radius = sheet.radius * random.uniform(1, 1.9);
        const QColor color = starColor(random, sheet.brightness);
        painter.setBrush(color);
        wrapped([&](int dx, int dy) { painter.drawEllipse(QPointF(x + dx, y + dy), radius, radius); });
    }
    painter.end();
    pixmap = QPixmap::fromImage(image);
    QPixmapCache::insert(key, pixmap);
    return pixmap;
}

} // namespace

void paintBackdrop(const Stage& stage, const QString& name) {
    const QRectF area(0, 0, stage.view.size.x(), stage.view.size.y());
    if (name != QLatin1String("stars")) {
        stage.painter.fillRect(area, stage.theme.background);
        return;
    }
    const double ratio = stage.painter.device()->devicePixelRatioF();
    for (std::size_t i = 0; i < sheets.size(); ++i) {
        // Metres at the default zoom: the stars are far away, so zooming does not move them.
        constexpr double pixelsPerMetre = 66;
        const Vec2 shift = sheets[i].speed * pixelsPerMetre * stage.view.center;
        const QPointF offset(std::fmod(shift.x(), tile) + tile, std::fmod(-shift.y(), tile) + tile);
        stage.painter.drawTiledPixmap(area, sheetPixmap(i, stage.theme.background, ratio), offset);
    }
}

} // namespace spacetow
