#pragma once
// Curves over time, or one quantity against another. Each unit has a scale of its own, the first at the left, the
// second at the right. The wheel zooms about the pointer, a drag moves, a double click shows everything; under the
// pointer stands what the curves are there.

#include "core/game/plot_history.h"
#include "editor/panels/plot_scale.h"

#include <QColor>
#include <QStringList>
#include <QWidget>

#include <optional>
#include <vector>

namespace spacetow {

class PlotView : public QWidget {
    Q_OBJECT

  public:
    /// The history must outlive the view.
    explicit PlotView(const PlotHistory& history, QWidget* parent = nullptr);

    /// What the columns of the history are called.
    void setNames(const QStringList& names);
    /// The first column along, the second up; else all over time.
    void setPhase(bool phase);
    bool isPhase() const { return m_phase && m_history.sources().size() >= 2; }
    void setEmptyText(const QString& text);
    /// The history has changed.
    void refresh();

    /// Along the axis that goes to the right: s, or the unit of the first column.
    PlotRange shownRange() const;
    void showAll();
    /// The row of the history that is nearest to this point; nothing without one.
    std::optional<std::size_t> rowAt(const QPointF& at) const;
    /// Where the value of the row stands, in pixels.
    QPointF pointAt(std::size_t column, std::size_t row) const;
    /// What stands beside the pointer.
    QStringList readout(std::size_t row) const;

    /// Of the curve with this number, on the ground of the palette.
    static QColor curveColor(std::size_t curve, const QPalette& palette);

    QSize sizeHint() const override { return {320, 110}; }
    QSize minimumSizeHint() const override { return {160, 90}; }

  protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void leaveEvent(QEvent* event) override;

  private:
    /// Of all columns of one unit.
    struct Axis {
        QString unit;
        PlotRange range;
    };
    /// Where curves are, and what they are over.
    struct Frame {
        QRectF room;
        PlotRange along;
    };
    QRectF room() const; // of the curves
    Frame frame() const { return {room(), shownRange()}; }
    QPointF pointIn(const Frame& frame, std::size_t column, std::size_t row) const;
    /// Rows whose seconds are in the shown range, and one more on both sides.
    std::pair<std::size_t, std::size_t> shownRows() const;
    void measure();
    const Axis& axisOf(std::size_t column) const;
    void zoomAt(double share, double factor);
    void moveBy(double share);
    void paintGrid(QPainter& painter) const;
    void paintLabels(QPainter& painter, const Axis& axis, bool right) const;
    void paintCurve(QPainter& painter, std::size_t column) const;
    void paintPhase(QPainter& painter) const;
    void paintPointer(QPainter& painter) const;
    void paintReadout(QPainter& painter, std::size_t row, const QPointF& beside) const;

    const PlotHistory& m_history;
    QStringList m_names;
    QString m_emptyText;
    bool m_phase = false;
    std::optional<PlotRange> m_range;  // chosen; else all that there is
    std::vector<Axis> m_axes;          // upwards; in phase plots the first is that along
    std::vector<std::size_t> m_axisOf; // by column
    std::optional<QPointF> m_pointer;
    std::optional<QPointF> m_dragged; // from where
};

} // namespace spacetow
