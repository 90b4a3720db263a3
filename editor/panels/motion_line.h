#pragma once
// Where a body of a running level is now and how it moves, above the fields that say where it starts.

#include "core/math/transform.h"

#include <QLabel>

#include <optional>

namespace spacetow {

struct Motion {
    Transform pose;
    Vec2 velocity{0, 0};        // m/s
    double angularVelocity = 0; // rad/s
};

class MotionLine : public QLabel {
    Q_OBJECT

  public:
    explicit MotionLine(QWidget* parent = nullptr);
    void showMotion(const Motion& motion);
    /// Of a connector, in m and N; a pull is positive.
    void showTension(double distance, double length, double tension);
    /// The object has no body in the run any more.
    void showGone();
};

} // namespace spacetow
