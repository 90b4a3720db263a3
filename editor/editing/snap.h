#pragma once
// How points snap, and where they land on the grid and on multiples of 15°. What there is to snap to in a level stands
// in snap_search.h, what tools call in snap_point.h.

#include "core/geometry/stretch.h"
#include "core/level/level.h"
#include "editor/editing/input.h"

#include <span>

namespace spacetow {

struct SnapSettings {
    bool grid = true;
    double step = 0.25;   // m
    int division = 1;     // of a step into as many parts, on which points land too
    bool smart = true;    // to what is in the level, as far as these say:
    bool vertices = true; // and centres
    bool edges = true;
    bool midpoints = true;
    bool intersections = true;
    bool perpendiculars = true;
    bool guides = true;
    bool alignment = true;
    bool angles = false; // as Shift does always
    double reach = 10;   // px, within which anything but the grid draws the point

    double fineStep() const { return step / division; } // m

    bool operator==(const SnapSettings&) const = default;
};

/// The distances from which people choose, ascending: 1 cm … 10 m.
std::span<const double> usualSteps();
/// The next of them above or below.
double coarserStep(double step);
double finerStep(double step);

/// What holds while these keys are held. Ctrl suspends all snapping or, where none is on, turns it on.
SnapSettings withHeld(const SnapSettings& settings, const Modifiers& modifiers);
/// Whether points land on the grid with these modifiers.
bool snaps(const SnapSettings& settings, const Modifiers& modifiers);
/// The nearest multiple of the fine step, which must be positive.
double onGrid(const SnapSettings& settings, double coordinate);
Vec2 onGrid(const SnapSettings& settings, const Vec2& point);
/// The same, where points snap to the grid and it has that point in the box or but for rounding; else the point itself:
/// what is smaller than a step may have none in it.
Vec2 onGridWithin(const SnapSettings& settings, const Aabb& box, const Vec2& point);
/// Unit vector at the multiple of 15° nearest to the direction of `vector`.
Vec2 snappedDirection(const Vec2& vector);

/// The pointer's world position snapped to the grid alone, unless that is off or suspended.
Vec2 snapped(const SnapSettings& settings, const Pointer& pointer);
/// Likewise; with Shift on the nearest multiple of 15° as seen from `from`, and there on the grid line it crosses.
Vec2 snappedFrom(const SnapSettings& settings, const Pointer& pointer, const Vec2& from);
/// Where the line crosses the grid line nearest to `near`, of those that it crosses most steeply; on axes and diagonals
/// through grid points that is a grid point.
Vec2 onGridLine(const SnapSettings& settings, const StraightLine& line, const Vec2& near);

} // namespace spacetow
