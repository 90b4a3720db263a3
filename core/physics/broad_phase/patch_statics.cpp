// A few static bodies have changed. Their parts, and those that are or were joined to them, are made anew and shadow
// what the geometry of all has of them.

#include "core/physics/broad_phase/static_parts.h"

#include <algorithm>

namespace spacetow {

namespace {

// Parts may be joined where corners are no further apart, m; a little more than any joint needs.
constexpr double jointReach = 1e-3;

using Indices = std::vector<std::uint32_t>; // of colliders of all, sorted

/// A part of a static body.
struct PartOf {
    Slot body = 0;
    std::uint32_t part = 0;
    bool shadows = false; // else it is here for the joints only that others have with it

    bool operator<(const PartOf& o) const { return body != o.body ? body < o.body : part < o.part; }
};

/// So many parts may have changed; making all anew, which costs some µs a part, is then long paid for.
std::size_t mostChanged(const StaticGeometry& all) {
    return std::max<std::size_t>(all.colliders.size() / 64, 64);
}

bool has(const Indices& indices, std::uint32_t index) {
    return std::binary_search(indices.begin(), indices.end(), index);
}

void sortUnique(Indices& indices) {
    std::sort(indices.begin(), indices.end());
    indices.erase(std::unique(indices.begin(), indices.end()), indices.end());
}

template <class Visit>
void forCorners(const Part& part, const Visit& visit) {
    if (const auto* wall = std::get_if<WallPart>(&part)) {
        visit(wall->a);
        visit(wall->b);
    } else if (const auto* convex = std::get_if<ConvexPart>(&part)) {
        for (int i = 0; i < convex->count; ++i) {
            visit(convex->corners[static_cast<std::size_t>(i)]);
        }
    }
}

/// What of all may be joined to this part.
void findJoined(const StaticGeometry& all, const Part& part, Indices& out) {
    Indices near;
    forCorners(part, [&](const Vec2& p) {
        const Aabb around = Aabb{p, p}.grown(jointReach);
        near.clear();
        all.tree.query(around, near);
        for (const std::uint32_t i : near) {
            bool joined = false;
            forCorners(all.colliders[i].shape, [&](const Vec2& q) { joined |= around.contains(q); });
            if (joined) {
                out.push_back(i);
            }
        }
    });
}

std::vector<Slot> changedBodies(const BroadPhase& broadPhase) {
    std::vector<Slot> slots = broadPhase.changedStatics;
    if (broadPhase.staticChanges) {
        slots.insert(slots.end(), broadPhase.staticChanges->bodies.begin(), broadPhase.staticChanges->bodies.end());
    }
    sortUnique(slots);
    return slots;
}

bool isActiveStatic(const BodyRecord& record) {
    return record.used && record.kind == BodyKind::Static && record.active;
}

/// What all has of these bodies.
Indices collidersOf(const StaticGeometry& all, const std::vector<Slot>& slots) {
    Indices indices;
    for (const Slot body : slots) {
        const auto first =
            std::lower_bound(all.colliders.begin(), all.colliders.end(), body,
                             [](const StaticGeometry::Collider& collider, Slot slot) { return collider.body < slot; });
        for (auto at = first; at != all.colliders.end() && at->body == body; ++at) {
            indices.push_back(static_cast<std::uint32_t>(at - all.colliders.begin()));
        }
    }
    return indices;
}

/// Those of `found` that are in none of the others.
Indices without(Indices found, const Indices& some, const Indices& others) {
    sortUnique(found);
    std::erase_if(found, [&](std::uint32_t i) { return has(some, i) || has(others, i); });
    return found;
}

/// The parts of these bodies as they are now, with their places in the world.
std::vector<StaticGeometry::Collider> partsOfBodies(const Bodies& bodies, const std::vector<Slot>& slots) {
    std::vector<StaticGeometry::Collider> colliders;
    for (const Slot body : slots) {
        const BodyRecord& record = bodies.records[body];
        for (std::uint32_t i = 0; isActiveStatic(record) && i < record.parts->size(); ++i) {
            colliders.push_back(staticColliderOf(bodies, body, i));
        }
    }
    return colliders;
}

/// All that is needed for joints that are those of all made anew: what changes, and what that is joined to.
StaticGeometry joinedGeometry(const Bodies& bodies, std::vector<PartOf> parts) {
    std::sort(parts.begin(), parts.end());
    StaticGeometry geometry;
    for (const PartOf& part : parts) {
        geometry.colliders.push_back(staticColliderOf(bodies, part.body, part.part));
    }
    joinStatics(geometry);
    std::size_t kept = 0;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        if (parts[i].shadows) {
            geometry.colliders[kept++] = geometry.colliders[i];
        }
    }
    geometry.colliders.erase(geometry.colliders.begin() + static_cast<std::ptrdiff_t>(kept), geometry.colliders.end());
    buildStaticTrees(geometry);
    return geometry;
}

std::size_t partsIn(const Bodies& bodies, const std::vector<Slot>& slots) {
    std::size_t count = 0;
    for (const Slot body : slots) {
        count += isActiveStatic(bodies.records[body]) ? bodies.records[body].parts->size() : 0;
    }
    return count;
}

/// A patch as it comes about.
struct Patch {
    std::vector<StaticGeometry::Collider> own; // parts of the bodies that have changed, as they are now
    Indices former;                            // as they were
    Indices joined;                            // to either, and changed thereby

    std::size_t size() const { return own.size() + former.size() + joined.size(); }
};

/// With what else is joined to what changes, which has a say in that.
StaticGeometry geometryOf(const Bodies& bodies, const BroadPhase& broadPhase, const Patch& patch) {
    const StaticGeometry& all = *broadPhase.statics;
    std::vector<PartOf> parts;
    for (const StaticGeometry::Collider& collider : patch.own) {
        parts.push_back({collider.body, collider.part, true});
    }
    for (const std::uint32_t i : patch.joined) {
        parts.push_back({all.colliders[i].body, all.colliders[i].part, true});
    }
    Indices others;
    for (const std::uint32_t i : patch.joined) {
        findJoined(all, all.colliders[i].shape, others);
    }
    for (const std::uint32_t i : without(std::move(others), patch.former, patch.joined)) {
        parts.push_back({all.colliders[i].body, all.colliders[i].part, false});
    }
    return joinedGeometry(bodies, std::move(parts));
}

void updateBounds(Bodies& bodies, const std::vector<Slot>& slots, const Patch& patch) {
    for (const Slot body : slots) {
        if (bodies.records[body].kind == BodyKind::Static) {
            bodies.records[body].bounds = Aabb{};
        }
    }
    noteStaticBounds(bodies, patch.own);
}

} // namespace

bool patchStatics(Bodies& bodies, BroadPhase& broadPhase) {
    const StaticGeometry& all = *broadPhase.statics;
    const std::size_t most = mostChanged(all);
    if (broadPhase.changedStatics.empty() || broadPhase.changedStatics.size() > most) {
        return false;
    }
    auto changes = std::make_shared<StaticChanges>();
    changes->bodies = changedBodies(broadPhase);
    Patch patch;
    patch.former = collidersOf(all, changes->bodies);
    if (patch.former.size() + partsIn(bodies, changes->bodies) > most) {
        return false;
    }
    patch.own = partsOfBodies(bodies, changes->bodies);
    Indices found;
    for (const StaticGeometry::Collider& collider : patch.own) {
        findJoined(all, collider.shape, found);
    }
    for (const std::uint32_t i : patch.former) {
        findJoined(all, all.colliders[i].shape, found);
    }
    patch.joined = without(std::move(found), patch.former, {});
    if (patch.size() > most) {
        return false;
    }
    changes->geometry = geometryOf(bodies, broadPhase, patch);
    changes->gone = patch.former;
    changes->gone.insert(changes->gone.end(), patch.joined.begin(), patch.joined.end());
    std::sort(changes->gone.begin(), changes->gone.end());
    updateBounds(bodies, changes->bodies, patch);
    broadPhase.staticChanges = std::move(changes);
    return true;
}

} // namespace spacetow
