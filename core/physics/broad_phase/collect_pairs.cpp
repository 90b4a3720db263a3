#include "core/physics/broad_phase/collect_pairs.h"

#include "core/base/prefetch.h"
#include "core/geometry/bounds.h"
#include "core/physics/broad_phase/in_front.h"
#include "core/physics/broad_phase/statics.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace spacetow {

namespace {

/// Ahead for the way that the body goes, and some in every direction.
Room roomAround(const BodyMotion& m, const BodyStep& s, double seconds) {
    const double speed = std::sqrt(m.velocity.squaredNorm());
    const double pull = std::sqrt(s.acceleration.squaredNorm());
    const double way = speed * seconds;
    const double pad = 0.05 * s.outerRadius + 0.02 + 0.1 * way + 0.5 * pull * seconds * seconds;
    Room room;
    room.centers = {m.center, m.center};
    room.centers.include(m.center + seconds * m.velocity);
    room.centers = room.centers.grown(pad);
    const double turn = 1.5 * std::abs(m.angularVelocity) * seconds + 0.05;
    const bool anyTurn = s.round || turn >= 1; // its disc has room for every turn
    room.turnLeft = anyTurn ? std::numeric_limits<double>::infinity() : turn;
    return room;
}

Aabb roomyBox(const BodyStep& s, const BodyMotion& m, const Part& part) {
    Aabb box = boundsOf(part, Transform{m.center, m.rotation});
    // The farthest point of the part sweeps an arc; great turns cover the disc around the centre of mass.
    if (!isRound(part)) {
        if (std::isinf(s.room.turnLeft)) {
            const Vec2 r(s.outerRadius, s.outerRadius);
            box = {m.center - r, m.center + r};
        } else {
            box = box.grown(s.room.turnLeft * s.outerRadius);
        }
    }
    box.min += s.room.centers.min - m.center;
    box.max += s.room.centers.max - m.center;
    return box.grown(linearSlop);
}

void listCollidersOf(WorldData& data, Slot slot) {
    data.firstColliders[slot] = static_cast<std::uint32_t>(data.colliders.size());
    const std::vector<Part>& parts = *data.records[slot].parts;
    for (std::uint32_t i = 0; i < parts.size(); ++i) {
        data.colliders.push_back({slot, i, isSlender(parts[i])});
    }
}

/// Visits the indices of a body's parts among the colliders, without a look at its record.
template <class Visit>
void forCollidersOf(const WorldData& data, Slot slot, const Visit& visit) {
    for (std::uint32_t i = data.firstColliders[slot]; i < data.colliders.size() && data.colliders[i].body == slot;
         ++i) {
        visit(i);
    }
}

void add(WorldData& data, const MovingCollider& a, const MovingCollider& b) {
    const bool ordered = a.body < b.body;
    const MovingCollider& first = ordered ? a : b;
    const MovingCollider& second = ordered ? b : a;
    data.foundPairs.emplace_back(first.body, second.body, first.part, second.part);
}

/// Whether the box of another stays clear of a long part.
bool staysClear(const WorldData& data, const MovingCollider& of, const Aabb& box) {
    return of.slender && staysInFront(box, std::get<ConvexPart>((*data.records[of.body].parts)[of.part]),
                                      data.motions[of.body].rotation, data.steps[of.body].room);
}

void consider(WorldData& data, std::uint32_t index, std::uint32_t other) {
    const MovingCollider& a = data.colliders[index];
    const MovingCollider& b = data.colliders[other];
    if (a.body != b.body && !staysClear(data, a, data.boxes[other]) && !staysClear(data, b, data.boxes[index])) {
        add(data, a, b);
    }
}

/// Of two that have both escaped, the later one finds the other.
bool isFoundBy(const WorldData& data, std::uint32_t index, std::uint32_t other) {
    return other < index || !data.colliders[other].escaped;
}

void findMovingOf(WorldData& data, std::uint32_t index) {
    const Aabb& box = data.boxes[index];
    data.found.clear();
    data.tree.query(box, data.found);
    for (const std::uint32_t other : data.found) {
        if (!data.colliders[other].astray && isFoundBy(data, index, other)) {
            consider(data, index, other);
        }
    }
    for (const std::uint32_t other : data.astray) {
        if (data.boxes[other].overlaps(box) && isFoundBy(data, index, other)) {
            consider(data, index, other);
        }
    }
}

/// The tree has all where they are.
void findAllMoving(WorldData& data) {
    data.overlapping.clear();
    data.tree.queryAll(data.overlapping);
    for (const auto& [a, b] : data.overlapping) {
        if (data.colliders[a].escaped || data.colliders[b].escaped) {
            consider(data, a, b);
        }
    }
}

void findStaticsOf(WorldData& data, std::uint32_t index) {
    findStatics(*data.statics, data.boxes[index], data.found);
    const MovingCollider& collider = data.colliders[index];
    for (const std::uint32_t other : data.found) {
        const StaticGeometry::Collider& wall = data.statics->colliders[other];
        data.foundPairs.emplace_back(collider.body, wall.body, collider.part, wall.part);
    }
}

void setEscaped(WorldData& data, bool escaped) {
    for (const Slot slot : data.escaped) {
        forCollidersOf(data, slot, [&](std::uint32_t i) { data.colliders[i].escaped = escaped; });
    }
}

/// Those whose boxes are no longer what the tree has are looked through one by one while they are few.
void refreshTree(WorldData& data) {
    const std::size_t count = data.boxes.size();
    for (const Slot slot : data.escaped) {
        forCollidersOf(data, slot, [&](std::uint32_t i) {
            if (!data.colliders[i].astray) {
                data.colliders[i].astray = true;
                data.astray.push_back(i);
            }
        });
    }
    if (!data.pairsStale && data.astray.size() * data.escaped.size() <= 8 * count && 8 * data.astray.size() <= count) {
        return;
    }
    data.tree.fill(data.boxes);
    for (const std::uint32_t i : data.astray) {
        data.colliders[i].astray = false;
    }
    data.astray.clear();
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
    if (4 * data.foundPairs.size() < data.records.size()) {
        std::sort(data.foundPairs.begin(), data.foundPairs.end());
        return;
    }
    std::vector<std::uint32_t>& ends = data.pairEnds;
    ends.assign(data.records.size() + 1, 0);
    for (const FoundPair& pair : data.foundPairs) {
        ++ends[pair.bodyA + 1];
    }
    for (std::size_t i = 1; i < ends.size(); ++i) {
        ends[i] += ends[i - 1];
    }
    data.sortedPairs.resize(data.foundPairs.size());
    for (const FoundPair& pair : data.foundPairs) {
        data.sortedPairs[ends[pair.bodyA]++] = pair;
    }
    for (std::size_t i = 0, first = 0; i + 1 < ends.size(); first = ends[i++]) {
        sortNearlySorted(std::span(data.sortedPairs).subspan(first, ends[i] - first));
    }
    data.foundPairs.swap(data.sortedPairs);
}

} // namespace

void listColliders(WorldData& data) {
    data.colliders.clear();
    data.firstColliders.resize(data.records.size());
    data.escaped = data.moving;
    for (const Slot slot : data.moving) {
        listCollidersOf(data, slot);
    }
    for (const Slot slot : data.sleep.sleepers) {
        listCollidersOf(data, slot);
    }
    data.boxes.assign(data.colliders.size(), Aabb{});
    for (const Slot slot : data.sleep.sleepers) {
        std::uint32_t i = data.firstColliders[slot];
        for (const Part& part : *data.records[slot].parts) {
            data.boxes[i++] = roomyBox(data.steps[slot], data.motions[slot], part);
        }
    }
    data.astray.clear();
}

void giveRoom(WorldData& data, double seconds) {
    constexpr std::size_t ahead = 4;
    for (std::size_t k = 0; k < data.escaped.size(); ++k) {
        if (k + ahead < data.escaped.size()) {
            fetch(data.records[data.escaped[k + ahead]].parts);
            fetch(data.records[data.escaped[k + ahead]].bounds);
        }
        const Slot slot = data.escaped[k];
        BodyStep& s = data.steps[slot];
        BodyRecord& record = data.records[slot];
        s.room = roomAround(data.motions[slot], s, seconds);
        record.bounds = Aabb{};
        std::uint32_t i = data.firstColliders[slot];
        for (const Part& part : *record.parts) {
            data.boxes[i] = roomyBox(s, data.motions[slot], part);
            record.bounds.include(data.boxes[i++]);
        }
    }
}

void collectPairs(WorldData& data) {
    refreshTree(data);
    setEscaped(data, true);
    data.foundPairs.clear();
    const bool most = data.astray.empty() && 2 * data.escaped.size() > data.moving.size();
    if (most) {
        findAllMoving(data);
    }
    for (const Slot slot : data.escaped) {
        forCollidersOf(data, slot, [&](std::uint32_t i) {
            if (!most) {
                findMovingOf(data, i);
            }
            findStaticsOf(data, i);
        });
    }
    setEscaped(data, false);
    sortFound(data);
}

} // namespace spacetow
