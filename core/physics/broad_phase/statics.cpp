#include "core/physics/broad_phase/statics.h"

#include "core/geometry/bounds.h"
#include "core/geometry/convex_parts.h"
#include "core/geometry/moved.h"

#include <cmath>

namespace spacetow {

namespace {

Part partInWorld(const Part& part, const Transform& pose) {
    return std::visit([&pose](const auto& p) -> Part { return moved(p, pose); }, part);
}

Aabb treeBox(const StaticGeometry::Collider& collider) {
    const bool wall = std::holds_alternative<WallPart>(collider.shape);
    return wall ? enlargedEdgeBounds(collider.bounds) : collider.bounds;
}

/// Static bodies that continue one another are as smooth as one body.
void join(StaticGeometry& geometry) {
    std::vector<WallPart*> walls;
    std::vector<ConvexPart*> convexParts;
    for (StaticGeometry::Collider& collider : geometry.colliders) {
        if (auto* wall = std::get_if<WallPart>(&collider.shape)) {
            walls.push_back(wall);
        } else if (auto* convex = std::get_if<ConvexPart>(&collider.shape)) {
            convexParts.push_back(convex);
        }
    }
    joinWalls(walls);
    joinConvexParts(convexParts);
    for (StaticGeometry::Collider& collider : geometry.colliders) {
        if (const auto* wall = std::get_if<WallPart>(&collider.shape); wall != nullptr && wall->oneWay) {
            collider.side = sideOf(*wall, false);
        }
    }
}

/// The tree's boxes. Those of edges without a back cover what is behind them inside of the area of all the others.
std::vector<Aabb> treeBoxes(StaticGeometry& geometry) {
    std::vector<Aabb> boxes;
    for (std::uint32_t i = 0; i < geometry.colliders.size(); ++i) {
        StaticGeometry::Collider& collider = geometry.colliders[i];
        boxes.push_back(treeBox(collider));
        geometry.area.include(boxes.back());
        const auto* wall = std::get_if<WallPart>(&collider.shape);
        if (wall != nullptr && wall->oneWay && std::isinf(wall->depth)) {
            collider.back = static_cast<int>(geometry.backs.size());
            geometry.backs.push_back({i, backOf(collider.side)});
        }
    }
    for (const StaticGeometry::Back& back : geometry.backs) {
        boxes[back.collider].include(back.region.within(geometry.area));
    }
    return boxes;
}

bool reachesInto(const StaticGeometry& geometry, std::uint32_t index, const Aabb& box) {
    const StaticGeometry::Collider& collider = geometry.colliders[index];
    return collider.bounds.overlaps(box) ||
           (collider.back >= 0 && geometry.backs[static_cast<std::size_t>(collider.back)].region.meets(box));
}

void collectParts(WorldData& data, StaticGeometry& geometry) {
    for (Slot slot = 0; slot < data.records.size(); ++slot) {
        BodyRecord& record = data.records[slot];
        if (record.used && record.kind == BodyKind::Static && record.active) {
            record.firstStatic = static_cast<std::uint32_t>(geometry.colliders.size());
            for (std::uint32_t i = 0; i < record.parts->size(); ++i) {
                const Part part = partInWorld((*record.parts)[i], data.pose(slot));
                geometry.colliders.push_back({slot, i, part, boundsOf(part, Transform{}), {}, -1});
            }
        }
    }
}

/// Pairs of sleepers are found again only when they wake.
void renewSleepingPairs(WorldData& data) {
    for (Pair& pair : data.sleep.table.pairs) {
        if (pair.staticB) {
            pair.collider = data.records[pair.bodyB].firstStatic + pair.partB;
            pair.shapeB = &data.statics->colliders[pair.collider].shape;
        }
    }
}

} // namespace

void refreshStatics(WorldData& data) {
    if (!data.flags.staticsChanged && data.statics) {
        return;
    }
    auto geometry = std::make_shared<StaticGeometry>();
    collectParts(data, *geometry);
    join(*geometry);
    for (BodyRecord& record : data.records) {
        record.bounds = record.kind == BodyKind::Static ? Aabb{} : record.bounds;
        record.solid = Aabb{};
    }
    std::vector<Aabb> boxes = treeBoxes(*geometry);
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        BodyRecord& record = data.records[geometry->colliders[i].body];
        record.bounds.include(boxes[i]);
        record.solid.include(geometry->colliders[i].bounds);
    }
    geometry->tree = StaticQuadtree(std::move(boxes));
    data.statics = std::move(geometry);
    data.flags.staticsChanged = false;
    renewSleepingPairs(data);
    data.flags.pairsStale = true;
}

void findStatics(const StaticGeometry& geometry, const Aabb& box, std::vector<std::uint32_t>& out) {
    out.clear();
    geometry.tree.query(box, out);
    std::erase_if(out, [&](std::uint32_t i) { return !reachesInto(geometry, i, box); });
    if (geometry.area.contains(box)) {
        return;
    }
    for (const StaticGeometry::Back& back : geometry.backs) {
        if (!geometry.tree.boxes()[back.collider].overlaps(box) && back.region.meets(box)) {
            out.push_back(back.collider);
        }
    }
}

} // namespace spacetow
