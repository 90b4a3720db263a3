#pragma once
// Where a point has snapped to: a marker, another one for each kind of thing, its name, and dashed lines to what the
// point is in line with.

#include "editor/canvas/label_painter.h"
#include "editor/editing/snap_answer.h"

#include <QPainterPath>
#include <QString>

namespace spacetow {

void paintSnap(const Stage& stage, const SnapAnswer& snap, const QString& name, LabelPainter& labels);

/// In pixels around the origin; empty for what has none. No two kinds have the same.
QPainterPath snapMarker(SnapKind kind);

} // namespace spacetow
