#pragma once
// Colours of marks in forms that are read on light and on dark panels.

#include "editor/canvas/palette.h"

#include <QColor>
#include <QPalette>

namespace spacetow {

/// For sentences that say what is wrong, and the frame of what they are about.
inline QColor faultColor(const QPalette& palette) {
    return markColors(shadeOf(palette)).error;
}

} // namespace spacetow
