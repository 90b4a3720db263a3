#pragma once
// A small square in one or several colours.

#include "core/physics/query/debug_draw.h"

#include <QIcon>

#include <span>

namespace spacetow {

/// `side` in logical pixels.
QIcon swatch(std::span<const Color> colors, int side);

} // namespace spacetow
