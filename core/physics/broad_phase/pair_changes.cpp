#include "core/physics/broad_phase/pair_changes.h"

#include "core/physics/broad_phase/collision_rules.h"
#include "core/physics/broad_phase/statics.h"

#include <algorithm>

namespace spacetow {

namespace {

PairKind kindOf(const Bodies& bodies, const Pair& pair) {
    if (!areTangible(bodies, pair.bodyA, pair.bodyB) ||
        (!bodies.motions[pair.bodyA].isMovable() && !bodies.motions[pair.bodyB].isMovable())) {
        return PairKind::Sensor;
    }
    if (isRound(*pair.shapeA)) {
        if (pair.staticB) {
            const auto* wall = std::get_if<WallPart>(pair.shapeB);
            return wall != nullptr && wall->oneWay ? PairKind::CircleEdge : PairKind::CircleStatic;
        }
        return isRound(*pair.shapeB) ? PairKind::CircleCircle : PairKind::General;
    }
    return PairKind::General;
}

Pair makePair(const Bodies& bodies, const BroadPhase& broadPhase, const PairKey& found) {
    const BodyRecord& ra = bodies.records[found.bodyA];
    const BodyRecord& rb = bodies.records[found.bodyB];
    Pair pair;
    pair.staticB = rb.kind == BodyKind::Static;
    pair.bodyA = found.bodyA;
    pair.bodyB = found.bodyB;
    pair.partA = found.partA;
    pair.partB = found.partB;
    pair.shapeA = &(*ra.parts)[pair.partA];
    if (pair.staticB) {
        pair.collider = staticIndex(bodies, broadPhase, pair.bodyB, pair.partB);
        pair.shapeB = &broadPhase.staticCollider(pair.collider).shape;
    } else {
        pair.shapeB = &(*rb.parts)[pair.partB];
    }
    pair.kind = kindOf(bodies, pair);
    pair.unmergeable = !pair.staticB && ra.parts->size() == 1 && rb.parts->size() == 1;
    return pair;
}

/// See PairFlags::limitsFraction: the bodies may turn while they touch, or one is immovable and may be fast.
bool limitsFraction(const Bodies& bodies, const Pair& pair) {
    const bool kinematic =
        !pair.staticB && !(bodies.motions[pair.bodyA].isMovable() && bodies.motions[pair.bodyB].isMovable());
    return pair.kind == PairKind::General || (kinematic && pair.kind != PairKind::Sensor);
}

void noteDropped(const Contacts& contacts, PairChanges& changes, std::size_t index) {
    changes.dropped.push_back(static_cast<std::uint32_t>(index));
    if (contacts.table.flags[index].reported) {
        changes.droppedTouches.push_back(contacts.table.pairs[index].key().bodies());
    }
}

/// Makes a new table from all found pairs. Pairs that were in the old table keep their contacts and flags.
void fillNewTable(const PairStage& stage) {
    const PairTable& old = stage.contacts.table;
    PairTable& renewed = stage.changes.newTable;
    renewed.clear();
    stage.changes.dropped.clear();
    stage.changes.runs.clear();
    std::size_t i = 0;
    for (const PairKey& found : stage.search.foundPairs) {
        if (!mayCollide(stage.bodies, stage.forces, found.bodyA, found.bodyB)) {
            continue;
        }
        for (; i < old.size() && old.pairs[i].key() < found; ++i) {
            noteDropped(stage.contacts, stage.changes, i);
        }
        renewed.add(makePair(stage.bodies, stage.broadPhase, found));
        const bool covered = limitsFraction(stage.bodies, renewed.pairs.back());
        renewed.flags.back().limitsFraction = covered;
        if (i == old.size() || found < old.pairs[i].key()) {
            continue;
        }
        if (renewed.pairs.back().kind == old.pairs[i].kind) {
            renewed.pairs.back().contact = old.pairs[i].contact;
        } else {
            stage.changes.dropped.push_back(
                static_cast<std::uint32_t>(i)); // frees the contact; the touch has not ended
        }
        renewed.flags.back() = old.flags[i++];
        renewed.flags.back().limitsFraction = covered;
        renewed.flags.back().passed = false; // a sensor pair may have become a solid one
    }
    for (; i < old.size(); ++i) {
        noteDropped(stage.contacts, stage.changes, i);
    }
}

/// Fills `movedPairs` with the indices of the pairs of moved proxies.
void listMovedPairs(const Contacts& contacts, const PairSearch& search, PairChanges& changes) {
    for (const Slot slot : search.movedBodies) {
        changes.isMovedProxy[slot] = 1;
    }
    if (changes.movedPairs.capacity() < contacts.table.size()) {
        changes.movedPairs.reserve(
            contacts.table.capacity()); // resize() alone would reserve no more than is needed now
    }
    changes.movedPairs.resize(contacts.table.size());
    std::size_t count = 0;
    for (std::size_t i = 0; i < contacts.table.size(); ++i) {
        const PairBound& bound = contacts.table.bounds[i];
        changes.movedPairs[count] = static_cast<std::uint32_t>(i);
        count += changes.isMovedProxy[bound.moverA] | changes.isMovedProxy[bound.moverB];
    }
    changes.movedPairs.resize(count);
    for (const Slot slot : search.movedBodies) {
        changes.isMovedProxy[slot] = 0;
    }
}

/// Fills `dropped`, `newPairs` and `newPlaces`. A merge of two sorted lists: the pairs of moved proxies in the table,
/// and the found pairs.
void diffPairs(const PairStage& stage) {
    const std::vector<Pair>& pairs = stage.contacts.table.pairs;
    stage.changes.dropped.clear();
    stage.changes.newPairs.clear();
    stage.changes.newPlaces.clear();
    std::size_t i = 0;
    std::size_t first = 0; // no new pair belongs before this index
    for (const PairKey& found : stage.search.foundPairs) {
        for (; i < stage.changes.movedPairs.size() && pairs[stage.changes.movedPairs[i]].key() < found;
             first = stage.changes.movedPairs[i++] + 1) {
            noteDropped(stage.contacts, stage.changes, stage.changes.movedPairs[i]);
        }
        const std::size_t end = i < stage.changes.movedPairs.size() ? stage.changes.movedPairs[i] : pairs.size();
        if (end < pairs.size() && !(found < pairs[end].key())) {
            first = stage.changes.movedPairs[i++] + 1;
        } else if (mayCollide(stage.bodies, stage.forces, found.bodyA, found.bodyB)) {
            const auto begin = pairs.begin();
            const auto place =
                std::lower_bound(begin + static_cast<std::ptrdiff_t>(first), begin + static_cast<std::ptrdiff_t>(end),
                                 found, [](const Pair& a, const PairKey& b) { return a.key() < b; });
            first = static_cast<std::size_t>(place - begin);
            stage.changes.newPlaces.push_back(static_cast<std::uint32_t>(first));
            stage.changes.newPairs.push_back(makePair(stage.bodies, stage.broadPhase, found));
        }
    }
    for (; i < stage.changes.movedPairs.size(); ++i) {
        noteDropped(stage.contacts, stage.changes, stage.changes.movedPairs[i]);
    }
}

/// Fills `runs` with the pairs between dropped and new ones. `newPlaces` become indices in the next table.
void listRuns(const Contacts& contacts, PairChanges& changes) {
    std::vector<std::uint32_t>& places = changes.newPlaces;
    const auto size = static_cast<std::uint32_t>(contacts.table.size());
    changes.runs.clear();
    std::uint32_t begin = 0;
    std::uint32_t added = 0;
    std::uint32_t removed = 0;
    while (begin < size || added < places.size()) {
        const std::uint32_t nextDropped = removed < changes.dropped.size() ? changes.dropped[removed] : size;
        const std::uint32_t end = added < places.size() ? std::min(places[added], nextDropped) : nextDropped;
        changes.runs.push_back({begin, end, begin + added - removed});
        begin = end;
        for (; added < places.size() && places[added] == end; ++added) {
            places[added] = end + added - removed;
        }
        if (removed < changes.dropped.size() && nextDropped == end) {
            ++removed;
            ++begin;
        }
    }
}

/// Moves each run once: first the runs that move down, in ascending order, then those that move up, in descending
/// order. So no run overwrites another one that has yet to move.
template <typename T>
void rearrange(std::vector<T>& list, const std::vector<Run>& runs, std::size_t newSize) {
    list.resize(std::max(list.size(), newSize));
    const auto at = [&](std::uint32_t index) { return list.begin() + static_cast<std::ptrdiff_t>(index); };
    for (const Run& s : runs) {
        if (s.to < s.begin) {
            std::copy(at(s.begin), at(s.end), at(s.to));
        }
    }
    for (std::size_t i = runs.size(); i-- > 0;) {
        const Run& s = runs[i];
        if (s.to > s.begin) {
            std::copy_backward(at(s.begin), at(s.end), at(s.to + s.end - s.begin));
        }
    }
    list.resize(newSize);
}

void rearrangeTable(const Bodies& bodies, Contacts& contacts, const PairChanges& changes) {
    PairTable& table = contacts.table;
    const std::size_t newSize = table.size() + changes.newPairs.size() - changes.dropped.size();
    rearrange(table.bounds, changes.runs, newSize);
    rearrange(table.flags, changes.runs, newSize);
    rearrange(table.pairs, changes.runs, newSize);
    for (std::size_t i = 0; i < changes.newPairs.size(); ++i) {
        const Pair& pair = changes.newPairs[i];
        const std::uint32_t place = changes.newPlaces[i];
        table.bounds[place] = unknownBound(pair);
        table.flags[place] = {.limitsFraction = limitsFraction(bodies, pair)};
        table.pairs[place] = pair;
    }
}

} // namespace

bool comparePairs(const PairStage& stage) {
    if (stage.flags.pairsStale) {
        fillNewTable(stage);
        return true;
    }
    stage.changes.isMovedProxy.resize(stage.bodies.records.size());
    listMovedPairs(stage.contacts, stage.search, stage.changes);
    diffPairs(stage);
    if (stage.changes.dropped.empty() && stage.changes.newPairs.empty()) {
        return false;
    }
    listRuns(stage.contacts, stage.changes);
    return true;
}

void changeTable(const Bodies& bodies, Contacts& contacts, const StepFlags& flags, PairChanges& changes) {
    if (flags.pairsStale) {
        std::swap(contacts.table, changes.newTable);
    } else {
        rearrangeTable(bodies, contacts, changes);
    }
}

} // namespace spacetow
