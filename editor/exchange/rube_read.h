#pragma once
// A scene of R.U.B.E. (JSON of Box2D) as a drawing: bodies with their fixtures, and joints that a connector can be.
// Metres, radians, y up.

#include "core/level/json_tree.h"
#include "editor/exchange/drawing.h"
#include "editor/exchange/report.h"

namespace spacetow {

/// The notes are left in the report.
Drawing rubeDrawing(const JsonView& root, Report& report);

} // namespace spacetow
