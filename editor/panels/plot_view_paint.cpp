// PlotView: painting.

#include "editor/canvas/palette.h"
#include "editor/panels/plot_view.h"

#include <QLocale>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace spacetow {

namespace {

constexpr int tickGap = 6; // px

QString axisText(double number) {
    return QLocale().toString(number, 'g', 5);
}

/// Points that follow each other in one column of pixels become the highest and the lowest of them.
class CurvePainter {
  public:
    explicit CurvePainter(QPainter& painter) : m_painter(painter) {}

    void add(const QPointF& point) {
        const int column = static_cast<int>(std::floor(point.x()));
        if (m_here.isEmpty() || column != m_column) {
            leaveColumn();
            m_column = column;
        }
        m_here << point;
    }
    void end() {
        leaveColumn();
        if (m_points.size() == 1) {
            m_painter.drawPoint(m_points.front());
        }
        m_painter.drawPolyline(m_points);
        m_points.clear();
    }

  private:
    void leaveColumn() {
        if (m_here.size() <= 3) {
            m_points << m_here;
        } else {
            const auto byHeight = [](const QPointF& a, const QPointF& b) { return a.y() < b.y(); };
            const auto [low, high] = std::minmax_element(m_here.begin(), m_here.end(), byHeight);
            m_points << m_here.front() << *low << *high << m_here.back();
        }
        m_here.clear();
    }

    QPainter& m_painter;
    QPolygonF m_points, m_here;
    int m_column = 0;
};

} // namespace

void PlotView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), palette().color(QPalette::Base));
    if (m_history.sources().empty()) {
        painter.setPen(palette().color(QPalette::Disabled, QPalette::Text));
        painter.drawText(rect().adjusted(12, 12, -12, -12), Qt::AlignCenter | Qt::TextWordWrap, m_emptyText);
        return;
    }
    paintGrid(painter);
    paintLabels(painter, m_axes[0], false);
    if (!isPhase() && m_axes.size() > 1) {
        paintLabels(painter, m_axes[1], true);
    }
    painter.save();
    painter.setClipRect(room().adjusted(-1, -1, 1, 1));
    painter.setRenderHint(QPainter::Antialiasing);
    if (isPhase()) {
        paintPhase(painter);
    } else {
        for (std::size_t i = 0; i < m_history.sources().size(); ++i) {
            paintCurve(painter, i);
        }
    }
    painter.restore();
    paintPointer(painter);
}

void PlotView::paintGrid(QPainter& painter) const {
    const QRectF box = room();
    const int line = painter.fontMetrics().height();
    const QColor faint = mixed(palette().color(QPalette::Base), palette().color(QPalette::Text), 0.15);
    const QColor ink = mixed(palette().color(QPalette::Base), palette().color(QPalette::Text), 0.75);
    const PlotRange range = shownRange();
    painter.setPen(faint);
    painter.drawRect(box);
    for (const double tick : roundTicks(range, std::max(2, static_cast<int>(box.width()) / 80))) {
        const double x = box.left() + range.share(tick) * box.width();
        painter.setPen(faint);
        painter.drawLine(QPointF(x, box.top()), QPointF(x, box.bottom()));
        painter.setPen(ink);
        painter.drawText(QRectF(x - 40, box.bottom() + 3, 80, line), Qt::AlignHCenter, axisText(tick));
    }
    painter.setPen(faint);
    for (const double tick : roundTicks(m_axes[0].range, 4)) {
        const double y = box.bottom() - m_axes[0].range.share(tick) * box.height();
        painter.drawLine(QPointF(box.left(), y), QPointF(box.right(), y));
    }
    const QString along = isPhase() ? m_names.value(0) + QStringLiteral(" (") +
                                          QString::fromUtf8(unitOf(m_history.sources()[0].quantity)) + QLatin1Char(')')
                                    : QStringLiteral("s");
    painter.setPen(ink);
    painter.drawText(QRectF(box.left(), 2, box.width(), line), Qt::AlignRight,
                     painter.fontMetrics().elidedText(QStringLiteral("→ ") + along, Qt::ElideRight,
                                                      static_cast<int>(box.width() * 0.7)));
}

void PlotView::paintLabels(QPainter& painter, const Axis& axis, bool right) const {
    const QRectF box = room();
    const int line = painter.fontMetrics().height();
    painter.setPen(mixed(palette().color(QPalette::Base), palette().color(QPalette::Text), 0.75));
    for (const double tick : roundTicks(axis.range, 4)) {
        const double y = box.bottom() - axis.range.share(tick) * box.height();
        const QRectF place = right
                                 ? QRectF(box.right() + tickGap, y - line / 2.0, width() - box.right() - tickGap, line)
                                 : QRectF(0, y - line / 2.0, box.left() - tickGap, line);
        painter.drawText(place, (right ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter, axisText(tick));
    }
    const QString unit = QStringLiteral("↑ ") + axis.unit;
    const QRectF head =
        right ? QRectF(box.right() - 60, 2, 60 + width() - box.right() - 2, line) : QRectF(4, 2, box.left() + 80, line);
    if (!right || !isPhase()) {
        painter.drawText(right ? head.translated(0, line) : head, right ? Qt::AlignRight : Qt::AlignLeft, unit);
    }
}

void PlotView::paintCurve(QPainter& painter, std::size_t column) const {
    painter.setPen(QPen(curveColor(column, palette()), 1.6, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    const QRectF box = room();
    const PlotRange along = shownRange();
    const PlotRange up = axisOf(column).range;
    const std::vector<double>& values = m_history.column(column);
    const auto [first, end] = shownRows();
    CurvePainter curve(painter);
    for (std::size_t row = first; row < end; ++row) {
        if (std::isnan(values[row])) {
            curve.end();
        } else {
            curve.add({box.left() + along.share(m_history.seconds()[row]) * box.width(),
                       box.bottom() - up.share(values[row]) * box.height()});
        }
    }
    curve.end();
    const double shown = box.left() + along.share(m_history.shownSeconds()) * box.width();
    painter.setPen(QPen(palette().color(QPalette::Highlight), 1, Qt::DashLine));
    painter.drawLine(QPointF(shown, box.top()), QPointF(shown, box.bottom()));
}

void PlotView::paintPhase(QPainter& painter) const {
    painter.setPen(QPen(curveColor(0, palette()), 1.4, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    QPolygonF points;
    const auto end = [&] {
        painter.drawPolyline(points);
        points.clear();
    };
    const auto isKnown = [](const QPointF& point) { return std::isfinite(point.x()) && std::isfinite(point.y()); };
    const Frame now = frame();
    for (std::size_t row = 0; row < m_history.size(); ++row) {
        const QPointF point = pointIn(now, 0, row);
        if (isKnown(point)) {
            points << point;
        } else {
            end();
        }
    }
    end();
    const auto shown = std::ranges::lower_bound(m_history.seconds(), m_history.shownSeconds());
    if (shown != m_history.seconds().end()) {
        const QPointF point = pointIn(now, 0, static_cast<std::size_t>(shown - m_history.seconds().begin()));
        if (isKnown(point)) {
            painter.setBrush(curveColor(1, palette()));
            painter.drawEllipse(point, 4, 4);
        }
    }
}

void PlotView::paintPointer(QPainter& painter) const {
    const std::optional<std::size_t> row = m_pointer ? rowAt(*m_pointer) : std::nullopt;
    if (!row) {
        return;
    }
    const QRectF box = room();
    painter.setRenderHint(QPainter::Antialiasing);
    const QPointF at = pointAt(0, *row);
    if (!isPhase()) {
        painter.setPen(mixed(palette().color(QPalette::Base), palette().color(QPalette::Text), 0.5));
        painter.drawLine(QPointF(at.x(), box.top()), QPointF(at.x(), box.bottom()));
    }
    for (std::size_t i = 0; i < (isPhase() ? 1 : m_history.sources().size()); ++i) {
        const QPointF point = pointAt(i, *row);
        if (std::isfinite(point.y()) && box.adjusted(-1, -1, 1, 1).contains(point)) {
            painter.setPen(Qt::NoPen);
            painter.setBrush(curveColor(i, palette()));
            painter.drawEllipse(point, 3.5, 3.5);
        }
    }
    paintReadout(painter, *row, {at.x(), m_pointer->y()});
}

void PlotView::paintReadout(QPainter& painter, std::size_t row, const QPointF& beside) const {
    const QStringList lines = readout(row);
    const QFontMetrics metrics = painter.fontMetrics();
    int widest = 0;
    for (const QString& one : lines) {
        widest = std::max(widest, metrics.horizontalAdvance(one));
    }
    QRectF box(0, 0, std::min(widest + 24, width()), metrics.height() * lines.size() + 8);
    box.moveTopLeft(beside + QPointF(10, 10));
    if (box.right() > width()) {
        box.moveRight(beside.x() - 10);
    }
    box.moveLeft(std::clamp(box.left(), 0.0, std::max(0.0, width() - box.width())));
    box.moveTop(std::clamp(box.top(), 0.0, std::max(0.0, height() - box.height())));
    painter.setPen(palette().color(QPalette::Mid));
    painter.setBrush(palette().color(QPalette::ToolTipBase));
    painter.drawRoundedRect(box, 3, 3);
    for (qsizetype i = 0; i < lines.size(); ++i) {
        const QRectF line(box.left() + 16, box.top() + 4 + static_cast<double>(i) * metrics.height(), box.width() - 20,
                          metrics.height());
        if (i > 0) {
            painter.setPen(Qt::NoPen);
            painter.setBrush(curveColor(static_cast<std::size_t>(i - 1), palette()));
            painter.drawEllipse(QPointF(box.left() + 9, line.center().y()), 3.5, 3.5);
        }
        painter.setPen(palette().color(QPalette::ToolTipText));
        painter.drawText(line, Qt::AlignVCenter, lines[i]);
    }
}

} // namespace spacetow
