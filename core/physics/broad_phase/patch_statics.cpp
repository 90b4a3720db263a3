// Patches the static geometry when few bodies have changed: StaticChanges gets their parts, and the parts that are or
// were joined to them. These replace the outdated colliders of the full geometry.

#include "core/base/sort_unique.h"
#include "core/physics/broad_phase/static_parts.h"

#include <algorithm>

namespace spacetow {

namespace {

// Corners further apart than this are not joined, m. Larger than jointTolerance, so that rounding cannot matter.
constexpr double jointReach = 1e-3;

using Indices = std::vector<std::uint32_t>; // of colliders of the full geometry, sorted

/// A part of a static body.
struct PartOf {
    Slot body = 0;
    std::uint32_t part = 0;
    bool replaces = false; // false: needed for the joints of other parts only

    bool operator<(const PartOf& o) const { return body != o.body ? body < o.body : part < o.part; }
};

/// The limit on changed parts. A patch is rebuilt with each change, the full geometry costs some µs a part: with a
/// limit of a sixty-fourth, rebuilding the full geometry is a small part of the whole cost.
std::size_t mostChanged(const StaticGeometry& all) {
    constexpr std::size_t share = 64;
    constexpr std::size_t least = 64;
    return std::max(all.colliders.size() / share, least);
}

bool has(const Indices& indices, std::uint32_t index) {
    return std::binary_search(indices.begin(), indices.end(), index);
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

/// Appends the colliders that have a corner near a corner of the part.
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

/// The colliders of these bodies in the full geometry.
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

/// `found` without the elements of the other two.
Indices without(Indices found, const Indices& some, const Indices& others) {
    sortUnique(found);
    std::erase_if(found, [&](std::uint32_t i) { return has(some, i) || has(others, i); });
    return found;
}

/// The parts of these bodies as they are now, in world coordinates.
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

/// The colliders of `parts` with their joints. `parts` contains every part that is joined to a replaced one, so that
/// the joints equal those of a rebuilt full geometry; parts that replace nothing are left out of the result.
StaticGeometry joinedGeometry(const Bodies& bodies, std::vector<PartOf> parts) {
    std::sort(parts.begin(), parts.end());
    StaticGeometry geometry;
    for (const PartOf& part : parts) {
        geometry.colliders.push_back(staticColliderOf(bodies, part.body, part.part));
    }
    joinStatics(geometry);
    std::size_t kept = 0;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        if (parts[i].replaces) {
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

/// The extent of a patch.
struct Patch {
    std::vector<StaticGeometry::Collider> own; // parts of the changed bodies as they are now
    Indices former;                            // colliders of the changed bodies in the full geometry
    Indices joined;                            // other colliders that may be joined to one of these

    std::size_t size() const { return own.size() + former.size() + joined.size(); }
};

/// The geometry of a patch. The parts joined to `joined` are needed for the choice of joints: see joinWalls().
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
