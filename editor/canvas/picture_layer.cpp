#include "editor/canvas/picture_layer.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace spacetow {

namespace {

void clear(QImage& image, const QRegion& region) {
    for (const QRect& rect : region) {
        for (int row = rect.top(); row <= rect.bottom(); ++row) {
            std::memset(image.scanLine(row) + 4 * rect.x(), 0, static_cast<std::size_t>(rect.width()) * 4);
        }
    }
}

constexpr int tile = 64; // pixels, the side of a square

bool showsSomething(const QImage& image, const QRect& rect) {
    for (int row = rect.top(); row <= rect.bottom(); ++row) {
        const auto* pixels = reinterpret_cast<const QRgb*>(image.constScanLine(row)) + rect.left();
        if (std::any_of(pixels, pixels + rect.width(), [](QRgb pixel) { return pixel != 0; })) {
            return true;
        }
    }
    return false;
}

/// Moves the picture within its own memory; what comes in from the border is left as it was.
void scroll(QImage& image, const QPoint& by) {
    const int width = image.width() - std::abs(by.x());
    const int height = image.height() - std::abs(by.y());
    if (width <= 0) {
        return;
    }
    const auto bytes = static_cast<std::size_t>(width) * 4;
    const int fromX = std::max(0, -by.x());
    const int toX = std::max(0, by.x());
    for (int i = 0; i < height; ++i) {
        // From the end that is not needed any more, as the rows overlap.
        const int row = by.y() > 0 ? height - 1 - i : i;
        const int from = row + std::max(0, -by.y());
        const int to = row + std::max(0, by.y());
        std::memmove(image.scanLine(to) + 4 * toX, image.constScanLine(from) + 4 * fromX, bytes);
    }
}

} // namespace

Viewport alignedToPixels(const Viewport& view, double pixelRatio) {
    Viewport aligned = view;
    const Vec2 origin = view.toScreen(Vec2(0, 0)) * pixelRatio;
    const Vec2 off = (Vec2(std::round(origin.x()), std::round(origin.y())) - origin) / (pixelRatio * view.scale);
    aligned.center += Vec2(-off.x(), off.y());
    return aligned;
}

QSize Frame2D::deviceSize() const {
    return {static_cast<int>(std::ceil(view.size.x() * pixelRatio - 1e-6)),
            static_cast<int>(std::ceil(view.size.y() * pixelRatio - 1e-6))};
}

QRect Frame2D::deviceRect(const Aabb& world, double spareMetres) const {
    constexpr double pens = 20; // logical pixels
    const Aabb all{Vec2(0, 0), view.size};
    const Aabb box = view.transform().toView(world.grown(spareMetres)).grown(pens);
    if (world.isEmpty() || !box.overlaps(all)) {
        return {};
    }
    const Vec2 min = box.min.cwiseMax(all.min) * pixelRatio;
    const Vec2 max = box.max.cwiseMin(all.max) * pixelRatio;
    const QPoint first(static_cast<int>(std::floor(min.x())), static_cast<int>(std::floor(min.y())));
    const QPoint last(static_cast<int>(std::ceil(max.x())), static_cast<int>(std::ceil(max.y())));
    return QRect(first, last) & QRect(QPoint(0, 0), deviceSize());
}

QPoint Frame2D::movedFrom(const Frame2D& other) const {
    const Vec2 moved = (view.toScreen(Vec2(0, 0)) - other.view.toScreen(Vec2(0, 0))) * pixelRatio;
    constexpr double most = 1e6; // further away nothing is shared
    return {static_cast<int>(std::lround(std::clamp(moved.x(), -most, most))),
            static_cast<int>(std::lround(std::clamp(moved.y(), -most, most)))};
}

QRect Frame2D::rectOf(const Frame2D& other) const {
    return other.all().translated(movedFrom(other));
}

Aabb Frame2D::worldIn(const QRect& device) const {
    const Vec2 min(device.x(), device.y());
    const Vec2 size(device.width(), device.height());
    Aabb box;
    box.include(view.toWorld(min / pixelRatio));
    box.include(view.toWorld((min + size) / pixelRatio));
    return box;
}

Frame2D Frame2D::part(const QRect& device) const {
    Frame2D frame = *this;
    const Vec2 size = Vec2(device.width(), device.height()) / pixelRatio;
    frame.view.center = view.toWorld(Vec2(device.x(), device.y()) / pixelRatio + 0.5 * size);
    frame.view.size = size;
    return frame;
}

Frame2D Frame2D::grown(int pixels) const {
    Frame2D frame = *this;
    frame.view.size += Vec2(2, 2) * (pixels / pixelRatio);
    return frame;
}

bool PictureLayer::canShiftTo(const Frame2D& frame) const {
    return m_valid && frame.view.scale == m_frame.view.scale && frame.pixelRatio == m_frame.pixelRatio;
}

QRegion PictureLayer::missingIn(const Frame2D& frame) const {
    const QRegion all = frame.all();
    return canShiftTo(frame) ? all - frame.rectOf(m_frame) : all;
}

void PictureLayer::shiftTo(const Frame2D& frame) {
    if (!canShiftTo(frame)) {
        erase();
    }
    const QPoint by = m_valid ? frame.movedFrom(m_frame) : QPoint();
    if (!m_image.isNull() && (m_image.size() != frame.deviceSize() || !by.isNull())) {
        m_used = m_used.translated(by) & frame.all();
        if (m_image.size() != frame.deviceSize()) {
            m_image = m_image.copy(QRect(-by, frame.deviceSize()));
        } else {
            scroll(m_image, by);
            clear(m_image, QRegion(frame.all()) - m_image.rect().translated(by));
        }
        m_tiles.clear();
        lookAt(m_used);
    }
    m_frame = frame;
    m_valid = true;
}

void PictureLayer::wipe() {
    if (!m_image.isNull()) {
        clear(m_image, m_used);
    }
    m_used = {};
    m_tiles.clear();
}

void PictureLayer::cut(const QRect& device) {
    if (const QRect seen = device & m_image.rect(); !seen.isEmpty()) {
        clear(m_image, seen);
    }
}

int PictureLayer::columns() const {
    return (m_image.width() + tile - 1) / tile;
}

/// Which of its tiles show anything.
void PictureLayer::lookAt(const QRect& device) {
    m_tiles.resize(static_cast<std::size_t>(columns() * ((m_image.height() + tile - 1) / tile)));
    if (device.isEmpty()) {
        return;
    }
    for (int row = device.top() / tile; row <= device.bottom() / tile; ++row) {
        for (int column = device.left() / tile; column <= device.right() / tile; ++column) {
            const QRect rect = QRect(column * tile, row * tile, tile, tile) & m_image.rect();
            m_tiles[static_cast<std::size_t>(row * columns() + column)] = showsSomething(m_image, rect);
        }
    }
}

std::vector<QRect> PictureLayer::spots() const {
    std::vector<QRect> found;
    const int across = columns();
    for (std::size_t i = 0; i < m_tiles.size();) {
        const int column = static_cast<int>(i) % across;
        const int row = static_cast<int>(i) / across;
        int end = column; // of what shows something in a row
        while (end < across && m_tiles[i]) {
            ++end;
            ++i;
        }
        if (end == column) {
            ++i;
            continue;
        }
        const QRect run = QRect(column * tile, row * tile, (end - column) * tile, tile) & m_image.rect();
        const auto above = std::ranges::find_if(found, [&run](const QRect& spot) {
            return spot.bottom() + 1 == run.top() && spot.left() == run.left() && spot.right() == run.right();
        });
        if (above != found.end()) {
            above->setBottom(run.bottom());
        } else {
            found.push_back(run);
        }
    }
    return found;
}

void PictureLayer::paint(const QRegion& region, const Theme& theme, const Paint& paint) {
    if (region.isEmpty()) {
        return;
    }
    const double ratio = m_frame.pixelRatio;
    if (m_image.isNull()) {
        m_image = QImage(m_frame.deviceSize(), QImage::Format_ARGB32_Premultiplied);
        m_image.fill(Qt::transparent);
    }
    m_image.setDevicePixelRatio(ratio);
    m_used |= region.boundingRect();
    clear(m_image, region);
    for (const QRect& device : region) {
        const QRectF strip(device.x() / ratio, device.y() / ratio, device.width() / ratio, device.height() / ratio);
        const Viewport view = m_frame.part(device).view;
        QPainter painter(&m_image);
        painter.setClipRect(strip);
        painter.translate(strip.topLeft());
        paint(Stage{painter, view, theme});
        painter.end();
        lookAt(device);
    }
}

void PictureLayer::draw(QPainter& painter, const Frame2D& frame, const Vec2& moved) const {
    if (!m_valid || m_used.isEmpty()) {
        return;
    }
    const double zoom = frame.view.scale / m_frame.view.scale;
    const double toFrame = zoom / m_frame.pixelRatio; // logical pixels of the frame for a device pixel of the image
    const Vec2 half = m_frame.view.size / (2 * m_frame.view.scale);
    const Vec2 corner = frame.view.toScreen(m_frame.view.center + moved + Vec2(-half.x(), half.y()));
    if (zoom == 1 && frame.pixelRatio == m_frame.pixelRatio) {
        const auto whole = [&frame](double at) { return std::round(at * frame.pixelRatio) / frame.pixelRatio; };
        const QPointF at(whole(corner.x()), whole(corner.y()));
        // Where a pixel is not a whole number of the image's, neighbours might not fit together.
        const bool fits = frame.pixelRatio == std::floor(frame.pixelRatio);
        for (const QRect& spot : fits ? spots() : std::vector<QRect>{m_used}) {
            painter.drawImage(at + QPointF(spot.topLeft()) * toFrame, m_image, spot);
        }
        return;
    }
    // Only what is in view, as a picture much enlarged is larger than coordinates of painters may be.
    const QRectF used(corner.x() + m_used.x() * toFrame, corner.y() + m_used.y() * toFrame, m_used.width() * toFrame,
                      m_used.height() * toFrame);
    const QRectF target = used & QRectF(0, 0, frame.view.size.x(), frame.view.size.y());
    const QRectF source(m_used.x() + (target.x() - used.x()) / toFrame, m_used.y() + (target.y() - used.y()) / toFrame,
                        target.width() / toFrame, target.height() / toFrame);
    painter.save();
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.drawImage(target, m_image, source);
    painter.restore();
}

} // namespace spacetow
