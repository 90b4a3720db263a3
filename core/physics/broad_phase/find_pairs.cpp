#include "core/physics/broad_phase/find_pairs.h"

#include "core/base/prefetch.h"
#include "core/geometry/bounds.h"
#include "core/physics/broad_phase/separating_face.h"
#include "core/physics/broad_phase/statics.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace spacetow {

namespace {

/// Extended by the motion of the body, and by a margin in every direction.
FatAabb fatAabbAround(const BodyMotion& m, const BodyStep& s, double seconds) {
    const double speed = std::sqrt(m.velocity.squaredNorm());
    const double pull = std::sqrt(s.acceleration.squaredNorm());
    const double way = speed * seconds;
    const double pad = 0.05 * s.outerRadius + 0.02 + 0.1 * way + 0.5 * pull * seconds * seconds;
    FatAabb fat;
    fat.centers = {m.center, m.center};
    fat.centers.include(m.center + seconds * m.velocity);
    fat.centers.include(m.center + s.correction);
    fat.centers = fat.centers.grown(pad);
    const double turn = 1.5 * std::abs(m.angularVelocity) * seconds + 0.05;
    const bool anyTurn = s.isCircle || turn >= 1; // the box of its disc holds at every angle
    fat.angleLeft = anyTurn ? std::numeric_limits<double>::infinity() : turn;
    return fat;
}

Aabb fatBox(const BodyStep& s, const BodyMotion& m, const Part& part) {
    Aabb box = boundsOf(part, Transform{m.center, m.rotation});
    // The farthest point of the part sweeps an arc; great turns cover the disc around the centre of mass.
    if (!isRound(part)) {
        if (std::isinf(s.fat.angleLeft)) {
            const Vec2 r(s.outerRadius, s.outerRadius);
            box = {m.center - r, m.center + r};
        } else {
            box = box.grown(s.fat.angleLeft * s.outerRadius);
        }
    }
    box.min += s.fat.centers.min - m.center;
    box.max += s.fat.centers.max - m.center;
    return box.grown(linearSlop);
}

void listProxiesOf(WorldData& data, Slot slot) {
    data.firstProxies[slot] = static_cast<std::uint32_t>(data.proxies.size());
    const std::vector<Part>& parts = *data.records[slot].parts;
    for (std::uint32_t i = 0; i < parts.size(); ++i) {
        data.proxies.push_back({slot, i, isSlender(parts[i])});
    }
}

/// Visits the indices of a body's parts among the proxies, without reading its record.
template <class Visit>
void forProxiesOf(const WorldData& data, Slot slot, const Visit& visit) {
    for (std::uint32_t i = data.firstProxies[slot]; i < data.proxies.size() && data.proxies[i].body == slot; ++i) {
        visit(i);
    }
}

void add(WorldData& data, const MovingProxy& a, const MovingProxy& b) {
    const bool ordered = a.body < b.body;
    const MovingProxy& first = ordered ? a : b;
    const MovingProxy& second = ordered ? b : a;
    data.scratch.search.foundPairs.emplace_back(first.body, second.body, first.part, second.part);
}

/// Whether the box of another stays clear of a long part.
bool staysClear(const WorldData& data, const MovingProxy& of, const Aabb& box) {
    return of.slender && isInFrontOfFace(box, std::get<ConvexPart>((*data.records[of.body].parts)[of.part]),
                                         data.motions[of.body].rotation, data.steps[of.body].fat);
}

/// Whether no more are to be found.
bool isCrowded(WorldData& data) {
    const bool many = data.scratch.search.foundPairs.size() >= data.scratch.search.mostFound;
    data.flags.crowded |= many;
    return many;
}

void consider(WorldData& data, std::uint32_t index, std::uint32_t other) {
    const MovingProxy& a = data.proxies[index];
    const MovingProxy& b = data.proxies[other];
    if (a.body != b.body && !isCrowded(data) && !staysClear(data, a, data.boxes[other]) &&
        !staysClear(data, b, data.boxes[index])) {
        add(data, a, b);
    }
}

/// Of two moved proxies the later one finds the other.
bool isFoundBy(const WorldData& data, std::uint32_t index, std::uint32_t other) {
    return other < index || !data.proxies[other].movedProxy;
}

void findMovingOf(WorldData& data, std::uint32_t index) {
    if (isCrowded(data)) {
        return;
    }
    const Aabb& box = data.boxes[index];
    data.scratch.search.found.clear();
    data.tree.query(box, data.scratch.search.found);
    for (const std::uint32_t other : data.scratch.search.found) {
        if (!data.proxies[other].isStaleInTree && isFoundBy(data, index, other)) {
            consider(data, index, other);
        }
    }
    for (const std::uint32_t other : data.staleProxies) {
        if (data.boxes[other].overlaps(box) && isFoundBy(data, index, other)) {
            consider(data, index, other);
        }
    }
}

/// The tree has all where they are.
void findAllMoving(WorldData& data) {
    data.scratch.search.overlapping.clear();
    data.tree.queryAll(data.scratch.search.overlapping, data.scratch.search.mostFound);
    for (const auto& [a, b] : data.scratch.search.overlapping) {
        if (data.proxies[a].movedProxy || data.proxies[b].movedProxy) {
            consider(data, a, b);
        }
    }
}

void findStaticsOf(WorldData& data, std::uint32_t index) {
    findStatics(data, data.boxes[index], data.scratch.search.found);
    const MovingProxy& collider = data.proxies[index];
    for (const std::uint32_t other : data.scratch.search.found) {
        const StaticGeometry::Collider& wall = data.staticCollider(other);
        data.scratch.search.foundPairs.emplace_back(collider.body, wall.body, collider.part, wall.part);
    }
}

void markMovedProxies(WorldData& data, bool movedProxy) {
    for (const Slot slot : data.scratch.search.movedBodies) {
        forProxiesOf(data, slot, [&](std::uint32_t i) { data.proxies[i].movedProxy = movedProxy; });
    }
}

/// Proxies whose boxes are no longer what the tree has are searched one by one while they are few.
void refreshTree(WorldData& data) {
    const std::size_t count = data.boxes.size();
    for (const Slot slot : data.scratch.search.movedBodies) {
        forProxiesOf(data, slot, [&](std::uint32_t i) {
            if (!data.proxies[i].isStaleInTree) {
                data.proxies[i].isStaleInTree = true;
                data.staleProxies.push_back(i);
            }
        });
    }
    if (!data.flags.pairsStale && data.staleProxies.size() * data.scratch.search.movedBodies.size() <= 8 * count &&
        8 * data.staleProxies.size() <= count) {
        return;
    }
    data.tree.fill(data.boxes);
    for (const std::uint32_t i : data.staleProxies) {
        data.proxies[i].isStaleInTree = false;
    }
    data.staleProxies.clear();
}

void sortNearlySorted(std::span<FoundPair> pairs) {
    std::size_t moves = 0;
    for (std::size_t i = 1; i < pairs.size(); ++i) {
        const FoundPair pair = pairs[i];
        std::size_t k = i;
        for (; k > 0 && pair < pairs[k - 1]; --k) {
            pairs[k] = pairs[k - 1];
            ++moves;
        }
        pairs[k] = pair;
        if (moves > 16 * pairs.size()) { // not nearly
            std::sort(pairs.begin(), pairs.end());
            return;
        }
    }
}

/// By their first bodies in linear time, then the few of each body, which come nearly sorted.
void sortFound(WorldData& data) {
    if (4 * data.scratch.search.foundPairs.size() < data.records.size()) {
        std::sort(data.scratch.search.foundPairs.begin(), data.scratch.search.foundPairs.end());
        return;
    }
    std::vector<std::uint32_t>& ends = data.scratch.search.pairEnds;
    ends.assign(data.records.size() + 1, 0);
    for (const FoundPair& pair : data.scratch.search.foundPairs) {
        ++ends[pair.bodyA + 1];
    }
    for (std::size_t i = 1; i < ends.size(); ++i) {
        ends[i] += ends[i - 1];
    }
    data.scratch.search.sortedPairs.resize(data.scratch.search.foundPairs.size());
    for (const FoundPair& pair : data.scratch.search.foundPairs) {
        data.scratch.search.sortedPairs[ends[pair.bodyA]++] = pair;
    }
    for (std::size_t i = 0, first = 0; i + 1 < ends.size(); first = ends[i++]) {
        sortNearlySorted(std::span(data.scratch.search.sortedPairs).subspan(first, ends[i] - first));
    }
    data.scratch.search.foundPairs.swap(data.scratch.search.sortedPairs);
}

} // namespace

void listProxies(WorldData& data) {
    data.proxies.clear();
    data.firstProxies.resize(data.records.size());
    data.scratch.search.movedBodies = data.moving;
    for (const Slot slot : data.moving) {
        listProxiesOf(data, slot);
    }
    for (const Slot slot : data.sleep.sleepers) {
        listProxiesOf(data, slot);
    }
    data.boxes.assign(data.proxies.size(), Aabb{});
    for (const Slot slot : data.sleep.sleepers) {
        std::uint32_t i = data.firstProxies[slot];
        for (const Part& part : *data.records[slot].parts) {
            data.boxes[i++] = fatBox(data.steps[slot], data.motions[slot], part);
        }
    }
    data.staleProxies.clear();
}

void enlargeAabbs(WorldData& data, double seconds) {
    constexpr std::size_t ahead = 4;
    for (std::size_t k = 0; k < data.scratch.search.movedBodies.size(); ++k) {
        if (k + ahead < data.scratch.search.movedBodies.size()) {
            prefetch(data.records[data.scratch.search.movedBodies[k + ahead]].parts);
            prefetch(data.records[data.scratch.search.movedBodies[k + ahead]].bounds);
        }
        const Slot slot = data.scratch.search.movedBodies[k];
        BodyStep& s = data.steps[slot];
        BodyRecord& record = data.records[slot];
        s.fat = fatAabbAround(data.motions[slot], s, seconds);
        record.bounds = Aabb{};
        std::uint32_t i = data.firstProxies[slot];
        for (const Part& part : *record.parts) {
            data.boxes[i] = fatBox(s, data.motions[slot], part);
            record.bounds.include(data.boxes[i++]);
        }
    }
}

std::size_t mostPairs(const WorldData& data) {
    return (std::size_t{1} << 18) + 64 * data.proxies.size();
}

void collectPairs(WorldData& data) {
    data.scratch.search.mostFound =
        mostPairs(data) - (data.flags.pairsStale ? 0 : std::min(data.table.size(), mostPairs(data)) / 2);
    refreshTree(data);
    markMovedProxies(data, true);
    data.scratch.search.foundPairs.clear();
    const bool most = data.staleProxies.empty() && 2 * data.scratch.search.movedBodies.size() > data.moving.size();
    if (most) {
        findAllMoving(data);
    }
    for (const Slot slot : data.scratch.search.movedBodies) {
        forProxiesOf(data, slot, [&](std::uint32_t i) {
            if (!most) {
                findMovingOf(data, i);
            }
            findStaticsOf(data, i);
        });
    }
    markMovedProxies(data, false);
    sortFound(data);
}

} // namespace spacetow
