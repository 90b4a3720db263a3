#include "editor/panels/plot_view.h"

#include "editor/canvas/palette.h"

#include <QKeyEvent>
#include <QLocale>
#include <QPainter>

#include <algorithm>
#include <array>
#include <cmath>

namespace spacetow {

namespace {

constexpr double plotZoomStep = 1.25;
constexpr double moveStep = 0.2; // of what is shown
constexpr double leastSeconds = 0.1;

QString tickText(double number) {
    return QLocale().toString(number, 'g', 5);
}

} // namespace

PlotView::PlotView(const PlotHistory& history, QWidget* parent) : QWidget(parent), m_history(history) {
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setAccessibleName(tr("Plot"));
    setToolTip(tr("Wheel: zoom · drag: move · double-click: show everything"));
    measure();
}

void PlotView::setNames(const QStringList& names) {
    m_names = names;
    refresh();
}

void PlotView::setPhase(bool phase) {
    m_phase = phase;
    m_range.reset(); // of something else
    refresh();
}

void PlotView::setEmptyText(const QString& text) {
    m_emptyText = text;
    update();
}

void PlotView::refresh() {
    measure();
    update();
}

void PlotView::showAll() {
    m_range.reset();
    refresh();
}

QColor PlotView::curveColor(std::size_t curve, const QPalette& palette) {
    // M. Okabe and K. Ito, "Color Universal Design" (2008), in other lightness on light ground.
    static constexpr std::array<QRgb, 7> onDark{0xffe69f00, 0xff56b4e9, 0xff00c08d, 0xfff0e442,
                                                0xff6fa8ff, 0xffff7a3c, 0xffe59bc8};
    static constexpr std::array<QRgb, 7> onLight{0xff9a6700, 0xff0072b2, 0xff00714f, 0xff7a6f00,
                                                 0xff3b4cc0, 0xffb84600, 0xffa0417f};
    const auto& colors = shadeOf(palette) == Shade::Dark ? onDark : onLight;
    return QColor::fromRgb(colors[curve % colors.size()]);
}

QRectF PlotView::room() const {
    const int line = fontMetrics().height();
    int left = fontMetrics().horizontalAdvance(QLatin1Char('0')) * 2;
    for (const double tick : m_axes.empty() ? std::vector<double>{} : roundTicks(m_axes[0].range, 4)) {
        left = std::max(left, fontMetrics().horizontalAdvance(tickText(tick)));
    }
    int right = 8;
    for (const double tick : m_axes.size() < 2 || isPhase() ? std::vector<double>{} : roundTicks(m_axes[1].range, 4)) {
        right = std::max(right, fontMetrics().horizontalAdvance(tickText(tick)) + 12);
    }
    return QRectF(rect()).adjusted(left + 12, line + 6, -right, -line - 8);
}

PlotRange PlotView::shownRange() const {
    if (m_range) {
        return *m_range;
    }
    if (isPhase()) {
        return rangeAround({&m_history.column(0)}, 0, m_history.size());
    }
    const std::vector<double>& seconds = m_history.seconds();
    return seconds.empty() ? PlotRange{0, 1}
                           : PlotRange{seconds.front(), std::max(seconds.back(), seconds.front() + 1)};
}

std::pair<std::size_t, std::size_t> PlotView::shownRows() const {
    if (isPhase()) {
        return {0, m_history.size()};
    }
    const std::vector<double>& seconds = m_history.seconds();
    const PlotRange range = shownRange();
    const auto first = std::lower_bound(seconds.begin(), seconds.end(), range.from) - seconds.begin();
    const auto end = std::upper_bound(seconds.begin(), seconds.end(), range.to) - seconds.begin();
    return {static_cast<std::size_t>(std::max<std::ptrdiff_t>(first - 1, 0)),
            std::min(static_cast<std::size_t>(end) + 1, seconds.size())};
}

void PlotView::measure() {
    m_axes.clear();
    m_axisOf.clear();
    const auto [first, end] = shownRows();
    const std::vector<PlotSource>& sources = m_history.sources();
    if (isPhase()) {
        m_axes.push_back(
            {QString::fromUtf8(unitOf(sources[1].quantity)), rangeAround({&m_history.column(1)}, first, end)});
        m_axisOf.assign(sources.size(), 0);
        return;
    }
    std::vector<std::vector<const std::vector<double>*>> columns;
    for (std::size_t i = 0; i < sources.size(); ++i) {
        const QString unit = QString::fromUtf8(unitOf(sources[i].quantity));
        const auto known = std::ranges::find(m_axes, unit, &Axis::unit);
        m_axisOf.push_back(static_cast<std::size_t>(known - m_axes.begin()));
        if (known == m_axes.end()) {
            m_axes.push_back({unit, {}});
            columns.emplace_back();
        }
        columns[m_axisOf.back()].push_back(&m_history.column(i));
    }
    for (std::size_t i = 0; i < m_axes.size(); ++i) {
        m_axes[i].range = rangeAround(columns[i], first, end);
    }
}

const PlotView::Axis& PlotView::axisOf(std::size_t column) const {
    return m_axes[m_axisOf[column]];
}

QPointF PlotView::pointAt(std::size_t column, std::size_t row) const {
    return pointIn(frame(), column, row);
}

QPointF PlotView::pointIn(const Frame& frame, std::size_t column, std::size_t row) const {
    const QRectF& box = frame.room;
    const double along = isPhase() ? m_history.column(0)[row] : m_history.seconds()[row];
    const double up = m_history.column(isPhase() ? 1 : column)[row];
    return {box.left() + frame.along.share(along) * box.width(),
            box.bottom() - axisOf(column).range.share(up) * box.height()};
}

std::optional<std::size_t> PlotView::rowAt(const QPointF& at) const {
    const Frame now = frame();
    const QRectF& box = now.room;
    if (m_history.size() == 0 || m_history.sources().empty() || !box.contains(at)) {
        return {};
    }
    if (!isPhase()) {
        const std::vector<double>& seconds = m_history.seconds();
        const double wanted = now.along.at((at.x() - box.left()) / box.width());
        const auto next = std::lower_bound(seconds.begin(), seconds.end(), wanted);
        const bool before = next == seconds.end() || (next != seconds.begin() && wanted - *(next - 1) < *next - wanted);
        return static_cast<std::size_t>((before ? next - 1 : next) - seconds.begin());
    }
    std::optional<std::size_t> nearest;
    double distance = std::numeric_limits<double>::infinity();
    for (std::size_t row = 0; row < m_history.size(); ++row) {
        const QPointF away = pointIn(now, 0, row) - at;
        const double squared = QPointF::dotProduct(away, away);
        if (squared < distance) { // not where something is unknown
            distance = squared;
            nearest = row;
        }
    }
    return nearest;
}

QStringList PlotView::readout(std::size_t row) const {
    QStringList lines{tr("%1 s").arg(QLocale().toString(m_history.seconds()[row], 'f', 2))};
    for (std::size_t i = 0; i < m_history.sources().size(); ++i) {
        const double value = m_history.column(i)[row];
        const QString text = std::isnan(value) ? QStringLiteral("–") : QLocale().toString(value, 'g', 5);
        lines << QStringLiteral("%1: %2 %3")
                     .arg(m_names.value(static_cast<qsizetype>(i)), text,
                          QString::fromUtf8(unitOf(m_history.sources()[i].quantity)));
    }
    return lines;
}

void PlotView::zoomAt(double share, double factor) {
    const PlotRange next = zoomed(shownRange(), share, factor);
    if (isPhase() || next.size() >= leastSeconds || factor < 1) {
        m_range = next;
        refresh();
    }
}

void PlotView::moveBy(double share) {
    PlotRange range = shownRange();
    const double way = share * range.size();
    m_range = {range.from + way, range.to + way};
    refresh();
}

void PlotView::mousePressEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton) {
        m_dragged = event->position();
    }
}

void PlotView::mouseMoveEvent(QMouseEvent* event) {
    m_pointer = event->position();
    if (m_dragged && (event->buttons() & Qt::LeftButton) != 0 && m_history.size() > 0) {
        moveBy((m_dragged->x() - event->position().x()) / room().width());
        m_dragged = event->position();
    }
    update();
}

void PlotView::mouseDoubleClickEvent(QMouseEvent*) {
    showAll();
}

void PlotView::wheelEvent(QWheelEvent* event) {
    const QRectF box = room();
    const double share = std::clamp((event->position().x() - box.left()) / box.width(), 0.0, 1.0);
    zoomAt(share, std::pow(plotZoomStep, event->angleDelta().y() / 120.0));
    event->accept();
}

void PlotView::keyPressEvent(QKeyEvent* event) {
    switch (event->key()) {
    case Qt::Key_Left:
        moveBy(-moveStep);
        break;
    case Qt::Key_Right:
        moveBy(moveStep);
        break;
    case Qt::Key_Plus:
        zoomAt(0.5, plotZoomStep);
        break;
    case Qt::Key_Minus:
        zoomAt(0.5, 1 / plotZoomStep);
        break;
    case Qt::Key_Home:
        showAll();
        break;
    default:
        QWidget::keyPressEvent(event);
    }
}

void PlotView::leaveEvent(QEvent*) {
    m_pointer.reset();
    update();
}

} // namespace spacetow
