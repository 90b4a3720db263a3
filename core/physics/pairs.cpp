#include "core/physics/pairs.h"

#include "core/geometry/bounds.h"
#include "core/geometry/convex_parts.h"
#include "core/geometry/moved.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace spacetow {

namespace {

Part partInWorld(const Part& part, const Transform& pose) {
    return std::visit([&pose](const auto& p) -> Part { return moved(p, pose); }, part);
}

Aabb staticBox(const Part& part) {
    const Aabb box = boundsOf(part, Transform{});
    return std::holds_alternative<WallPart>(part) ? enlargedEdgeBounds(box) : box;
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
}

void buildStatics(WorldData& data) {
    auto geometry = std::make_shared<StaticGeometry>();
    for (Slot slot = 0; slot < data.records.size(); ++slot) {
        BodyRecord& record = data.records[slot];
        if (!record.used || record.kind != BodyKind::Static || !record.active || !record.parts) {
            continue;
        }
        record.firstStatic = static_cast<std::uint32_t>(geometry->colliders.size());
        for (std::uint32_t i = 0; i < record.parts->size(); ++i) {
            geometry->colliders.push_back({slot, i, partInWorld((*record.parts)[i], data.pose(slot))});
        }
    }
    join(*geometry);
    std::vector<Aabb> boxes;
    for (BodyRecord& record : data.records) {
        record.bounds = record.kind == BodyKind::Static ? Aabb{} : record.bounds;
    }
    for (const StaticGeometry::Collider& collider : geometry->colliders) {
        boxes.push_back(staticBox(collider.shape));
        data.records[collider.body].bounds.include(boxes.back());
    }
    geometry->tree = StaticQuadtree(std::move(boxes));
    data.statics = std::move(geometry);
    data.staticsChanged = false;
}

/// How far the centre may stray from where it is now, and how far the body may turn, before the pairs must be found
/// again. Slow bodies get room in every direction, because a bounce may send them anywhere.
void planRoom(BodyRecord& record, const BodyMotion& m, const BodyStep& s, double seconds) {
    const double speed = std::sqrt(m.velocity.squaredNorm());
    const double pull = std::sqrt(s.acceleration.squaredNorm());
    const double way = speed * seconds;
    const double pad = 0.05 * record.outerRadius + 0.005 + 0.5 * pull * seconds * seconds;
    record.centerBox = {m.center, m.center};
    if (way > record.outerRadius) {
        record.centerBox.include(m.center + seconds * m.velocity);
        record.centerBox = record.centerBox.grown(pad);
    } else {
        record.centerBox = record.centerBox.grown(pad + way);
    }
    const double turn = 1.5 * std::abs(m.angularVelocity) * seconds + 0.05;
    record.turnLeft = turn < 1 ? turn : std::numeric_limits<double>::infinity(); // its disc has room for every turn
}

Aabb roomyBox(const BodyRecord& record, const BodyMotion& m, const Part& part) {
    Aabb box = boundsOf(part, Transform{m.center, m.rotation});
    // The farthest point of the part sweeps an arc; great turns cover the disc around the centre of mass.
    const auto* circle = std::get_if<Circle>(&part);
    const bool round = circle != nullptr && circle->center.x() == 0 && circle->center.y() == 0;
    if (!round) {
        if (std::isinf(record.turnLeft)) {
            const Vec2 r(record.outerRadius, record.outerRadius);
            box = {m.center - r, m.center + r};
        } else {
            box = box.grown(record.turnLeft * record.outerRadius);
        }
    }
    box.min += record.centerBox.min - m.center;
    box.max += record.centerBox.max - m.center;
    return box.grown(linearSlop);
}

bool connectedApart(const WorldData& data, Slot a, Slot b) {
    return !data.notColliding.empty() &&
           std::binary_search(data.notColliding.begin(), data.notColliding.end(), SlotPair(std::minmax(a, b)));
}

bool mayMeet(const WorldData& data, Slot a, Slot b) {
    const BodyRecord& ra = data.records[a];
    const BodyRecord& rb = data.records[b];
    const bool oneMoves = ra.kind == BodyKind::Dynamic || rb.kind == BodyKind::Dynamic;
    const bool oneFeels = !ra.tangible || !rb.tangible;
    return a != b && (oneMoves || oneFeels) && mayTouch(ra.filter, rb.filter) && !connectedApart(data, a, b);
}

Pair makePair(const WorldData& data, Slot a, std::uint32_t partA, Slot b, std::uint32_t partB) {
    const BodyRecord& ra = data.records[a];
    const BodyRecord& rb = data.records[b];
    Pair pair;
    pair.staticB = rb.kind == BodyKind::Static;
    if (!pair.staticB && b < a) {
        return makePair(data, b, partB, a, partA);
    }
    pair.bodyA = a;
    pair.bodyB = b;
    pair.partA = partA;
    pair.partB = partB;
    pair.shapeA = &(*ra.parts)[partA];
    pair.shapeB = pair.staticB ? &data.statics->colliders[rb.firstStatic + partB].shape : &(*rb.parts)[partB];
    pair.solid = ra.tangible && rb.tangible && (ra.kind == BodyKind::Dynamic || rb.kind == BodyKind::Dynamic);
    return pair;
}

void collectMoving(WorldData& data, double seconds) {
    data.colliders.clear();
    for (const Slot slot : data.moving) {
        BodyRecord& record = data.records[slot];
        planRoom(record, data.motions[slot], data.steps[slot], seconds);
        record.bounds = Aabb{};
        for (std::uint32_t i = 0; i < record.parts->size(); ++i) {
            const Aabb box = roomyBox(record, data.motions[slot], (*record.parts)[i]);
            data.colliders.push_back({slot, i, box});
            record.bounds.include(box);
        }
    }
}

/// Both lists are sorted: what stays keeps its impulses.
void carryOver(const std::vector<Pair>& old, std::vector<Pair>& pairs) {
    auto from = old.begin();
    for (Pair& pair : pairs) {
        while (from != old.end() && *from < pair) {
            ++from;
        }
        if (from == old.end()) {
            break;
        }
        if (!(pair < *from)) {
            pair.count = from->count;
            pair.points = from->points;
            pair.touching = from->touching;
            pair.sweep = from->sweep;
        }
    }
}

} // namespace

void prepareStructure(WorldData& data) {
    if (data.staticsChanged || !data.statics) {
        buildStatics(data);
    }
    data.moving.clear();
    for (const BodyKind kind : {BodyKind::Kinematic, BodyKind::Dynamic}) {
        for (Slot slot = 0; slot < data.records.size(); ++slot) {
            const BodyRecord& record = data.records[slot];
            if (record.used && record.active && record.kind == kind) {
                data.moving.push_back(slot);
            }
        }
    }
}

void findPairs(WorldData& data, const IterationStep& step) {
    collectMoving(data, step.remaining);
    Aabb world;
    for (const MovingCollider& collider : data.colliders) {
        world.include(collider.box);
    }
    data.newPairs.clear();
    data.tree.reset(world, static_cast<std::uint32_t>(data.colliders.size()));
    for (std::uint32_t i = 0; i < data.colliders.size(); ++i) {
        const MovingCollider& collider = data.colliders[i];
        data.found.clear();
        data.tree.insertAndQuery(i, collider.box, data.found);
        for (const std::uint32_t other : data.found) {
            const MovingCollider& o = data.colliders[other];
            if (mayMeet(data, collider.body, o.body)) {
                data.newPairs.push_back(makePair(data, collider.body, collider.part, o.body, o.part));
            }
        }
        data.found.clear();
        data.statics->tree.query(collider.box, data.found);
        for (const std::uint32_t other : data.found) {
            const StaticGeometry::Collider& o = data.statics->colliders[other];
            if (mayMeet(data, collider.body, o.body)) {
                data.newPairs.push_back(makePair(data, collider.body, collider.part, o.body, o.part));
            }
        }
    }
    std::sort(data.newPairs.begin(), data.newPairs.end());
    carryOver(data.pairs, data.newPairs);
    data.pairs.swap(data.newPairs);
}

bool pairsCover(const WorldData& data) {
    for (const Slot slot : data.moving) {
        const BodyRecord& record = data.records[slot];
        const BodyStep& s = data.steps[slot];
        const Vec2& center = data.motions[slot].center;
        if (!record.centerBox.contains(center) || !record.centerBox.contains(Vec2(center + s.shift)) ||
            std::abs(s.turn) > record.turnLeft) {
            return false;
        }
    }
    return true;
}

} // namespace spacetow
