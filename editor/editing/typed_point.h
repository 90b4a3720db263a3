#pragma once
// Where a point lands that is drawn from another one: snapped, or where what has been typed puts it.

#include "editor/editing/snap_point.h"

namespace spacetow {

inline Vec2 pointFrom(const ToolContext& context, const Vec2& from, const Pointer& pointer) {
    const double step = snaps(context.snap, pointer.modifiers) ? context.snap.fineStep() : 0;
    return typedPoint(context.typed, from, snappedFrom(context, pointer, from), step);
}

} // namespace spacetow
