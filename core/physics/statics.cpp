#include "core/physics/statics.h"

#include "core/geometry/bounds.h"
#include "core/geometry/convex_parts.h"
#include "core/geometry/moved.h"
#include "core/physics/sleep.h"

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

void collectParts(WorldData& data, StaticGeometry& geometry) {
    for (Slot slot = 0; slot < data.records.size(); ++slot) {
        BodyRecord& record = data.records[slot];
        if (record.used && record.kind == BodyKind::Static && record.active) {
            record.firstStatic = static_cast<std::uint32_t>(geometry.colliders.size());
            for (std::uint32_t i = 0; i < record.parts->size(); ++i) {
                const Part part = partInWorld((*record.parts)[i], data.pose(slot));
                geometry.colliders.push_back({slot, i, part, boundsOf(part, Transform{}), {}});
            }
        }
    }
}

} // namespace

void refreshStatics(WorldData& data) {
    if (!data.staticsChanged && data.statics) {
        return;
    }
    auto geometry = std::make_shared<StaticGeometry>();
    collectParts(data, *geometry);
    join(*geometry);
    for (BodyRecord& record : data.records) {
        record.bounds = record.kind == BodyKind::Static ? Aabb{} : record.bounds;
    }
    std::vector<Aabb> boxes;
    for (const StaticGeometry::Collider& collider : geometry->colliders) {
        boxes.push_back(treeBox(collider));
        data.records[collider.body].bounds.include(boxes.back());
    }
    geometry->tree = StaticQuadtree(std::move(boxes));
    data.statics = std::move(geometry);
    data.staticsChanged = false;
    renewSleepingPairs(data);
    data.pairsStale = true;
}

} // namespace spacetow
