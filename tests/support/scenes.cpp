#include "tests/support/scenes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace spacetow::test {

namespace {

Polygon box(const Vec2& center, double halfWidth, double halfHeight) {
    return {{center + Vec2{-halfWidth, -halfHeight}, center + Vec2{halfWidth, -halfHeight},
             center + Vec2{halfWidth, halfHeight}, center + Vec2{-halfWidth, halfHeight}}};
}

BodyDef fixture(std::vector<Shape> shapes, double friction) {
    BodyDef def;
    def.kind = BodyKind::Static;
    def.shapes = std::move(shapes);
    def.friction = friction;
    return def;
}

BodyDef loose(Shape shape, const Vec2& position, double friction) {
    BodyDef def;
    def.shapes = {std::move(shape)};
    def.position = position;
    def.friction = friction;
    return def;
}

UpdateParameters stepped(double hertz, int iterations) {
    UpdateParameters parameters;
    parameters.seconds = 1 / hertz;
    parameters.iterations = iterations;
    return parameters;
}

/// A heap of balls in a tall box.
Scene balls(int n) {
    Scene scene{.updates = 600, .parameters = stepped(60, 4)};
    scene.bodies.push_back(fixture({Edge{{-10, 60}, {-10, 0}}, Edge{{-10, 0}, {10, 0}}, Edge{{10, 0}, {10, 60}}}, 0.3));
    for (int i = 0; i < n; ++i) {
        const int row = i / 80;
        scene.bodies.push_back(
            loose(Circle{{0, 0}, 0.1}, {-9.5 + 0.24 * (i % 80) + 0.05 * (row % 2), 0.5 + 0.24 * row}, 0.3));
    }
    return scene;
}

/// `n` rows of boxes, one fewer in each.
Scene pyramid(int n) {
    Scene scene{.updates = 600, .parameters = stepped(60, 4)};
    scene.bodies.push_back(fixture({Edge{{-200, 0}, {200, 0}}}, 0.6));
    for (int i = 0; i < n; ++i) {
        for (int j = i; j < n; ++j) {
            scene.bodies.push_back(loose(box({0, 0}, 0.5, 0.5), {1.1 * (j - i) + 0.55 * i - 0.55 * n, 0.5 + i}, 0.6));
        }
    }
    return scene;
}

/// A thousand balls on rugged ground of `n` edges.
Scene cave(int n) {
    Scene scene{.updates = 300, .parameters = stepped(60, 4)};
    const auto ground = [n](int i) {
        const double x = 2000.0 * i / n;
        return Vec2{x, 3 * std::sin(0.7 * x) + 0.3 * std::sin(11 * x)};
    };
    std::vector<Shape> edges;
    for (int i = 0; i < n; ++i) {
        edges.emplace_back(Edge{ground(i), ground(i + 1), 0}); // hills are as thin as they like
    }
    scene.bodies.push_back(fixture(std::move(edges), 0.3));
    for (int i = 0; i < 1000; ++i) {
        scene.bodies.push_back(loose(Circle{{0, 0}, 0.2}, {1 + 1.99 * i, 5}, 0.3));
    }
    return scene;
}

/// Boxes in a slowly turning frame.
Scene tumbler(int n) {
    Scene scene{.updates = 600, .parameters = stepped(60, 4)};
    BodyDef frame =
        fixture({box({20, 0}, 0.5, 20), box({-20, 0}, 0.5, 20), box({0, 20}, 20, 0.5), box({0, -20}, 20, 0.5)}, 0.6);
    frame.kind = BodyKind::Kinematic;
    frame.angularVelocity = 0.436;
    scene.bodies.push_back(std::move(frame));
    for (int i = 0; i < n; ++i) {
        scene.bodies.push_back(
            loose(box({0, 0}, 0.25, 0.25), {-18 + 0.6 * (i % 60), -18 + 0.6 * static_cast<int>(i / 60)}, 0.6));
    }
    return scene;
}

/// Ship and payload on the tow rope, left to fall in a round cave.
Scene tow(int) {
    Scene scene{.updates = 3000, .parameters = stepped(50, 100), .referenceSteps = 100};
    const auto corner = [](int i) {
        const double angle = std::numbers::pi / 6 * i;
        return Vec2{6 * std::cos(angle), 6 * std::sin(angle)};
    };
    std::vector<Shape> edges;
    for (int i = 0; i < 12; ++i) {
        edges.emplace_back(Edge{corner(i), corner(i + 1)});
    }
    scene.bodies.push_back(fixture(std::move(edges), 0.3));
    const Vec2 notch{0, -0.2 / 3};
    BodyDef ship = loose(Polygon{{{0, 0.7 / 3}, {-0.2, -0.5 / 3}, notch, {0.2, -0.5 / 3}}}, {0, 1}, 0.3);
    ship.mass = 1;
    BodyDef payload = loose(Circle{{0, 0}, 0.2}, {0, -0.2}, 0.3);
    payload.mass = 0.25;
    scene.bodies.push_back(std::move(ship));
    scene.bodies.push_back(std::move(payload));
    ConnectorDef rope;
    rope.anchorA = notch;
    rope.stiffness = 50000;
    rope.damping = 100;
    rope.truncation = {.rule = TruncationRule::PartialTanh, .limit = 150, .proportion = 0.75, .custom = {}};
    scene.joints.push_back({1, 2, rope});
    return scene;
}

/// A hanging cloth of `n` × `n` circles.
Scene mesh(int n) {
    constexpr double spacing = 0.2; // m
    Scene scene{.updates = 600, .parameters = stepped(50, 20), .referenceSteps = 20};
    ConnectorDef thread;
    thread.stiffness = 2000;
    thread.damping = 2;
    for (int row = 0; row < n; ++row) {
        for (int column = 0; column < n; ++column) {
            const std::size_t here = scene.bodies.size();
            BodyDef knot = loose(Circle{{0, 0}, 0.05}, {spacing * column, -spacing * row}, 0.3);
            knot.kind = row == 0 ? BodyKind::Static : BodyKind::Dynamic;
            scene.bodies.push_back(std::move(knot));
            if (row > 0) {
                scene.joints.push_back({here - static_cast<std::size_t>(n), here, thread});
            }
            if (row > 0 && column > 0) {
                scene.joints.push_back({here - 1, here, thread});
            }
        }
    }
    return scene;
}

struct Entry {
    std::string_view name;
    int n;
    Scene (*make)(int);
};

constexpr std::array<Entry, 6> entries{{{"balls", 2000, balls},
                                        {"pyramid", 45, pyramid},
                                        {"cave", 100000, cave},
                                        {"tumbler", 2000, tumbler},
                                        {"tow", 1, tow},
                                        {"mesh", 40, mesh}}};

} // namespace

std::vector<std::string> sceneNames() {
    std::vector<std::string> names;
    for (const Entry& entry : entries) {
        names.emplace_back(entry.name);
    }
    return names;
}

std::optional<Scene> makeScene(std::string_view name, std::optional<int> n) {
    const auto* entry = std::find_if(entries.begin(), entries.end(), [&](const Entry& e) { return e.name == name; });
    if (entry == entries.end()) {
        return std::nullopt;
    }
    Scene scene = entry->make(n.value_or(entry->n));
    scene.name = entry->name;
    scene.n = n.value_or(entry->n);
    return scene;
}

World worldOf(const Scene& scene) {
    World world(scene.parameters);
    std::vector<BodyId> ids;
    for (const BodyDef& def : scene.bodies) {
        ids.push_back(world.addBody(def).value());
    }
    for (const Joint& joint : scene.joints) {
        ConnectorDef connector = joint.connector;
        connector.a = ids[joint.a];
        connector.b = ids[joint.b];
        static_cast<void>(world.addConnector(connector).value());
    }
    return world;
}

} // namespace spacetow::test
