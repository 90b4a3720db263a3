#include "editor/play/chase.h"

#include <algorithm>
#include <cmath>

namespace spacetow {
namespace {

const Vec2 classicSize(40.0 / 3, 10); // m, seen at least
constexpr double rockSeen = 0.6;      // m, of what lies beyond the level's bounds
constexpr double sideKept = 1.5;      // m, between the ship and the edge of the view
constexpr double shipLength = 0.5;    // m
constexpr double leastShip = 8;       // px, of a ship that can be steered
constexpr double freeShare = 0.6;     // of half the view, in which the ship moves without the view
constexpr double glide = 5;           // 1/s

/// Along one axis, m.
struct Framing {
    double low, high; // of the level
    double half;      // of the view
    double kept;      // always in sight
};

double roomFor(double half) {
    return std::max(0.0, half - std::min(sideKept, 0.4 * half));
}

/// The middle of the view along one axis: as little as possible beyond the level is in sight.
double framedAxis(double camera, const Framing& f) {
    const double wanted =
        f.high - f.low > 2 * f.half ? std::clamp(camera, f.low + f.half, f.high - f.half) : (f.low + f.high) / 2;
    const double room = roomFor(f.half);
    return std::clamp(wanted, f.kept - room, f.kept + room);
}

/// Along one axis, m.
struct Chased {
    double center, half; // of the view
    double low, high;    // of the level
    double ship;
};

bool isAllInSight(const Chased& c) {
    const double least = c.center - c.half;
    const double most = c.center + c.half;
    return c.low <= c.ship && c.ship <= c.high && least <= c.low && c.high <= most;
}

double chasedAxis(const Chased& c, double share) {
    if (isAllInSight(c)) {
        return c.center;
    }
    const auto& [center, half, low, high, ship] = c;
    const double gap = ship - center;
    const double free = freeShare * half;
    const double glided = center + (gap - std::clamp(gap, -free, free)) * share;
    const double room = roomFor(half);
    return std::clamp(glided, ship - room, ship + room);
}

} // namespace

Viewport chased(const Viewport& view, const Chase& chase, double seconds) {
    const Vec2 half = view.size / (2 * view.scale);
    const double share = 1 - std::exp(-glide * seconds);
    Viewport next = view;
    const auto along = [&](int axis) {
        return Chased{view.center[axis], half[axis], chase.level.min[axis], chase.level.max[axis], chase.ship[axis]};
    };
    next.center = Vec2(chasedAxis(along(0), share), chasedAxis(along(1), share));
    return next;
}

Viewport classicView(const Snapshot& snapshot, const Aabb& bounds, const Vec2& size) {
    const std::optional<Vec2> ship = shipIn(snapshot);
    const bool whole = !ship && !bounds.isEmpty(); // nothing to follow, so all of it should be in sight
    const Vec2 extent = whole ? Vec2(classicSize.cwiseMax(1.08 * bounds.size())) : classicSize;
    Viewport view;
    view.size = size;
    view.scale =
        std::clamp(std::min(size.x() / extent.x(), size.y() / extent.y()), Viewport::minScale, Viewport::maxScale);
    view.center = snapshot.camera;
    if (ship && !bounds.isEmpty()) {
        const Aabb all = bounds.grown(rockSeen);
        const Vec2 half = size / (2 * view.scale);
        view.center = Vec2(framedAxis(view.center.x(), {all.min.x(), all.max.x(), half.x(), ship->x()}),
                           framedAxis(view.center.y(), {all.min.y(), all.max.y(), half.y(), ship->y()}));
    }
    return view;
}

bool canFlyBy(const Viewport& view, const Vec2& ship) {
    return view.visible().contains(ship) && shipLength * view.scale >= leastShip;
}

std::optional<Vec2> shipIn(const Snapshot& snapshot) {
    const auto ship =
        std::ranges::find(snapshot.moving, BodyRole::Ship, [](const BodyPicture& body) { return body.look->role; });
    return ship != snapshot.moving.end() ? std::optional(ship->pose.position) : std::nullopt;
}

} // namespace spacetow
