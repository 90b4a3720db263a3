#include "core/physics/broad_phase/static_parts.h"

#include "core/geometry/bounds.h"
#include "core/geometry/convex_parts.h"
#include "core/geometry/moved.h"

namespace spacetow {

namespace {

/// Whether the depth is greater than the length: most of the AABB would be behind the wall.
bool isDeepWall(const Part& part) {
    const auto* wall = std::get_if<WallPart>(&part);
    return wall != nullptr && wall->oneWay && wall->depth > 0 &&
           wall->depth * wall->depth > (wall->b - wall->a).squaredNorm();
}

/// The bounds of a collider extended behind hollow joints, as the face of an edge also covers the gap behind the joint.
Aabb searchBounds(const StaticGeometry::Collider& collider) {
    Aabb box = collider.bounds;
    const WallSide& side = collider.side;
    const auto* wall = std::get_if<WallPart>(&collider.shape);
    for (const WallEnd* end : {&side.start, &side.end}) {
        if (wall != nullptr && wall->oneWay && end->kind == WallEnd::Kind::Smooth) {
            const Vec2 middle = side.middleOf(*end);
            box.include(end->point - side.depthBehind(middle) * middle);
        }
    }
    return box;
}

Aabb segmentBox(const WallPart& wall) {
    Aabb box{wall.a, wall.a};
    box.include(wall.b);
    return box;
}

} // namespace

bool isActiveStatic(const BodyRecord& record) {
    return record.used && record.kind == BodyKind::Static && record.active;
}

StaticGeometry::Collider staticColliderOf(const Bodies& bodies, Slot body, std::uint32_t part) {
    const Transform pose = bodies.pose(body);
    const Part inWorld =
        std::visit([&pose](const auto& p) -> Part { return moved(p, pose); }, (*bodies.records[body].parts)[part]);
    return {body, part, inWorld, boundsOf(inWorld, Transform{}), {}};
}

void joinStatics(StaticGeometry& geometry) {
    std::vector<Part*> parts;
    parts.reserve(geometry.colliders.size());
    for (StaticGeometry::Collider& collider : geometry.colliders) {
        parts.push_back(&collider.shape);
    }
    joinParts(parts);
    for (StaticGeometry::Collider& collider : geometry.colliders) {
        if (const auto* wall = std::get_if<WallPart>(&collider.shape); wall != nullptr && wall->oneWay) {
            collider.side = sideOf(*wall, false);
        }
    }
}

void buildStaticTrees(StaticGeometry& geometry) {
    std::vector<Aabb> boxes;
    std::vector<WallBackTree::Item> backs;
    boxes.reserve(geometry.colliders.size());
    for (const StaticGeometry::Collider& collider : geometry.colliders) {
        if (isDeepWall(collider.shape)) {
            const Aabb box = segmentBox(std::get<WallPart>(collider.shape));
            backs.push_back({static_cast<std::uint32_t>(boxes.size()), backOf(collider.side), box});
            boxes.push_back(box);
        } else {
            boxes.push_back(searchBounds(collider));
        }
    }
    geometry.tree = StaticQuadtree(std::move(boxes));
    geometry.backs = WallBackTree(std::move(backs));
}

void noteStaticBounds(Bodies& bodies, std::span<const StaticGeometry::Collider> colliders) {
    for (const StaticGeometry::Collider& collider : colliders) {
        BodyRecord& record = bodies.records[collider.body];
        const bool wall = std::holds_alternative<WallPart>(collider.shape);
        record.bounds.include(wall ? enlargedEdgeBounds(collider.bounds) : collider.bounds);
    }
}

} // namespace spacetow
