#pragma once
// Where a point lands: on the grid, on a multiple of 15°, or just where the pointer is.

#include "core/level/level.h"
#include "editor/editing/input.h"

namespace spacetow {

struct SnapSettings {
    bool grid = true;   // Ctrl inverts it for the moment
    double step = 0.25; // m

    bool operator==(const SnapSettings&) const = default;
};

/// Whether points land on the grid with these modifiers.
bool snaps(const SnapSettings& settings, const Modifiers& modifiers);
/// The nearest multiple of the step, which must be positive.
double onGrid(const SnapSettings& settings, double coordinate);
Vec2 onGrid(const SnapSettings& settings, const Vec2& point);
/// Unit vector at the multiple of 15° nearest to the direction of `vector`.
Vec2 snappedDirection(const Vec2& vector);

/// The pointer's world position snapped to the grid, unless snapping is off or Ctrl inverts it.
Vec2 snapped(const SnapSettings& settings, const Pointer& pointer);
/// Likewise; with Shift on the nearest multiple of 15° as seen from `from`, and there on the grid line it crosses.
Vec2 snappedFrom(const SnapSettings& settings, const Pointer& pointer, const Vec2& from);

} // namespace spacetow
