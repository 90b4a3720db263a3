#pragma once
// What lies behind the cave. "stars" is painted from numbers alone: three sheets of stars that the camera passes at
// different speeds, over a faint glow. Any other name gives the flat colour of empty space.

#include "editor/canvas/stage.h"

#include <QString>

namespace spacetow {

/// Fills the whole view; the stage's theme gives the flat colour.
void paintBackdrop(const Stage& stage, const QString& name);

} // namespace spacetow
