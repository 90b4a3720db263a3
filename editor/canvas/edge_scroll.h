#pragma once
// Moves the view while something is dragged to its edge or beyond, the faster
// the further.

#include <QPointF>
#include <QRectF>
#include <QTimer>

#include <chrono>
#include <functional>

class QWidget;

namespace spacetow {

class EdgeScroll {
  public:
    using Clock = std::function<std::chrono::steady_clock::time_point()>;

    /// `scroll` moves the view by so many pixels to the right and downwards, and
    /// takes along what is dragged.
    EdgeScroll(QWidget& view, std::function<void(const QPointF&)> scroll);

    /// What is dragged is there. It scrolls only once it has been away from the
    /// edges: drags may begin at one.
    void follow(const QRectF& view, const QPointF& pointer);
    void end();
    bool isScrolling() const { return m_timer.isActive(); }
    /// Goes as far as is due by now, however long the last turn is past.
    void turn();

    Clock clock = std::chrono::steady_clock::now; // another in tests

  private:
    QTimer m_timer;
    QPointF m_speed; // px/s
    QPointF m_due;   // px, parts of one that are left
    std::chrono::steady_clock::time_point m_last;
    bool m_hasBeenInside = false;
    std::function<void(const QPointF&)> m_scroll;
};

} // namespace spacetow
