#include "tests/support/drive.h"

#include "core/math/transform.h"

#include <utility>

namespace spacetow::test {

Drive::Drive(Level level) : document(std::move(level), [this] { return m_now; }), toolbox(document, 1) {}

Pointer Drive::at(const Vec2& world) {
    m_last = {world, view.toScreen(world), held, view.pixel(), view.visible()};
    return m_last;
}

void Drive::click(const Vec2& world) {
    move(world);
    press(world);
    release(world);
}

void Drive::click(std::initializer_list<Vec2> points) {
    for (const Vec2& point : points) {
        click(point);
    }
}

void Drive::doubleClick(const Vec2& world) {
    click(world);
    toolbox.doubleClick(at(world));
    release(world);
}

void Drive::drag(const Vec2& from, const Vec2& to) {
    move(from);
    press(from);
    for (const double share : {0.25, 0.5, 1.0}) {
        move(from + share * (to - from));
    }
    release(to);
}

std::vector<Vec2> worldPoints(const Object& object) {
    const auto& body = std::get<BodyObject>(object.data);
    const Transform pose{body.position, Rot::fromAngle(body.angle)};
    std::vector<Vec2> points;
    for (const LevelShape& shape : body.shapes) {
        std::visit(
            [&](const auto& some) {
                if constexpr (requires { some.vertices; }) {
                    for (const Vec2& vertex : some.vertices) {
                        points.push_back(pose.toWorld(vertex));
                    }
                } else {
                    points.push_back(pose.toWorld(some.center));
                }
            },
            shape);
    }
    return points;
}

} // namespace spacetow::test
