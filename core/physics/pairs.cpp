#include "core/physics/pairs.h"

#include "core/geometry/bounds.h"
#include "core/physics/contact_pool.h"
#include "core/physics/islands.h"
#include "core/physics/statics.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace spacetow {

namespace {

bool isRound(const Part& part) {
    const auto* circle = std::get_if<Circle>(&part);
    return circle != nullptr && circle->center.x() == 0 && circle->center.y() == 0;
}

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

PairKind kindOf(const WorldData& data, const Pair& pair) {
    const bool tangible = data.records[pair.bodyA].tangible && data.records[pair.bodyB].tangible;
    if (!tangible || (!data.motions[pair.bodyA].yields() && !data.motions[pair.bodyB].yields())) {
        return PairKind::Felt;
    }
    if (isRound(*pair.shapeA)) {
        if (pair.staticB) {
            const auto* wall = std::get_if<WallPart>(pair.shapeB);
            return wall != nullptr && wall->oneWay ? PairKind::RoundEdge : PairKind::RoundStatic;
        }
        return isRound(*pair.shapeB) ? PairKind::RoundRound : PairKind::General;
    }
    return PairKind::General;
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
    if (pair.staticB) {
        pair.collider = rb.firstStatic + partB;
        pair.shapeB = &data.statics->colliders[pair.collider].shape;
    } else {
        pair.shapeB = &(*rb.parts)[partB];
    }
    pair.kind = kindOf(data, pair);
    pair.alone = !pair.staticB && ra.parts->size() == 1 && rb.parts->size() == 1;
    return pair;
}

void listColliders(WorldData& data) {
    data.colliders.clear();
    for (const Slot slot : data.moving) {
        data.steps[slot].escaped = true;
        for (std::uint32_t i = 0; i < data.records[slot].parts->size(); ++i) {
            data.colliders.push_back({slot, i, {}});
        }
    }
    for (const Slot slot : data.sleep.sleepers) {
        for (std::uint32_t i = 0; i < data.records[slot].parts->size(); ++i) {
            const Part& part = (*data.records[slot].parts)[i];
            data.colliders.push_back({slot, i, roomyBox(data.steps[slot], data.motions[slot], part)});
        }
    }
}

void giveRoom(WorldData& data, double seconds) {
    for (const Slot slot : data.moving) {
        BodyStep& s = data.steps[slot];
        if (s.escaped) {
            s.room = roomAround(data.motions[slot], s, seconds);
            data.records[slot].bounds = Aabb{};
        }
    }
    for (MovingCollider& collider : data.colliders) {
        const BodyStep& s = data.steps[collider.body];
        if (s.escaped) {
            BodyRecord& record = data.records[collider.body];
            collider.box = roomyBox(s, data.motions[collider.body], (*record.parts)[collider.part]);
            record.bounds.include(collider.box);
        }
    }
}

void addPairsOf(WorldData& data, const MovingCollider& collider, std::uint32_t index) {
    data.found.clear();
    data.tree.insertAndQuery(index, collider.box, data.found);
    for (const std::uint32_t other : data.found) {
        const MovingCollider& o = data.colliders[other];
        if (mayMeet(data, collider.body, o.body)) {
            data.newPairs.push_back(makePair(data, collider.body, collider.part, o.body, o.part));
        }
    }
    findStatics(*data.statics, collider.box, data.found);
    for (const std::uint32_t other : data.found) {
        const StaticGeometry::Collider& o = data.statics->colliders[other];
        if (mayMeet(data, collider.body, o.body)) {
            data.newPairs.push_back(makePair(data, collider.body, collider.part, o.body, o.part));
        }
    }
}

/// By their first bodies in linear time, then the few of each body among themselves.
void sortPairs(WorldData& data) {
    std::vector<std::uint32_t>& ends = data.pairEnds;
    ends.assign(data.records.size() + 1, 0);
    for (const Pair& pair : data.newPairs) {
        ++ends[pair.bodyA + 1];
    }
    for (std::size_t i = 1; i < ends.size(); ++i) {
        ends[i] += ends[i - 1];
    }
    data.sortedPairs.resize(data.newPairs.size());
    for (const Pair& pair : data.newPairs) {
        data.sortedPairs[ends[pair.bodyA]++] = pair;
    }
    for (std::size_t i = 0, first = 0; i + 1 < ends.size(); first = ends[i++]) {
        std::sort(data.sortedPairs.begin() + static_cast<std::ptrdiff_t>(first),
                  data.sortedPairs.begin() + static_cast<std::ptrdiff_t>(ends[i]));
    }
    data.newPairs.swap(data.sortedPairs);
}

/// Those that stay where they are go into the tree first, so that each of the others meets all of them.
void collectPairs(WorldData& data) {
    Aabb world;
    for (const MovingCollider& collider : data.colliders) {
        world.include(collider.box);
    }
    data.newPairs.clear();
    data.tree.reset(world, static_cast<std::uint32_t>(data.colliders.size()));
    const auto count = static_cast<std::uint32_t>(data.colliders.size());
    for (std::uint32_t i = 0; i < count; ++i) {
        if (!data.steps[data.colliders[i].body].escaped) {
            data.tree.insert(i, data.colliders[i].box);
        }
    }
    for (std::uint32_t i = 0; i < count; ++i) {
        if (data.steps[data.colliders[i].body].escaped) {
            addPairsOf(data, data.colliders[i], i);
        }
    }
    sortPairs(data);
}

/// A pair that was not found anew remains when its bodies have stayed in their rooms.
void keepOrDrop(WorldData& data, std::size_t index) {
    const Pair& pair = data.table.pairs[index];
    const bool escaped =
        data.steps[pair.bodyA].escaped || (!pair.staticB && data.steps[pair.bodyB].escaped) || data.pairsStale;
    if (!escaped) {
        data.newTable.addFrom(data.table, index);
        return;
    }
    if (data.table.marks[index].reported) {
        data.droppedTouches.push_back(pair.bodies());
    }
    forgetContact(data, data.table.pairs[index]);
}

/// Both lists are sorted. Old pairs of bodies that stayed in their rooms remain; the others must be found again.
void mergePairs(WorldData& data) {
    const PairTable& old = data.table;
    PairTable& merged = data.newTable;
    merged.clear();
    std::size_t i = 0;
    for (const Pair& found : data.newPairs) {
        for (; i < old.size() && old.pairs[i] < found; ++i) {
            keepOrDrop(data, i);
        }
        if (i == old.size() || found < old.pairs[i]) {
            merged.add(found);
        } else if (data.pairsStale) {
            merged.add(found);
            if (found.kind == old.pairs[i].kind) {
                merged.pairs.back().contact = old.pairs[i].contact;
            } else {
                forgetContact(data, data.table.pairs[i]);
            }
            merged.marks.back() = old.marks[i++];
        } else {
            merged.addFrom(old, i++);
        }
    }
    for (; i < old.size(); ++i) {
        keepOrDrop(data, i);
    }
    std::swap(data.table, data.newTable);
}

bool isDriven(const WorldData& data, const Pair& pair) {
    return !pair.staticB && !(data.motions[pair.bodyA].yields() && data.motions[pair.bodyB].yields());
}

} // namespace

void listKinds(WorldData& data) {
    data.felt.clear();
    data.covered.clear();
    for (std::uint32_t i = 0; i < data.table.size(); ++i) {
        const Pair& pair = data.table.pairs[i];
        if (pair.kind == PairKind::Felt) {
            data.felt.push_back(i);
        } else if (pair.kind == PairKind::General || isDriven(data, pair)) {
            data.covered.push_back(i);
        }
    }
}

void PairTable::clear() {
    gates.clear();
    marks.clear();
    pairs.clear();
}

void PairTable::add(const Pair& pair) {
    gates.push_back({pair.bodyA + 1, pair.staticB ? 0 : pair.bodyB + 1, 0});
    marks.emplace_back();
    pairs.push_back(pair);
}

void PairTable::addFrom(const PairTable& other, std::size_t index) {
    gates.push_back(other.gates[index]);
    marks.push_back(other.marks[index]);
    pairs.push_back(other.pairs[index]);
}

void listMoving(WorldData& data) {
    data.moving.clear();
    for (const BodyKind kind : {BodyKind::Kinematic, BodyKind::Dynamic}) {
        for (Slot slot = 0; slot < data.records.size(); ++slot) {
            const BodyRecord& record = data.records[slot];
            if (record.used && record.active && !record.asleep && record.kind == kind) {
                data.moving.push_back(slot);
            }
        }
    }
}

void prepareStructure(WorldData& data) {
    refreshStatics(data);
    if (!data.bodiesChanged) {
        return;
    }
    listMoving(data);
    data.reporters.clear();
    for (Slot slot = 0; slot < data.records.size(); ++slot) {
        if (data.records[slot].used && data.records[slot].reportsTouches) {
            data.reporters.push_back(slot);
        }
    }
    data.travelled.assign(data.records.size() + 1, 0);
    data.alert.assign(data.records.size() + 1, 0);
    for (const Slot slot : data.sleep.sleepers) {
        data.travelled[slot + 1] = data.steps[slot].travelled;
    }
    data.touchedTags.resize(data.records.size());
    data.bodiesChanged = false;
    data.pairsStale = true;
}

void measureMotion(WorldData& data, double ahead) {
    data.anyEscaped = data.pairsStale;
    data.anyFault = data.anyFast = false;
    for (const Slot slot : data.moving) {
        BodyStep& s = data.steps[slot];
        const BodyMotion& m = data.motions[slot];
        const double reach = s.reach();
        data.anyFault |= !isSound(m, s);
        data.travelled[slot + 1] = s.travelled + reach;
        const bool far = isFar(s, reach);
        data.anyFast |= far;
        data.alert[slot + 1] = far || s.bouncing || s.diverted ? 1 : 0;
        s.escaped = !s.room.centers.contains(m.center) ||
                    !s.room.centers.contains(Vec2(m.center + s.shift + ahead * m.velocity)) ||
                    std::abs(s.turn + ahead * m.angularVelocity) > s.room.turnLeft;
        data.anyEscaped |= s.escaped;
    }
}

void findPairs(WorldData& data, const IterationStep& step) {
    if (data.pairsStale) {
        listColliders(data);
        for (KeptManifold& manifold : data.manifolds) {
            manifold.room = -1;
            manifold.holdsUntil = 0;
        }
    }
    giveRoom(data, step.remaining);
    collectPairs(data);
    mergePairs(data);
    listKinds(data);
    findIslands(data);
    data.pairsStale = false;
    data.anyEscaped = false;
}

} // namespace spacetow
