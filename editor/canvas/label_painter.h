#pragma once
// Words on a plate beside a point of the canvas: lengths and angles, names of what was snapped to.

#include "editor/canvas/stage.h"

#include <QString>

namespace spacetow {

/// Above leaves room below for the other: measures stand above the pointer, names below.
enum class LabelSide { Above, Below };

/// One line or several, kept inside the view.
void paintLabel(const Stage& stage, const Vec2& at, const QString& words, LabelSide side = LabelSide::Above);

} // namespace spacetow
