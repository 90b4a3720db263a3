#include "editor/window/screen_room.h"

#include <QScreen>
#include <QWidget>

namespace spacetow {

QSize withinScreen(const QSize& wanted, const QSize& available) {
    constexpr QSize frame(16, 48); // at most
    return wanted.boundedTo(available - frame);
}

void resizeWithinScreen(QWidget& window, const QSize& wanted) {
    const QScreen* const monitor = window.screen();
    window.resize(monitor != nullptr ? withinScreen(wanted, monitor->availableGeometry().size()) : wanted);
}

} // namespace spacetow
