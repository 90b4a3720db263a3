#include "core/physics/query/tunnelling.h"

#include "core/geometry/bounds.h"
#include "core/geometry/moving_quadtree.h"

#include <algorithm>
#include <cmath>

namespace spacetow {

namespace {

constexpr double ahead = 1; // s, of motion that bodies are swept along

/// Whether the body stops others: sensors do not, nor do inactive bodies.
bool stops(const BodyState& state) {
    return state.active && state.tangible;
}

/// The bodies in motion, with their swept AABBs.
struct Swept {
    std::vector<BodyState> bodies;
    std::vector<BodyId> ids;
    std::vector<Aabb> boxes;
    MovingQuadtree tree;

    explicit Swept(const World& world) {
        for (const BodyId id : world.bodies()) {
            const BodyState state = world.body(id);
            if (state.kind == BodyKind::Static || !stops(state) || state.velocity.squaredNorm() == 0) {
                continue;
            }
            const Aabb box = world.bounds(id);
            Aabb swept = box;
            swept.include(box.min + ahead * state.velocity);
            swept.include(box.max + ahead * state.velocity);
            bodies.push_back(state);
            ids.push_back(id);
            boxes.push_back(swept);
        }
        tree.fill(boxes);
    }
};

} // namespace

std::vector<WallRisk> wallRisks(const World& world, const std::optional<Aabb>& area) {
    const Swept swept(world);
    std::vector<WallRisk> risks;
    if (swept.bodies.empty()) {
        return risks;
    }
    const UpdateParameters& parameters = world.parameters();
    const double iteration = parameters.seconds / parameters.iterations;
    std::vector<std::uint32_t> near;
    for (const BodyId id : world.bodies()) {
        if (area && !world.bounds(id).overlaps(*area)) {
            continue;
        }
        const BodyState state = world.body(id);
        if (!stops(state)) {
            continue;
        }
        for (const Shape& shape : world.shapes(id)) {
            const auto* edge = std::get_if<Edge>(&shape);
            if (edge == nullptr || !(edge->depth > 0) || edge->depth == noBack || edge->a == edge->b) {
                continue;
            }
            const Vec2 a = state.pose.toWorld(edge->a);
            const Vec2 b = state.pose.toWorld(edge->b);
            Aabb box{a, a};
            box.include(b);
            if (area && !area->overlaps(box)) {
                continue;
            }
            const Vec2 normal = leftOf((b - a) / (b - a).norm());
            near.clear();
            swept.tree.query(box, near);
            double speed = 0;
            for (const std::uint32_t i : near) {
                if (swept.ids[i] != id && mayTouch(state.filter, swept.bodies[i].filter)) {
                    speed = std::max(speed, normal.dot(state.velocity - swept.bodies[i].velocity));
                }
            }
            if (speed > 0) {
                risks.push_back({id, a, b, speed, speed * iteration / edge->depth});
            }
        }
    }
    return risks;
}

} // namespace spacetow
