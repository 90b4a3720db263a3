#include "tests/support/scenes.h"

#include "core/game/ship.h"

#include <array>
#include <cmath>
#include <map>
#include <numbers>

namespace spacetow::test {

namespace {

Polygon boxShape(double halfWidth, double halfHeight) {
    return {{Vec2(-halfWidth, -halfHeight), Vec2(halfWidth, -halfHeight), Vec2(halfWidth, halfHeight),
             Vec2(-halfWidth, halfHeight)}};
}

BodyDef withFriction(BodyDef def, double friction) {
    def.friction = friction;
    return def;
}

void addBalls(World& world, int n) {
    add(world, withFriction(edgeBody({-10, 60}, {-10, 0}), 0.3));
    add(world, withFriction(edgeBody({-10, 0}, {10, 0}), 0.3));
    add(world, withFriction(edgeBody({10, 0}, {10, 60}), 0.3));
    for (int i = 0; i < n; ++i) {
        const int row = i / 80;
        add(world, withFriction(ball({-9.5 + 0.24 * (i % 80) + 0.05 * (row % 2), 0.5 + 0.24 * row}, 0.1), 0.3));
    }
}

void addPyramid(World& world, int n) {
    add(world, withFriction(edgeBody({-200, 0}, {200, 0}), 0.6));
    for (int i = 0; i < n; ++i) {
        for (int j = i; j < n; ++j) {
            add(world, withFriction(box({1.1 * (j - i) + 0.55 * i - 0.55 * n, 0.5 + i}, 0.5, 0.5), 0.6));
        }
    }
}

void addCave(World& world, int n) {
    const auto height = [](double x) { return 3 * std::sin(0.7 * x) + 0.3 * std::sin(11 * x); };
    BodyDef floor = withFriction({.kind = BodyKind::Static}, 0.3);
    for (int i = 0; i < n; ++i) {
        const double x0 = 2000.0 * i / n;
        const double x1 = 2000.0 * (i + 1) / n;
        floor.shapes.push_back(Edge{{x0, height(x0)}, {x1, height(x1)}, noBack});
    }
    add(world, floor);
    for (int i = 0; i < 1000; ++i) {
        add(world, withFriction(ball({1 + 1.99 * i, 5}, 0.2), 0.3));
    }
}

void addTumbler(World& world, int n) {
    BodyDef frame;
    frame.kind = BodyKind::Kinematic;
    frame.angularVelocity = 0.436;
    frame.friction = 0.6;
    for (const auto& [at, half] : {std::pair(Vec2(20, 0), Vec2(0.5, 20)), std::pair(Vec2(-20, 0), Vec2(0.5, 20)),
                                   std::pair(Vec2(0, 20), Vec2(20, 0.5)), std::pair(Vec2(0, -20), Vec2(20, 0.5))}) {
        Polygon side = boxShape(half.x(), half.y());
        for (Vec2& v : side.vertices) {
            v += at;
        }
        frame.shapes.push_back(side);
    }
    add(world, frame);
    for (int i = 0; i < n; ++i) {
        add(world, withFriction(box({-18 + 0.6 * (i % 60), -18 + 0.6 * (i / 60)}, 0.25, 0.25), 0.6));
    }
}

void addTow(World& world, int) {
    for (int i = 0; i < 12; ++i) {
        const auto corner = [](int k) {
            const double angle = 2 * std::numbers::pi * k / 12;
            return Vec2(6 * std::cos(angle), 6 * std::sin(angle));
        };
        add(world, edgeBody(corner(i), corner(i + 1)));
    }
    const BodyId ship = add(world, shipBody({0, 1}, 0));
    BodyDef load = ball({0, -0.2}, 0.2);
    load.mass = 0.25;
    const BodyId payload = add(world, load);
    ConnectorDef rope;
    rope.a = ship;
    rope.b = payload;
    rope.anchorA = shipNotch();
    rope.stiffness = 50000;
    rope.damping = 100;
    rope.truncation = {TruncationRule::PartialTanh, 150, 0.75, {}};
    (void)world.addConnector(rope);
}

void addMesh(World& world, int n) {
    std::vector<BodyId> knots;
    for (int row = 0; row < n; ++row) {
        for (int column = 0; column < n; ++column) {
            BodyDef knot = ball({0.2 * column, -0.2 * row}, 0.05);
            knot.kind = row == 0 ? BodyKind::Static : BodyKind::Dynamic;
            knots.push_back(add(world, knot));
        }
    }
    const auto connect = [&](int from, int to) {
        ConnectorDef c;
        c.a = knots[static_cast<std::size_t>(from)];
        c.b = knots[static_cast<std::size_t>(to)];
        c.stiffness = 2000;
        c.damping = 2;
        (void)world.addConnector(c);
    };
    for (int row = 0; row < n; ++row) {
        for (int column = 0; column < n; ++column) {
            if (column + 1 < n && row > 0) {
                connect(row * n + column, row * n + column + 1);
            }
            if (row + 1 < n) {
                connect(row * n + column, (row + 1) * n + column);
            }
        }
    }
}

} // namespace

BodyDef edgeBody(const Vec2& a, const Vec2& b, double depth) {
    return {.kind = BodyKind::Static, .shapes = {Edge{a, b, depth}}};
}

BodyDef lineBody(const Vec2& a, const Vec2& b) {
    return {.kind = BodyKind::Static, .shapes = {Line{a, b}}};
}

BodyDef ball(const Vec2& at, double radius) {
    return {.shapes = {Circle{{0, 0}, radius}}, .position = at};
}

BodyDef box(const Vec2& at, double halfWidth, double halfHeight) {
    return {.shapes = {boxShape(halfWidth, halfHeight)}, .position = at};
}

BodyId add(World& world, const BodyDef& def) {
    return world.addBody(def).value();
}

std::optional<World> scene(std::string_view name, int n, const UpdateParameters& parameters) {
    static const std::map<std::string_view, void (*)(World&, int)> scenes{
        {"balls", addBalls},     {"pyramid", addPyramid}, {"cave", addCave},
        {"tumbler", addTumbler}, {"tow", addTow},         {"mesh", addMesh},
    };
    const auto found = scenes.find(name);
    if (found == scenes.end()) {
        return {};
    }
    World world(parameters);
    found->second(world, n);
    return world;
}

UpdateParameters sceneParameters(std::string_view name) {
    UpdateParameters parameters;
    if (name == "mesh") {
        parameters.iterations = 20;
    } else if (name != "tow") {
        parameters.seconds = 1.0 / 60;
        parameters.iterations = 4;
    }
    return parameters;
}

} // namespace spacetow::test
