#pragma once
// A small picture of a level.

#include "core/level/level.h"
#include "editor/canvas/theme.h"

#include <QImage>

namespace spacetow {

/// May be painted in any thread. The size is in device pixels; the theme must live as long as the program.
QImage thumbnailOf(const Level& level, const QSize& size, const Theme& theme);

} // namespace spacetow
