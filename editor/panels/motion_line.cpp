#include "editor/panels/motion_line.h"

#include <QLocale>

#include <cmath>
#include <numbers>

namespace spacetow {
namespace {

QString number(double value, int decimals) {
    QLocale locale;
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    const double smallest = 0.5 * std::pow(10, -decimals);
    return locale.toString(std::abs(value) < smallest ? 0 : value, 'f', decimals);
}

} // namespace

MotionLine::MotionLine(QWidget* parent) : QLabel(parent) {
    setObjectName(QStringLiteral("motion"));
    setTextFormat(Qt::PlainText);
    setTextInteractionFlags(Qt::TextSelectableByMouse);
    setContentsMargins(10, 0, 10, 6);
    setMinimumWidth(1); // what it says is never wider than the fields below
    setAccessibleName(tr("Now, while it runs"));
    setToolTip(tr("How the body moves now, while it runs; the fields say where it starts"));
}

void MotionLine::showMotion(const Motion& motion) {
    constexpr double degrees = 180 / std::numbers::pi;
    setText(tr("Now: x %1 · y %2 m · %3°")
                .arg(number(motion.pose.position.x(), 3), number(motion.pose.position.y(), 3),
                     number(motion.pose.rotation.angle() * degrees, 1)) +
            QLatin1Char('\n') +
            tr("%1 m/s (x %2 · y %3) · %4°/s")
                .arg(number(motion.velocity.norm(), 3), number(motion.velocity.x(), 3), number(motion.velocity.y(), 3),
                     number(motion.angularVelocity * degrees, 1)));
}

void MotionLine::showTension(double distance, double length, double tension) {
    setText(tr("Now: %1 m long, %2 m at rest").arg(number(distance, 3), number(length, 3)) + QLatin1Char('\n') +
            (tension < 0 ? tr("pushes with %1 N").arg(number(-tension, 2))
                         : tr("pulls with %1 N").arg(number(tension, 2))));
}

void MotionLine::showGone() {
    setText(tr("Now: not there any more") + QLatin1Char('\n'));
}

} // namespace spacetow
