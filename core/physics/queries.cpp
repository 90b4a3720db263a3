#include "core/physics/queries.h"

#include "core/geometry/bounds.h"
#include "core/geometry/cast.h"
#include "core/physics/world_data.h"

#include <algorithm>

namespace spacetow {

namespace {

/// Calls `visit(id, part, pose)` for every part of every active body, in order of creation.
template <class Visit>
void forEachPart(const World& world, const Visit& visit) {
    const WorldData& data = world.data();
    for (const BodyId id : world.bodies()) {
        if (!data.records[id.index].active) {
            continue;
        }
        for (const Part& part : *data.records[id.index].parts) {
            visit(id, part, data.pose(id.index));
        }
    }
}

void addOnce(std::vector<BodyId>& ids, BodyId id) {
    if (ids.empty() || ids.back() != id) {
        ids.push_back(id);
    }
}

} // namespace

std::optional<RayHit> rayCast(const World& world, const Vec2& from, const Vec2& to, TagMask mask) {
    std::optional<RayHit> best;
    forEachPart(world, [&](BodyId id, const Part& part, const Transform& pose) {
        if (!world.data().records[id.index].filter.tags.intersects(mask)) {
            return;
        }
        const auto hit = rayCast(part, pose, from, to);
        if (hit && (!best || hit->fraction < best->fraction)) {
            best = RayHit{id, from + hit->fraction * (to - from), hit->normal, hit->fraction};
        }
    });
    return best;
}

std::vector<BodyId> bodiesAt(const World& world, const Vec2& point) {
    std::vector<BodyId> ids;
    forEachPart(world, [&](BodyId id, const Part& part, const Transform& pose) {
        if (contains(part, pose, point)) {
            addOnce(ids, id);
        }
    });
    return ids;
}

std::vector<BodyId> bodiesIn(const World& world, const Aabb& box) {
    std::vector<BodyId> ids;
    forEachPart(world, [&](BodyId id, const Part& part, const Transform& pose) {
        if (boundsOf(part, pose).overlaps(box)) {
            addOnce(ids, id);
        }
    });
    return ids;
}

std::vector<Aabb> quadtreeCells(const World& world) {
    const WorldData& data = world.data();
    std::vector<Aabb> cells = data.statics ? data.statics->tree.cells() : std::vector<Aabb>{};
    const std::vector<Aabb> moving = data.tree.cells();
    cells.insert(cells.end(), moving.begin(), moving.end());
    return cells;
}

} // namespace spacetow
