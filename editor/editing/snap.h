#pragma once
// Where a point lands: on the grid, on a multiple of 15°, or just where the pointer is.

#include "core/level/level.h"
#include "editor/editing/input.h"

#include <optional>

namespace spacetow {

struct SnapSettings {
    bool grid = true;   // Ctrl inverts it for the moment
    double step = 0.25; // m

    bool operator==(const SnapSettings&) const = default;
};

/// The pointer's world position snapped to the grid, unless snapping is off or Ctrl inverts it.
Vec2 snapped(const SnapSettings& settings, const Pointer& pointer);
/// Likewise, and with Shift on the nearest multiple of 15° as seen from `from`.
Vec2 snappedFrom(const SnapSettings& settings, const Pointer& pointer, const Vec2& from);

} // namespace spacetow
