#include "editor/editing/snap.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace spacetow {

namespace {

constexpr int directions = 24; // a whole turn in steps of 15°

/// Unit vector at `index` times 15°; the axes and diagonals are exact, so that points on them land on the grid.
Vec2 direction(int index) {
    constexpr double half = std::numbers::sqrt2 / 2;
    switch (index) {
    case 0:
        return {1, 0};
    case 3:
        return {half, half};
    default:
        break;
    }
    if (index >= directions / 4) {
        return leftOf(direction(index - directions / 4));
    }
    const double angle = index * 2 * std::numbers::pi / directions;
    return {std::cos(angle), std::sin(angle)};
}

} // namespace

std::span<const double> usualSteps() {
    static constexpr double steps[] = {0.01, 0.02, 0.05, 0.1, 0.2, 0.25, 0.5, 1, 2, 5, 10};
    return steps;
}

double coarserStep(double step) {
    const auto next = std::ranges::upper_bound(usualSteps(), step);
    return next == usualSteps().end() ? step : *next;
}

double finerStep(double step) {
    const auto next = std::ranges::lower_bound(usualSteps(), step);
    return next == usualSteps().begin() ? step : *(next - 1);
}

SnapSettings withHeld(const SnapSettings& settings, const Modifiers& modifiers) {
    SnapSettings held = settings;
    if (modifiers.ctrl) {
        held.grid = held.smart = !settings.grid && !settings.smart;
    }
    held.grid = held.grid && held.step > 0 && held.division > 0;
    return held;
}

bool snaps(const SnapSettings& settings, const Modifiers& modifiers) {
    return withHeld(settings, modifiers).grid;
}

double onGrid(const SnapSettings& settings, double coordinate) {
    // 3 / 10 is the number spelled 0.3 in a file, 3 * 0.1 is not. Adding zero turns −0 into 0.
    const double step = settings.fineStep();
    const double steps = std::round(coordinate / step);
    const double perMetre = std::round(1 / step);
    const bool dividesMetre = std::abs(perMetre * step - 1) < 1e-12;
    return (dividesMetre ? steps / perMetre : steps * step) + 0.0;
}

Vec2 onGrid(const SnapSettings& settings, const Vec2& point) {
    return {onGrid(settings, point.x()), onGrid(settings, point.y())};
}

Vec2 onGridWithin(const SnapSettings& settings, const Aabb& box, const Vec2& point) {
    constexpr double rounding = 1e-9; // m, of what was drawn on the grid
    if (!settings.grid || !(settings.step > 0)) {
        return point;
    }
    const Vec2 snapped = onGrid(settings, point);
    return box.grown(rounding).contains(snapped) ? snapped : point;
}

Vec2 snapped(const SnapSettings& settings, const Pointer& pointer) {
    return snaps(settings, pointer.modifiers) ? onGrid(settings, pointer.world) : pointer.world;
}

Vec2 snappedDirection(const Vec2& vector) {
    constexpr double step = 2 * std::numbers::pi / directions;
    const int index = static_cast<int>(std::lround(std::atan2(vector.y(), vector.x()) / step));
    return direction((index + directions) % directions);
}

Vec2 snappedFrom(const SnapSettings& settings, const Pointer& pointer, const Vec2& from) {
    if (!pointer.modifiers.shift) {
        return snapped(settings, pointer);
    }
    const Vec2 way = pointer.world - from;
    const Vec2 along = snappedDirection(way);
    const Vec2 point = from + along * way.dot(along);
    return snaps(settings, pointer.modifiers) ? onGridLine(settings, {from, along}, point) : point;
}

Vec2 onGridLine(const SnapSettings& settings, const StraightLine& line, const Vec2& near) {
    const int main = std::abs(line.along.x()) >= std::abs(line.along.y()) ? 0 : 1;
    const int other = 1 - main;
    Vec2 crossing = near;
    crossing[main] = onGrid(settings, near[main]);
    crossing[other] =
        line.through[other] + (crossing[main] - line.through[main]) * (line.along[other] / line.along[main]);
    return crossing;
}

} // namespace spacetow
