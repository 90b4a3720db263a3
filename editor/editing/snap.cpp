#include "editor/editing/snap.h"

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

bool snaps(const SnapSettings& settings, const Modifiers& modifiers) {
    return settings.grid != modifiers.ctrl && settings.step > 0;
}

double onGrid(const SnapSettings& settings, double coordinate) {
    // 3 / 10 is the number spelled 0.3 in a file, 3 * 0.1 is not. Adding zero turns −0 into 0.
    const double steps = std::round(coordinate / settings.step);
    const double perMetre = std::round(1 / settings.step);
    const bool dividesMetre = std::abs(perMetre * settings.step - 1) < 1e-12;
    return (dividesMetre ? steps / perMetre : steps * settings.step) + 0.0;
}

Vec2 onGrid(const SnapSettings& settings, const Vec2& point) {
    return {onGrid(settings, point.x()), onGrid(settings, point.y())};
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
    Vec2 point = from + along * way.dot(along);
    if (!snaps(settings, pointer.modifiers)) {
        return point;
    }
    // To the grid line that the direction crosses most steeply; on axes and diagonals that is a grid point.
    const int main = std::abs(along.x()) >= std::abs(along.y()) ? 0 : 1;
    const int other = 1 - main;
    point[main] = onGrid(settings, point[main]);
    point[other] = from[other] + (point[main] - from[main]) * (along[other] / along[main]);
    return point;
}

} // namespace spacetow
