#include "editor/canvas/ruler.h"

#include "editor/canvas/theme.h"

#include <QLocale>
#include <QPaintEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace spacetow {

namespace {

constexpr double closestTick = 5; // px between ticks
constexpr double pointerHalf = 5; // px, half the width of the pointer's mark
constexpr double quarter = std::numbers::pi / 2;
constexpr int numberGap = 18; // px between numbers

QString number(double value, int decimals) {
    QLocale locale;
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    return locale.toString(value, 'f', decimals); // of zero, too, as many as its neighbours have
}

} // namespace

RulerSteps rulerSteps(double pixelsPerMetre, double leastPixels) {
    const double least = leastPixels / pixelsPerMetre;
    const int power = static_cast<int>(std::floor(std::log10(least)));
    const double ten = std::pow(10, power);
    RulerSteps steps{10 * ten, 10, std::max(0, -power - 1)};
    for (const auto& [digit, parts] : {std::pair{1.0, 10}, std::pair{2.0, 4}, std::pair{5.0, 5}}) {
        if (digit * ten >= least * (1 - 1e-9)) {
            steps = {digit * ten, parts, std::max(0, -power)};
            break;
        }
    }
    if (steps.major / steps.parts * pixelsPerMetre < closestTick) {
        steps.parts = steps.parts == 4 ? 2 : 5;
    }
    return steps;
}

Ruler::Ruler(Qt::Orientation orientation, QWidget* parent)
    : GuideSource(orientation == Qt::Horizontal ? 0 : quarter, parent), m_orientation(orientation) {
    setAttribute(Qt::WA_OpaquePaintEvent);
    setCursor(orientation == Qt::Horizontal ? Qt::SplitVCursor : Qt::SplitHCursor);
    setSizePolicy(orientation == Qt::Horizontal ? QSizePolicy::Expanding : QSizePolicy::Fixed,
                  orientation == Qt::Horizontal ? QSizePolicy::Fixed : QSizePolicy::Expanding);
    setAccessibleName(orientation == Qt::Horizontal ? tr("Ruler above the drawing board")
                                                    : tr("Ruler beside the drawing board"));
    const QString tip = orientation == Qt::Horizontal ? tr("Metres; drag a horizontal guide out of the ruler")
                                                      : tr("Metres; drag a vertical guide out of the ruler");
    setToolTip(tip);
    setStatusTip(tip);
}

QFont Ruler::numberFont(const QWidget& widget) {
    QFont font = widget.font();
    if (font.pointSizeF() > 0) {
        font.setPointSizeF(std::max(6.5, font.pointSizeF() * 0.82));
    } else {
        font.setPixelSize(std::max(9, font.pixelSize() * 82 / 100));
    }
    return font;
}

int Ruler::thickness(const QWidget& widget) {
    return QFontMetrics(numberFont(widget)).height() + 8;
}

QSize Ruler::sizeHint() const {
    const int across = thickness(*this);
    return isFlat() ? QSize(60, across) : QSize(across, 60);
}

double Ruler::toPixel(double metres) const {
    return isFlat() ? m_view.toScreen(Vec2(metres, 0)).x() : m_view.toScreen(Vec2(0, metres)).y();
}

double Ruler::toMetre(double pixel) const {
    return isFlat() ? m_view.toWorld(Vec2(pixel, 0)).x() : m_view.toWorld(Vec2(0, pixel)).y();
}

QRect Ruler::strip(double from, double to) const {
    const auto [low, high] =
        std::minmax({std::clamp(from, -20.0, length() + 20), std::clamp(to, -20.0, length() + 20)});
    const int start = static_cast<int>(std::floor(low)) - 1;
    const int size = static_cast<int>(std::ceil(high)) + 1 - start;
    return isFlat() ? QRect(start, 0, size, height()) : QRect(0, start, width(), size);
}

void Ruler::setView(const Viewport& view) {
    if (view.center != m_view.center || view.scale != m_view.scale || view.size != m_view.size) {
        m_view = view;
        m_pointer.reset(); // it comes again with the next move
        update();
    }
}

void Ruler::setPointer(std::optional<Vec2> world) {
    const std::optional<double> pixel = world ? std::optional(std::round(toPixel(along(*world)))) : std::nullopt;
    if (pixel == m_pointer) {
        return;
    }
    for (const std::optional<double>& at : {m_pointer, pixel}) {
        if (at) {
            update(strip(*at - pointerHalf - 1, *at + pointerHalf + 1));
        }
    }
    m_pointer = pixel;
}

void Ruler::setExtent(const Aabb& selected) {
    std::optional<std::pair<double, double>> extent;
    if (!selected.isEmpty()) {
        extent.emplace(along(selected.min), along(selected.max));
    }
    if (extent == m_extent) {
        return;
    }
    for (const auto& each : {m_extent, extent}) {
        if (each) {
            update(strip(toPixel(each->first), toPixel(each->second)));
        }
    }
    m_extent = extent;
}

void Ruler::paintNumber(QPainter& painter, double at, const QString& text) const {
    const QFontMetrics metrics(painter.font());
    if (isFlat()) {
        painter.drawText(QPointF(at + 4, metrics.ascent() + 1), text);
    } else {
        painter.save();
        painter.translate(metrics.ascent() + 1, at - 4);
        painter.rotate(-90);
        painter.drawText(QPointF(0, 0), text);
        painter.restore();
    }
}

void Ruler::paintTicks(QPainter& painter, const QRect& where) const {
    painter.setFont(numberFont(*this));
    const QFontMetrics metrics(painter.font());
    const double ends[] = {toMetre(0), toMetre(length())};
    const double far = std::max(std::abs(ends[0]), std::abs(ends[1]));
    RulerSteps steps = rulerSteps(m_view.scale, 40);
    const auto widest = [&] { return metrics.horizontalAdvance(number(-far, steps.decimals)); };
    steps = rulerSteps(m_view.scale, widest() + numberGap);
    steps = rulerSteps(m_view.scale, widest() + numberGap); // which may have other decimals

    // A number reaches into what follows its tick.
    const double reach = widest() + numberGap;
    const double first = isFlat() ? where.left() - reach : where.top() - 2;
    const double last = isFlat() ? where.right() + 2 : where.bottom() + reach;
    const auto [low, high] = std::minmax({toMetre(first), toMetre(last)});
    const double minor = steps.major / steps.parts;
    const double across = isFlat() ? height() : width();
    const QColor ink = palette().color(QPalette::PlaceholderText);
    const QColor line = palette().color(QPalette::Dark);
    for (double i = std::ceil(low / minor); i <= std::floor(high / minor); ++i) {
        const bool isMajor = std::fmod(i, steps.parts) == 0;
        const bool isMiddle = steps.parts % 2 == 0 && std::fmod(i, steps.parts / 2.0) == 0;
        const double at = std::floor(toPixel(i * minor)) + 0.5;
        const double size = isMajor ? across : isMiddle ? 7 : 4;
        painter.setPen(line);
        painter.drawLine(isFlat() ? QLineF(at, across - size, at, across) : QLineF(across - size, at, across, at));
        if (isMajor) {
            painter.setPen(ink);
            paintNumber(painter, at, number(i * minor, steps.decimals));
        }
    }
}

void Ruler::paintEvent(QPaintEvent* event) {
    QPainter painter(this);
    const QRect where = event->rect();
    painter.fillRect(where, palette().color(QPalette::Window));
    const QColor selection = editingTheme(shadeOf(palette())).selection;
    QRect extent = m_extent ? strip(toPixel(m_extent->first), toPixel(m_extent->second)) : QRect();
    painter.fillRect(extent, QColor(selection.red(), selection.green(), selection.blue(), 70));
    paintTicks(painter, where);
    painter.setPen(palette().color(QPalette::Mid));
    painter.drawLine(isFlat() ? rect().bottomLeft() : rect().topRight(), rect().bottomRight());
    if (m_extent) { // not cut up by the ticks
        (isFlat() ? extent.setTop(extent.bottom() - 1) : extent.setLeft(extent.right() - 1));
        painter.fillRect(extent, selection);
    }
    if (m_pointer) {
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(Qt::NoPen);
        painter.setBrush(palette().color(QPalette::WindowText));
        const double at = *m_pointer;
        const double edge = isFlat() ? height() : width();
        const auto point = [&](double a, double b) { return isFlat() ? QPointF(a, b) : QPointF(b, a); };
        painter.drawPolygon(QPolygonF{point(at - pointerHalf + 0.5, edge - 6), point(at + pointerHalf + 0.5, edge - 6),
                                      point(at + 0.5, edge - 1)});
    }
}

} // namespace spacetow
