#pragma once
// What the tests of contacts share: things to drop, floors to drop them on, and running a world. SI units.

#include "core/game/ship.h"
#include "core/geometry/polygon.h"
#include "core/physics/world/world.h"
#include "tests/support/bodies.h"
#include "tests/support/full_run.h"
#include "tests/support/rows.h"
#include "tests/support/test_main.h"

#include <cmath>
#include <numbers>

namespace spacetow::test {

inline constexpr double pi = std::numbers::pi;

inline UpdateParameters withIterations(int iterations, const Vec2& gravity = {0, -9.81}) {
    return {.gravity = gravity, .iterations = iterations};
}

inline void run(World& world, double seconds) {
    const int updates = static_cast<int>(std::lround(seconds / world.parameters().seconds));
    for (int i = 0; i < updates; ++i) {
        world.update();
    }
}

inline BodyDef hexagon(const Vec2& at) {
    return {.shapes = {Polygon{regularPolygon(6, 0.25)}}, .position = at};
}

inline BodyDef dropped(const QString& what, const Vec2& at) {
    if (what == "ball") {
        return ball(at, 0.2);
    }
    if (what == "box") {
        return box(at, 0.2, 0.2);
    }
    if (what == "hexagon") {
        return hexagon(at);
    }
    BodyDef ship = shipBody(at, 0);
    ship.filter = {};
    ship.linearDamping = ship.angularDamping = 0;
    ship.restitution = 0;
    return ship;
}

/// The lowest point of a body's shapes, world coordinates.
inline double lowestPoint(const World& world, BodyId id) {
    double lowest = std::numeric_limits<double>::infinity();
    const Transform pose = world.body(id).pose;
    for (const Shape& shape : world.shapes(id)) {
        if (const auto* circle = std::get_if<Circle>(&shape)) {
            lowest = std::min(lowest, pose.toWorld(circle->center).y() - circle->radius);
        } else {
            for (const Vec2& v : std::get<Polygon>(shape).vertices) {
                lowest = std::min(lowest, pose.toWorld(v).y());
            }
        }
    }
    return lowest;
}

/// A static floor at y = 0 made of the given shape; a circle reaches that height at x = 0 alone.
inline BodyDef floorOf(const QString& shape) {
    if (shape == "edge") {
        return edgeBody({-20, 0}, {20, 0});
    }
    if (shape == "thin edge") {
        return edgeBody({-20, 0}, {20, 0}, 0);
    }
    if (shape == "line") {
        return lineBody({-20, 0}, {20, 0});
    }
    BodyDef floor = shape == "circle" ? ball({0, -1}, 1) : box({0, -1}, 20, 1);
    floor.kind = BodyKind::Static;
    return floor;
}

inline const char* const floors[] = {"edge", "thin edge", "line", "polygon"};

} // namespace spacetow::test
