#include "tests/support/passages.h"

#include <cmath>

namespace spacetow::test {

BodyDef passerOf(const QString& what, const Vec2& at) {
    if (what == "angle") {
        return {.shapes = {Polygon{{{-0.2, -0.2}, {0.3, -0.2}, {0.3, -0.1}, {-0.1, -0.1}, {-0.1, 0.4}, {-0.2, 0.4}}}},
                .position = at};
    }
    if (what == "trough") {
        return {.shapes = {Polygon{{{-0.3, -0.2},
                                    {0.3, -0.2},
                                    {0.3, 0.3},
                                    {0.2, 0.3},
                                    {0.2, -0.1},
                                    {-0.2, -0.1},
                                    {-0.2, 0.3},
                                    {-0.3, 0.3}}}},
                .position = at};
    }
    return dropped(what, at);
}

void addChain(World& world, const std::vector<Vec2>& corners, double depth) {
    for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
        add(world, edgeBody(corners[i], corners[i + 1], depth));
    }
}

std::vector<Vec2> bentBy(double degrees, double length) {
    const double half = 0.5 * degrees * pi / 180;
    return {-length * Rot::fromAngle(-half).right(), {0, 0}, length * Rot::fromAngle(half).right()};
}

std::vector<Vec2> arcOf(double degrees) {
    constexpr int count = 20;
    const double step = degrees * pi / 180 / count;
    std::vector<Vec2> corners{{0, 0}};
    for (int i = 0; i < count; ++i) {
        corners.push_back(corners.back() + 0.25 * Rot::fromAngle((i - 0.5 * (count - 1)) * step).right());
    }
    const Vec2 middle = corners[count / 2];
    for (Vec2& corner : corners) {
        corner -= middle;
    }
    return corners;
}

Flight::Flight(int iterations, const std::vector<Vec2>& corners, double depth)
    : world(withIterations(iterations, {0, 0})) {
    addChain(world, corners, depth);
}

void Flight::start(const QString& what, const Vec2& from, const Vec2& v, double spin) {
    BodyDef def = passerOf(what, from);
    def.angle = 0.4;
    def.velocity = velocity = v;
    def.angularVelocity = spin;
    id = add(world, def);
    at = world.body(id).massCenter;
}

QString Flight::fly(double way) {
    const int updates = static_cast<int>(std::ceil(way / velocity.norm() / world.parameters().seconds));
    for (int i = 0; i < updates; ++i) {
        world.update();
        at += world.parameters().seconds * velocity;
        const BodyState now = world.body(id);
        if (!world.events().began.empty() || (now.massCenter - at).norm() > 1e-9 ||
            (now.velocity - velocity).norm() > 1e-9 * velocity.norm()) {
            return QString("touched in update %1 of %2, at (%3, %4), velocity (%5, %6)")
                .arg(i)
                .arg(updates)
                .arg(now.massCenter.x())
                .arg(now.massCenter.y())
                .arg(now.velocity.x())
                .arg(now.velocity.y());
        }
    }
    return {};
}

void Flight::turnBack(double spin) {
    velocity = -velocity;
    world.setVelocity(id, velocity, spin);
}

QString flownText(const FlownAs& flown) {
    return QString("%1 m/s, %2 across, %3 iterations: ").arg(flown.speed).arg(flown.across).arg(flown.iterations);
}

} // namespace spacetow::test
