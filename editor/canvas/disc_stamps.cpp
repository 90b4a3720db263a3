#include "editor/canvas/disc_stamps.h"

#include <cmath>

namespace spacetow {

namespace {

constexpr int parts = 4;           // of a device pixel, in which places and radii are told apart
constexpr std::size_t most = 4096; // pictures
constexpr double outlineRoom = 3;  // px, for the outline

/// Whole device pixels, and parts of one beyond them.
struct Place {
    int whole = 0, part = 0;

    explicit Place(double pixels) {
        const int all = static_cast<int>(std::floor(pixels * parts + 0.5));
        whole = static_cast<int>(std::floor(static_cast<double>(all) / parts));
        part = all - whole * parts;
    }
};

} // namespace

void DiscStamps::paint(const Stage& stage, const QPointF& center, double radius, const BodyStyle& style) {
    const double ratio = stage.painter.device()->devicePixelRatioF();
    if (m_theme != &stage.theme || m_ratio != ratio || m_stamps.size() > most) {
        m_stamps.clear();
        m_theme = &stage.theme;
        m_ratio = ratio;
    }
    const QPointF moved(stage.painter.worldTransform().dx(), stage.painter.worldTransform().dy());
    const Place x((center.x() + moved.x()) * ratio), y((center.y() + moved.y()) * ratio);
    const auto size = static_cast<int>(std::lround(radius * ratio * parts));
    const int half = static_cast<int>(std::ceil((radius + outlineRoom) * ratio)) + 1; // device pixels
    const int look = 2 * static_cast<int>(style.kind) + (style.tangible ? 1 : 0);
    QPixmap& stamp = m_stamps[static_cast<std::uint32_t>(((size * 8 + look) * parts + x.part) * parts + y.part)];
    if (stamp.isNull()) {
        stamp = QPixmap(2 * half, 2 * half);
        stamp.setDevicePixelRatio(ratio);
        stamp.fill(Qt::transparent);
        QPainter painter(&stamp);
        painter.setRenderHint(QPainter::Antialiasing);
        const QPointF middle(half + static_cast<double>(x.part) / parts, half + static_cast<double>(y.part) / parts);
        paintDisc(Stage{painter, stage.view, stage.theme}, middle / ratio, size / (ratio * parts), style);
    }
    stage.painter.drawPixmap(QPointF(x.whole - half, y.whole - half) / ratio - moved, stamp);
}

} // namespace spacetow
