#pragma once
// How large windows may be at first. Logical pixels.

#include <QSize>

class QWidget;

namespace spacetow {

/// At most as large as what is available, less what the desktop puts round a window.
QSize withinScreen(const QSize& wanted, const QSize& available);
/// The same on the screen of the widget.
void resizeWithinScreen(QWidget& window, const QSize& wanted);

} // namespace spacetow
