#include "core/level/leak_walls.h"

#include "core/math/transform.h"
#include "core/math/trig.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace spacetow {

namespace {

struct AddLeakWalls {
    std::vector<LeakWall>& walls;
    Transform pose;
    int object = 0;
    int shape = 0;

    void add(const Vec2& a, const Vec2& b, bool oneWay, std::size_t segment) const {
        const Vec2 from = pose.toWorld(a);
        const Vec2 to = pose.toWorld(b);
        if (isFinite(from) && isFinite(to) && from != to) {
            walls.push_back({from, to, oneWay, object, shape, static_cast<int>(segment)});
        }
    }
    void addChain(const std::vector<Vec2>& vertices, bool closed, bool oneWay) const {
        for (std::size_t i = 0; i + 1 < vertices.size(); ++i) {
            add(vertices[i], vertices[i + 1], oneWay, i);
        }
        if (closed && vertices.size() > 2) {
            add(vertices.back(), vertices.front(), oneWay, vertices.size() - 1);
        }
    }
    void operator()(const EdgeChain& chain) const { addChain(chain.vertices, chain.closed, true); }
    void operator()(const LineChain& chain) const { addChain(chain.vertices, chain.closed, false); }
    void operator()(const Polygon& polygon) const { addChain(polygon.vertices, true, false); }
    void operator()(const Circle& circle) const {
        constexpr double deviation = 0.004; // m, between the polygon's corners and the middles of its sides
        const double share = std::clamp(deviation / circle.radius, 1e-5, 0.02);
        const int sides = std::clamp(static_cast<int>(std::ceil(std::numbers::pi / std::sqrt(2 * share))), 12, 256);
        const double radius = circle.radius * (1 + 0.5 * share);
        std::vector<Vec2> corners;
        for (int i = 0; i < sides; ++i) {
            corners.push_back(circle.center + radius * Rot::fromAngle(2 * std::numbers::pi * i / sides).right());
        }
        for (std::size_t i = 0; i < corners.size(); ++i) {
            add(corners[i], corners[(i + 1) % corners.size()], false, 0);
        }
    }
};

} // namespace

std::vector<LeakWall> leakWalls(const Level& level, const std::function<bool(int object)>& isBad) {
    const Filter ship{TagMask::bit(shipTag), TagMask::bit(wallTag) | TagMask::bit(payloadTag)}; // as in the game
    std::vector<LeakWall> walls;
    for (int i = 0; i < level.objects.size(); ++i) {
        const auto* body = std::get_if<BodyObject>(&level.objects[i].data);
        const bool isPushedAway = body != nullptr && body->kind == BodyKind::Dynamic && !body->frozen;
        if (body == nullptr || isPushedAway || !body->tangible || !mayTouch(ship, body->filter) || isBad(i)) {
            continue;
        }
        AddLeakWalls adder{walls, {body->position, Rot::fromAngle(body->angle)}, i};
        for (const LevelShape& shape : body->shapes) {
            std::visit(adder, shape);
            ++adder.shape;
        }
    }
    return walls;
}

} // namespace spacetow
