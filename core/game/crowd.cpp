#include "core/game/crowd.h"

#include <algorithm>
#include <vector>

namespace spacetow {

namespace {

constexpr std::size_t mostParts = 4;

struct Standing {
    Aabb box;
    Filter filter;
    bool isMoved; // by the physics
};

std::vector<Standing> standingIn(const World& world) {
    std::vector<Standing> all;
    for (const BodyId id : world.bodies()) {
        const BodyState body = world.body(id);
        if (body.active && world.shapes(id).size() <= mostParts) {
            all.push_back({world.bounds(id), body.filter, body.kind == BodyKind::Dynamic});
        }
    }
    return all;
}

} // namespace

bool isCrowded(const World& world, std::int64_t most) {
    const std::int64_t bodies = world.bodyCount();
    if (bodies * (bodies - 1) / 2 <= most) {
        return false;
    }
    std::vector<Standing> all = standingIn(world);
    std::ranges::sort(all, {}, [](const Standing& one) { return one.box.min.x(); });
    std::int64_t pairs = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const Standing& one = all[i];
        for (std::size_t j = i + 1; j < all.size() && all[j].box.min.x() <= one.box.max.x(); ++j) {
            const Standing& other = all[j];
            const bool meet = one.box.min.y() <= other.box.max.y() && other.box.min.y() <= one.box.max.y();
            if (meet && (one.isMoved || other.isMoved) && mayTouch(one.filter, other.filter) && ++pairs > most) {
                return true;
            }
        }
    }
    return false;
}

bool isCrowdedAt(std::int64_t update, const World& world) {
    constexpr std::int64_t interval = 50;
    return update % interval == 0 && isCrowded(world);
}

} // namespace spacetow
