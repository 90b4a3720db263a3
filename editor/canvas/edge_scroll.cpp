#include "editor/canvas/edge_scroll.h"

#include <QWidget>

#include <algorithm>
#include <cmath>
#include <utility>

namespace spacetow {

namespace {

constexpr std::chrono::milliseconds turnTime(16);
constexpr std::chrono::duration<double> longestTurn(0.1); // a window that hung does not jump
constexpr double edgeWidth = 8;                           // px inside the view, where windows that fill
                                                          // the screen have nothing beyond
constexpr double eagerness = 12;                          // px/s for each px that the pointer is further
constexpr double leastSpeed = 60, mostSpeed = 2000;       // px/s

/// Of one axis, by how far the pointer is beyond the first or the last edge.
double speedAlong(double pointer, double first, double last) {
    const double beyond = pointer < first ? pointer - first : std::max(pointer - last, 0.0);
    return beyond == 0 ? 0 : std::copysign(std::clamp(eagerness * std::abs(beyond), leastSpeed, mostSpeed), beyond);
}

} // namespace

EdgeScroll::EdgeScroll(QWidget& view, std::function<void(const QPointF&)> scroll)
    : m_timer(&view), m_scroll(std::move(scroll)) {
    m_timer.setInterval(turnTime);
    m_timer.setTimerType(Qt::PreciseTimer);
    QObject::connect(&m_timer, &QTimer::timeout, &view, [this] { turn(); });
}

void EdgeScroll::follow(const QRectF& view, const QPointF& pointer) {
    const QRectF inner = view.adjusted(edgeWidth, edgeWidth, -edgeWidth, -edgeWidth);
    m_hasBeenInside = m_hasBeenInside || inner.contains(pointer);
    m_speed = m_hasBeenInside ? QPointF(speedAlong(pointer.x(), inner.left(), inner.right()),
                                        speedAlong(pointer.y(), inner.top(), inner.bottom()))
                              : QPointF();
    if (m_speed.isNull()) {
        m_timer.stop();
    } else if (!m_timer.isActive()) {
        m_due = {};
        m_last = clock();
        m_timer.start();
    }
}

void EdgeScroll::turn() {
    if (!m_timer.isActive()) {
        return;
    }
    const std::chrono::steady_clock::time_point now = clock();
    const std::chrono::duration<double> passed = now - std::exchange(m_last, now);
    m_due += std::min(passed, longestTurn).count() * m_speed;
    const QPointF whole(std::trunc(m_due.x()),
                        std::trunc(m_due.y())); // what is painted shifts by whole pixels only
    if (!whole.isNull()) {
        m_due -= whole;
        m_scroll(whole);
    }
}

void EdgeScroll::end() {
    m_timer.stop();
    m_hasBeenInside = false;
}

} // namespace spacetow
