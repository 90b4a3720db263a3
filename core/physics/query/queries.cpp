#include "core/physics/query/queries.h"

#include "core/geometry/bounds.h"
#include "core/geometry/cast.h"
#include "core/geometry/closest.h"
#include "core/physics/broad_phase/statics.h"
#include "core/physics/state/world_data.h"

#include <algorithm>
#include <tuple>
#include <type_traits>

namespace spacetow {

namespace {

constexpr double rounding = 1e-6; // m: so much further candidates are looked for

/// Whether the static tree shows the static bodies as they are.
bool isTreeFresh(const BroadPhase& broadPhase, const StepFlags& flags) {
    return broadPhase.statics != nullptr && !flags.staticsChanged;
}

/// A part and what decides between equal answers: the first part of the first body.
struct Candidate {
    Slot body;
    std::uint32_t part;
    const Part& shape;
    Transform pose;
    std::uint64_t serial;
};

template <class Visit>
void visitPart(const Bodies& bodies, Slot slot, std::uint32_t part, const Visit& visit) {
    const BodyRecord& record = bodies.records[slot];
    visit(Candidate{slot, part, (*record.parts)[part], bodies.pose(slot), record.serial});
}

/// Calls `visit(candidate)` for the parts of active bodies that may reach into the area, in no order that matters.
template <class Visit>
void forEachPartNear(const WorldData& data, const Aabb& area, const Visit& visit) {
    const bool fresh = isTreeFresh(data.broadPhase, data.flags);
    if (fresh) {
        std::vector<std::uint32_t> found;
        findStaticShapes(data.broadPhase, area, found);
        for (const std::uint32_t i : found) {
            const StaticGeometry::Collider& collider = data.broadPhase.staticCollider(i);
            visitPart(data.bodies, collider.body, collider.part, visit);
        }
    }
    const bool listed = fresh && data.bodies.changedBodies.empty(); // else there is nothing to go by but all bodies
    const std::size_t count = listed ? data.bodies.nonStatic.size() : data.bodies.records.size();
    for (std::size_t i = 0; i < count; ++i) {
        const Slot slot = listed ? data.bodies.nonStatic[i] : static_cast<Slot>(i);
        const BodyRecord& record = data.bodies.records[slot];
        const bool inTree = fresh && record.kind == BodyKind::Static;
        if (!record.used || !record.active || inTree ||
            !area.grown(record.outerRadius).contains(data.bodies.motions[slot].center)) {
            continue;
        }
        for (std::uint32_t part = 0; part < record.parts->size(); ++part) {
            visitPart(data.bodies, slot, part, visit);
        }
    }
}

/// In the order in which they were added, each once.
std::vector<BodyId> inOrder(const Bodies& bodies, std::vector<Slot>& slots) {
    std::sort(slots.begin(), slots.end(),
              [&](Slot a, Slot b) { return bodies.records[a].serial < bodies.records[b].serial; });
    slots.erase(std::unique(slots.begin(), slots.end()), slots.end());
    std::vector<BodyId> ids;
    ids.reserve(slots.size());
    for (const Slot slot : slots) {
        ids.push_back(bodies.idOf(slot));
    }
    return ids;
}

Aabb exactBounds(const Bodies& bodies, Slot slot) {
    Aabb box;
    for (const Part& part : *bodies.records[slot].parts) {
        box.include(boundsOf(part, bodies.pose(slot)));
    }
    return box;
}

template <class Visit>
void forEachTree(const BroadPhase& broadPhase, const Visit& visit) {
    if (broadPhase.statics) {
        visit(broadPhase.statics->tree);
    }
    if (broadPhase.staticChanges) {
        visit(broadPhase.staticChanges->geometry.tree);
    }
    visit(broadPhase.tree);
}

/// Nearest among what reaches into the square of `reach` metres around the point.
std::optional<NearestPoint> closestWithin(const WorldData& data, const Vec2& point, double reach, TagMask mask) {
    std::optional<NearestPoint> best;
    std::uint64_t serial = 0;
    const Aabb area = Aabb{point, point}.grown(reach + rounding);
    forEachPartNear(data, area, [&](const Candidate& candidate) {
        if (!data.bodies.records[candidate.body].filter.tags.intersects(mask)) {
            return;
        }
        const Vec2 on = closestPoint(candidate.shape, candidate.pose, point);
        const double distance = (on - point).norm();
        const bool nearer = !best || std::tie(distance, candidate.serial) < std::tie(best->distance, serial);
        if (distance <= reach && nearer) {
            best = NearestPoint{data.bodies.idOf(candidate.body), on, distance};
            serial = candidate.serial;
        }
    });
    return best;
}

} // namespace

std::optional<RayHit> rayCast(const World& world, const Vec2& from, const Vec2& to, TagMask mask) {
    const WorldData& data = world.data();
    std::optional<RayHit> best;
    std::pair<std::uint64_t, std::uint32_t> bestPart;
    Aabb area{from, from};
    area.include(to);
    forEachPartNear(data, area.grown(rounding), [&](const Candidate& candidate) {
        if (!data.bodies.records[candidate.body].filter.tags.intersects(mask)) {
            return;
        }
        const auto hit = rayCast(candidate.shape, candidate.pose, from, to);
        const std::pair part(candidate.serial, candidate.part);
        if (hit && (!best || std::tie(hit->fraction, part) < std::tie(best->fraction, bestPart))) {
            best = RayHit{data.bodies.idOf(candidate.body), from + hit->fraction * (to - from), hit->normal,
                          hit->fraction};
            bestPart = part;
        }
    });
    return best;
}

std::vector<BodyId> bodiesAt(const World& world, const Vec2& point) {
    const WorldData& data = world.data();
    std::vector<Slot> slots;
    forEachPartNear(data, Aabb{point, point}.grown(rounding), [&](const Candidate& candidate) {
        if (contains(candidate.shape, candidate.pose, point)) {
            slots.push_back(candidate.body);
        }
    });
    return inOrder(data.bodies, slots);
}

std::vector<BodyId> bodiesIn(const World& world, const Aabb& box) {
    const WorldData& data = world.data();
    const bool fresh = isTreeFresh(data.broadPhase, data.flags);
    std::vector<Slot> slots;
    for (Slot slot = 0; slot < data.bodies.records.size(); ++slot) {
        const BodyRecord& record = data.bodies.records[slot];
        const bool inTree = fresh && record.kind == BodyKind::Static;
        if (record.used && record.active && (inTree ? record.solid : exactBounds(data.bodies, slot)).overlaps(box)) {
            slots.push_back(slot);
        }
    }
    return inOrder(data.bodies, slots);
}

std::optional<NearestPoint> closestBody(const World& world, const Vec2& point, const SearchLimits& limits) {
    const WorldData& data = world.data();
    if (!isFinite(point) || !(limits.reach >= 0)) {
        return std::nullopt;
    }
    // Wider and wider, as long as nothing is found: most of what is asked for is near.
    for (double reach = 1; reach < limits.reach && reach < 1e12; reach *= 4) {
        if (auto found = closestWithin(data, point, reach, limits.mask)) {
            return found;
        }
    }
    return closestWithin(data, point, limits.reach, limits.mask);
}

std::vector<Aabb> quadtreeCells(const World& world) {
    std::vector<Aabb> cells;
    forEachTree(world.data().broadPhase, [&](const auto& tree) {
        const std::vector<Aabb> own = tree.cells();
        cells.insert(cells.end(), own.begin(), own.end());
    });
    return cells;
}

std::vector<QuadtreeCell> occupiedCells(const World& world, const std::optional<Aabb>& area) {
    std::vector<QuadtreeCell> cells;
    std::vector<std::uint32_t> found;
    forEachTree(world.data().broadPhase, [&](const auto& tree) {
        for (const Aabb& cell : tree.cells()) {
            if (area && !cell.overlaps(*area)) {
                continue;
            }
            found.clear();
            tree.query(cell, found);
            constexpr bool moves = std::is_same_v<std::decay_t<decltype(tree)>, MovingQuadtree>;
            cells.push_back({cell, static_cast<int>(found.size()), moves});
        }
    });
    return cells;
}

std::optional<std::uint32_t> islandOf(const World& world, BodyId body) {
    const WorldData& data = world.data();
    const BodyRecord& record = data.bodies.records[body.index];
    if (record.asleep) {
        return record.island;
    }
    const std::vector<Slot>& roots = data.contactGraph.roots;
    const bool isKnown = body.index < roots.size() && data.bodies.motions[body.index].isMovable() && record.active;
    return isKnown ? std::optional(roots[body.index]) : std::nullopt;
}

} // namespace spacetow
