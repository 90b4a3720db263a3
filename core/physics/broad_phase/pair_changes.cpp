#include "core/physics/broad_phase/pair_changes.h"

#include <algorithm>

namespace spacetow {

namespace {

bool connectedApart(const WorldData& data, Slot a, Slot b) {
    return !data.notColliding.empty() &&
           std::binary_search(data.notColliding.begin(), data.notColliding.end(), SlotPair(std::minmax(a, b)));
}

bool shouldCollide(const WorldData& data, Slot a, Slot b) {
    const BodyRecord& ra = data.records[a];
    const BodyRecord& rb = data.records[b];
    const bool oneMoves = ra.kind == BodyKind::Dynamic || rb.kind == BodyKind::Dynamic;
    const bool oneIsSensor = !ra.tangible || !rb.tangible;
    return a != b && (oneMoves || oneIsSensor) && mayTouch(ra.filter, rb.filter) && !connectedApart(data, a, b);
}

PairKind kindOf(const WorldData& data, const Pair& pair) {
    const bool tangible = data.records[pair.bodyA].tangible && data.records[pair.bodyB].tangible;
    if (!tangible || (!data.motions[pair.bodyA].isMovable() && !data.motions[pair.bodyB].isMovable())) {
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

Pair makePair(const WorldData& data, const FoundPair& found) {
    const BodyRecord& ra = data.records[found.bodyA];
    const BodyRecord& rb = data.records[found.bodyB];
    Pair pair;
    pair.staticB = rb.kind == BodyKind::Static;
    pair.bodyA = found.bodyA;
    pair.bodyB = found.bodyB;
    pair.partA = found.partA;
    pair.partB = found.partB;
    pair.shapeA = &(*ra.parts)[pair.partA];
    if (pair.staticB) {
        pair.collider = rb.firstStatic + pair.partB;
        pair.shapeB = &data.statics->colliders[pair.collider].shape;
    } else {
        pair.shapeB = &(*rb.parts)[pair.partB];
    }
    pair.kind = kindOf(data, pair);
    pair.unmergeable = !pair.staticB && ra.parts->size() == 1 && rb.parts->size() == 1;
    return pair;
}

/// Whether the speculative margin may cover but a part of an iteration.
bool limitsFraction(const WorldData& data, const Pair& pair) {
    const bool driven =
        !pair.staticB && !(data.motions[pair.bodyA].isMovable() && data.motions[pair.bodyB].isMovable());
    return pair.kind == PairKind::General || (driven && pair.kind != PairKind::Sensor);
}

void noteDropped(WorldData& data, std::size_t index) {
    data.dropped.push_back(static_cast<std::uint32_t>(index));
    if (data.table.flags[index].reported) {
        data.droppedTouches.push_back(data.table.pairs[index].bodies());
    }
}

/// All pairs have been found: they make a new table. What is known of their contacts remains.
void fillNewTable(WorldData& data) {
    const PairTable& old = data.table;
    PairTable& renewed = data.newTable;
    renewed.clear();
    data.dropped.clear();
    data.runs.clear();
    std::size_t i = 0;
    for (const FoundPair& found : data.foundPairs) {
        if (!shouldCollide(data, found.bodyA, found.bodyB)) {
            continue;
        }
        for (; i < old.size() && FoundPair(old.pairs[i]) < found; ++i) {
            noteDropped(data, i);
        }
        renewed.add(makePair(data, found));
        const bool covered = limitsFraction(data, renewed.pairs.back());
        renewed.flags.back().limitsFraction = covered;
        if (i == old.size() || found < FoundPair(old.pairs[i])) {
            continue;
        }
        if (renewed.pairs.back().kind == old.pairs[i].kind) {
            renewed.pairs.back().contact = old.pairs[i].contact;
        } else {
            data.dropped.push_back(static_cast<std::uint32_t>(i)); // but its touch goes on
        }
        renewed.flags.back() = old.flags[i++];
        renewed.flags.back().limitsFraction = covered;
    }
    for (; i < old.size(); ++i) {
        noteDropped(data, i);
    }
}

/// The pairs of moved proxies.
void listMovedPairs(WorldData& data) {
    for (const Slot slot : data.movedBodies) {
        data.isMovedProxy[slot + 1] = 1;
    }
    if (data.movedPairs.capacity() < data.table.size()) {
        data.movedPairs.reserve(data.table.capacity()); // resizing would add no more than what is needed now
    }
    data.movedPairs.resize(data.table.size());
    std::size_t count = 0;
    for (std::size_t i = 0; i < data.table.size(); ++i) {
        const PairBound& bound = data.table.bounds[i];
        data.movedPairs[count] = static_cast<std::uint32_t>(i);
        count += data.isMovedProxy[bound.moverA] | data.isMovedProxy[bound.moverB];
    }
    data.movedPairs.resize(count);
    for (const Slot slot : data.movedBodies) {
        data.isMovedProxy[slot + 1] = 0;
    }
}

/// What is to change in the table: `dropped` by index, and new pairs with the indices before which they belong.
void diffPairs(WorldData& data) {
    const std::vector<Pair>& pairs = data.table.pairs;
    data.dropped.clear();
    data.newPairs.clear();
    data.newPlaces.clear();
    std::size_t i = 0;
    std::size_t first = 0; // no new pair belongs before that
    for (const FoundPair& found : data.foundPairs) {
        for (; i < data.movedPairs.size() && FoundPair(pairs[data.movedPairs[i]]) < found;
             first = data.movedPairs[i++] + 1) {
            noteDropped(data, data.movedPairs[i]);
        }
        const std::size_t end = i < data.movedPairs.size() ? data.movedPairs[i] : pairs.size();
        if (end < pairs.size() && !(found < FoundPair(pairs[end]))) {
            first = data.movedPairs[i++] + 1;
        } else if (shouldCollide(data, found.bodyA, found.bodyB)) {
            const auto begin = pairs.begin();
            const auto place =
                std::lower_bound(begin + static_cast<std::ptrdiff_t>(first), begin + static_cast<std::ptrdiff_t>(end),
                                 found, [](const Pair& a, const FoundPair& b) { return FoundPair(a) < b; });
            first = static_cast<std::size_t>(place - begin);
            data.newPlaces.push_back(static_cast<std::uint32_t>(first));
            data.newPairs.push_back(makePair(data, found));
        }
    }
    for (; i < data.movedPairs.size(); ++i) {
        noteDropped(data, data.movedPairs[i]);
    }
}

/// Between what is dropped and what is new the table stays as it is. The places of new pairs become those in the table
/// as it will be.
void listRuns(WorldData& data) {
    std::vector<std::uint32_t>& places = data.newPlaces;
    const auto size = static_cast<std::uint32_t>(data.table.size());
    data.runs.clear();
    std::uint32_t begin = 0;
    std::uint32_t added = 0;
    std::uint32_t removed = 0;
    while (begin < size || added < places.size()) {
        const std::uint32_t nextDropped = removed < data.dropped.size() ? data.dropped[removed] : size;
        const std::uint32_t end = added < places.size() ? std::min(places[added], nextDropped) : nextDropped;
        data.runs.push_back({begin, end, begin + added - removed});
        begin = end;
        for (; added < places.size() && places[added] == end; ++added) {
            places[added] = end + added - removed;
        }
        if (removed < data.dropped.size() && nextDropped == end) {
            ++removed;
            ++begin;
        }
    }
}

/// Moves each run once, those that go down from the first one on, those that go up from the last: none comes to lie
/// where another one still is.
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

void rearrangeTable(WorldData& data) {
    PairTable& table = data.table;
    const std::size_t newSize = table.size() + data.newPairs.size() - data.dropped.size();
    rearrange(table.bounds, data.runs, newSize);
    rearrange(table.flags, data.runs, newSize);
    rearrange(table.pairs, data.runs, newSize);
    for (std::size_t i = 0; i < data.newPairs.size(); ++i) {
        const Pair& pair = data.newPairs[i];
        const std::uint32_t place = data.newPlaces[i];
        table.bounds[place] = unknownBound(pair);
        table.flags[place] = {.limitsFraction = limitsFraction(data, pair)};
        table.pairs[place] = pair;
    }
}

} // namespace

bool comparePairs(WorldData& data) {
    if (data.pairsStale) {
        fillNewTable(data);
        return true;
    }
    data.isMovedProxy.resize(data.records.size() + 1, 0);
    listMovedPairs(data);
    diffPairs(data);
    if (data.dropped.empty() && data.newPairs.empty()) {
        return false;
    }
    listRuns(data);
    return true;
}

void changeTable(WorldData& data) {
    if (data.pairsStale) {
        std::swap(data.table, data.newTable);
    } else {
        rearrangeTable(data);
    }
}

} // namespace spacetow
