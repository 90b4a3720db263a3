#pragma once
// Colours of marks in forms that are read on light and on dark panels.

#include <QColor>
#include <QPalette>

namespace spacetow {

/// For sentences that say what is wrong, and the frame of what they are about.
inline QColor faultColor(const QPalette& palette) {
    return palette.color(QPalette::Window).lightness() < 128 ? QColor(255, 138, 128) : QColor(186, 26, 26);
}

} // namespace spacetow
