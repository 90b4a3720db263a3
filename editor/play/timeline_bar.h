#pragma once
// What has been of a run, below the canvas: a scale with a handle for the moment that is shown, marks of what happened,
// and the buttons that go there. Works with mouse and keyboard.

#include "core/game/timeline.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>
#include <QWidget>

#include <memory>
#include <optional>
#include <vector>

class QAction;

namespace spacetow {

/// What the bar shows, in updates of the run.
struct TimelineState {
    std::int64_t first = 0, last = 0; // that can be looked at
    std::int64_t shown = 0;
    std::int64_t goal = 0; // `last`, as soon as what is to come has been simulated
    double updateSeconds = 0.02;
    MarkList marks;
    bool hasGhosts = false; // of futures that were given up

    bool operator==(const TimelineState&) const = default;
};

/// "1/4 ×", as everywhere in the window.
QString speedText(double speed);
/// What a mark is called.
QString markName(MarkKind kind);

/// The scale: a click or a drag goes to the moment, arrows an update, with Shift or Page a second, Home and End to the
/// ends.
class TimelineScale : public QWidget {
    Q_OBJECT

  public:
    explicit TimelineScale(QWidget* parent = nullptr);
    void showState(const TimelineState& state);
    const TimelineState& state() const { return m_state; }
    /// Where an update is on the scale, logical pixels; and the other way round.
    double xOf(std::int64_t update) const;
    std::int64_t updateAt(double x) const;
    /// The mark under the pointer, if there is one.
    std::optional<TimelineMark> markAt(double x) const;

    QSize sizeHint() const override { return {400, 30}; }
    QSize minimumSizeHint() const override { return {44, 30}; }

  signals:
    /// Somebody wants to see the moment after so many updates.
    void sought(qint64 update);

  protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

  private:
    void seek(std::int64_t update);
    QString timeText(std::int64_t update) const;
    void paintMarks(QPainter& painter) const;

    TimelineState m_state;
    std::optional<std::int64_t> m_sought; // not shown yet
};

class TimelineBar : public QWidget {
    Q_OBJECT

  public:
    explicit TimelineBar(QWidget* parent = nullptr);
    /// As buttons before the scale, in this order.
    void setActions(const QList<QAction*>& actions);
    void showState(const TimelineState& state);
    /// How fast time runs, on the button whose menu has all speeds. A narrow bar has no room for it.
    void showSpeed(double speed);
    QToolButton& speedButton() { return m_speed; }
    TimelineScale& scale() { return m_scale; }
    QString time() const { return m_time.text(); }
    QSize minimumSizeHint() const override;

  signals:
    void speedWanted(double speed);

  protected:
    void resizeEvent(QResizeEvent* event) override;

  private:
    void makeSpeeds();

    QHBoxLayout m_row;
    QHBoxLayout m_buttons;
    TimelineScale m_scale;
    QLabel m_time;
    QToolButton m_speed;
    double m_shownSpeed = 0;
};

} // namespace spacetow
