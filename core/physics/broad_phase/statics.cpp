#include "core/physics/broad_phase/statics.h"

#include "core/physics/broad_phase/static_parts.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace spacetow {

namespace {

/// Sleeping pairs get the new colliders of static bodies.
void refreshSleepingPairs(const Bodies& bodies, const BroadPhase& broadPhase, PairTable& asleep) {
    for (Pair& pair : asleep.pairs) {
        if (pair.staticB) {
            pair.collider = staticIndex(bodies, broadPhase, pair.bodyB, pair.partB);
            pair.shapeB = &broadPhase.staticCollider(pair.collider).shape;
        }
    }
}

void rebuildStatics(Bodies& bodies, BroadPhase& broadPhase) {
    auto geometry = std::make_shared<StaticGeometry>();
    std::size_t count = 0;
    for (const BodyRecord& record : bodies.records) {
        count += isActiveStatic(record) ? record.parts->size() : 0;
    }
    geometry->colliders.reserve(count);
    for (Slot slot = 0; slot < bodies.records.size(); ++slot) {
        BodyRecord& record = bodies.records[slot];
        if (record.kind == BodyKind::Static) {
            record.bounds = Aabb{};
        }
        if (isActiveStatic(record)) {
            record.firstStatic = static_cast<std::uint32_t>(geometry->colliders.size());
            for (std::uint32_t i = 0; i < record.parts->size(); ++i) {
                geometry->colliders.push_back(staticColliderOf(bodies, slot, i));
            }
        }
    }
    joinStatics(*geometry);
    noteStaticBounds(bodies, geometry->colliders);
    buildStaticTrees(*geometry);
    broadPhase.statics = std::move(geometry);
    broadPhase.staticChanges = nullptr;
}

/// Appends the deep edges whose solid region behind the segment overlaps the box.
void findBehind(const StaticGeometry& geometry, const Aabb& box, std::vector<std::uint32_t>& out) {
    const std::size_t first = out.size();
    geometry.backs.query(box, out);
    const auto begin = out.begin() + static_cast<std::ptrdiff_t>(first);
    out.erase(std::remove_if(begin, out.end(),
                             [&](std::uint32_t i) {
                                 const StaticGeometry::Collider& collider = geometry.colliders[i];
                                 return std::isfinite(std::get<WallPart>(collider.shape).depth) &&
                                        !collider.bounds.overlaps(box);
                             }),
              out.end());
}

} // namespace

void refreshStatics(Bodies& bodies, BroadPhase& broadPhase, PairTable& asleep, StepFlags& flags) {
    if (!flags.staticsChanged && broadPhase.statics) {
        return;
    }
    if (!broadPhase.statics || !patchStatics(bodies, broadPhase)) {
        rebuildStatics(bodies, broadPhase);
    }
    broadPhase.changedStatics.clear();
    flags.staticsChanged = false;
    refreshSleepingPairs(bodies, broadPhase, asleep);
    flags.pairsStale = true;
}

std::uint32_t staticIndex(const Bodies& bodies, const BroadPhase& broadPhase, Slot body, std::uint32_t part) {
    if (broadPhase.staticChanges) {
        const std::vector<StaticGeometry::Collider>& changed = broadPhase.staticChanges->geometry.colliders;
        const std::pair key(body, part);
        const auto at = std::lower_bound(changed.begin(), changed.end(), key, [](const auto& collider, const auto& k) {
            return std::pair(collider.body, collider.part) < k;
        });
        if (at != changed.end() && std::pair(at->body, at->part) == key) {
            return static_cast<std::uint32_t>(broadPhase.statics->colliders.size() +
                                              static_cast<std::size_t>(at - changed.begin()));
        }
    }
    return bodies.records[body].firstStatic + part;
}

void findStatics(const BroadPhase& broadPhase, const Aabb& box, std::vector<std::uint32_t>& out) {
    const auto find = [&](const StaticGeometry& geometry) {
        geometry.tree.query(box, out);
        findBehind(geometry, box, out);
    };
    out.clear();
    find(*broadPhase.statics);
    if (!broadPhase.staticChanges) {
        return;
    }
    const std::vector<std::uint32_t>& gone = broadPhase.staticChanges->gone;
    std::erase_if(out, [&](std::uint32_t i) { return std::binary_search(gone.begin(), gone.end(), i); });
    const std::size_t first = out.size();
    find(broadPhase.staticChanges->geometry);
    for (std::size_t i = first; i < out.size(); ++i) { // see BroadPhase::staticCollider
        out[i] += static_cast<std::uint32_t>(broadPhase.statics->colliders.size());
    }
}

} // namespace spacetow
