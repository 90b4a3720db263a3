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

// The fat AABB has room for motion that the velocity does not predict: a share of the size of the body, a length, and a
// share of the predicted motion. 1 to 4 cm are as fast for bodies of decimetres: smaller ones are searched more often,
// larger ones have more pairs.
constexpr double fatShareOfRadius = 0.05;
constexpr double fatMargin = 0.02; // m
constexpr double fatShareOfMotion = 0.1;
// Likewise for the angle: a multiple of the predicted turn, and a turn, rad.
constexpr double fatTurnFactor = 1.5;
constexpr double fatTurn = 0.05;

/// The fat AABB for `seconds` of motion at the present velocity and acceleration.
FatAabb fatAabbAround(const BodyMotion& m, const BodyStep& s, double seconds) {
    const double speed = std::sqrt(m.velocity.squaredNorm());
    const double acceleration = std::sqrt(s.acceleration.squaredNorm());
    const double pad = fatShareOfRadius * s.outerRadius + fatMargin + fatShareOfMotion * (speed * seconds) +
                       0.5 * acceleration * seconds * seconds;
    FatAabb fat;
    fat.centers = {m.center, m.center};
    fat.centers.include(m.center + seconds * m.velocity);
    fat.centers.include(m.center + s.correction);
    fat.centers = fat.centers.grown(pad);
    const double turn = fatTurnFactor * std::abs(m.angularVelocity) * seconds + fatTurn;
    const bool anyTurn = s.isCircle || turn >= 1; // rad: the AABB of the circle around the body is hardly larger
    fat.angleLeft = anyTurn ? std::numeric_limits<double>::infinity() : turn;
    return fat;
}

/// The fat AABB of one part.
Aabb fatBox(const BodyStep& s, const BodyMotion& m, const Part& part) {
    Aabb box = boundsOf(part, Transform{m.center, m.rotation});
    // A turn moves no point by more than the arc of the outermost one.
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

void listProxiesOf(const Bodies& bodies, BroadPhase& broadPhase, Slot slot) {
    broadPhase.firstProxies[slot] = static_cast<std::uint32_t>(broadPhase.proxies.size());
    const std::vector<Part>& parts = *bodies.records[slot].parts;
    for (std::uint32_t i = 0; i < parts.size(); ++i) {
        broadPhase.proxies.push_back({slot, i, isSlender(parts[i])});
    }
}

/// Visits the indices of the proxies of a body, without reading its record.
template <class Visit>
void forProxiesOf(const BroadPhase& broadPhase, Slot slot, const Visit& visit) {
    for (std::uint32_t i = broadPhase.firstProxies[slot];
         i < broadPhase.proxies.size() && broadPhase.proxies[i].body == slot; ++i) {
        visit(i);
    }
}

void add(const PairStage& stage, const MovingProxy& a, const MovingProxy& b) {
    const bool ordered = a.body < b.body;
    const MovingProxy& first = ordered ? a : b;
    const MovingProxy& second = ordered ? b : a;
    stage.search.foundPairs.push_back({first.body, second.body, first.part, second.part});
}

/// Whether the proxy is a slender part, and the fat AABB of another proxy lies in front of one of its faces.
bool isInFrontOfSlender(const Bodies& bodies, const MovingProxy& of, const Aabb& box) {
    return of.slender && isInFrontOfFace(box, std::get<ConvexPart>((*bodies.records[of.body].parts)[of.part]),
                                         bodies.motions[of.body].rotation, bodies.steps[of.body].fat);
}

/// Whether the limit on pairs is reached; then sets `crowded`.
bool isCrowded(StepFlags& flags, const PairSearch& search) {
    const bool many = search.foundPairs.size() >= search.mostFound;
    flags.crowded |= many;
    return many;
}

void addUnlessSeparated(const PairStage& stage, std::uint32_t index, std::uint32_t other) {
    const MovingProxy& a = stage.broadPhase.proxies[index];
    const MovingProxy& b = stage.broadPhase.proxies[other];
    if (a.body != b.body && !isCrowded(stage.flags, stage.search) &&
        !isInFrontOfSlender(stage.bodies, a, stage.broadPhase.boxes[other]) &&
        !isInFrontOfSlender(stage.bodies, b, stage.broadPhase.boxes[index])) {
        add(stage, a, b);
    }
}

/// Whether the query of proxy `index` adds the pair: if both proxies are moved, only the later one does.
bool isFoundBy(const BroadPhase& broadPhase, std::uint32_t index, std::uint32_t other) {
    return other < index || !broadPhase.proxies[other].movedProxy;
}

void findMovingOf(const PairStage& stage, std::uint32_t index) {
    if (isCrowded(stage.flags, stage.search)) {
        return;
    }
    const Aabb& box = stage.broadPhase.boxes[index];
    stage.search.found.clear();
    stage.broadPhase.tree.query(box, stage.search.found);
    for (const std::uint32_t other : stage.search.found) {
        if (!stage.broadPhase.proxies[other].isStaleInTree && isFoundBy(stage.broadPhase, index, other)) {
            addUnlessSeparated(stage, index, other);
        }
    }
    for (const std::uint32_t other : stage.broadPhase.staleProxies) {
        if (stage.broadPhase.boxes[other].overlaps(box) && isFoundBy(stage.broadPhase, index, other)) {
            addUnlessSeparated(stage, index, other);
        }
    }
}

/// Needs a tree without stale proxies.
void findAllMoving(const PairStage& stage) {
    stage.search.overlapping.clear();
    stage.broadPhase.tree.queryAll(stage.search.overlapping, stage.search.mostFound);
    for (const auto& [a, b] : stage.search.overlapping) {
        if (stage.broadPhase.proxies[a].movedProxy || stage.broadPhase.proxies[b].movedProxy) {
            addUnlessSeparated(stage, a, b);
        }
    }
}

void findStaticsOf(const BroadPhase& broadPhase, PairSearch& search, std::uint32_t index) {
    findStatics(broadPhase, broadPhase.boxes[index], search.found);
    const MovingProxy& collider = broadPhase.proxies[index];
    for (const std::uint32_t other : search.found) {
        const StaticGeometry::Collider& wall = broadPhase.staticCollider(other);
        search.foundPairs.push_back({collider.body, wall.body, collider.part, wall.part});
    }
}

void markMovedProxies(BroadPhase& broadPhase, const PairSearch& search, bool movedProxy) {
    for (const Slot slot : search.movedBodies) {
        forProxiesOf(broadPhase, slot, [&](std::uint32_t i) { broadPhase.proxies[i].movedProxy = movedProxy; });
    }
}

/// Marks the moved proxies as stale in the tree, and fills the tree anew when it has many stale proxies. Each query
/// compares its box with all stale proxies; that costs less than filling the tree while the comparisons are at most
/// `staleFactor` a proxy, and the stale proxies at most one in `staleFactor`.
void refreshTree(BroadPhase& broadPhase, const StepFlags& flags, const PairSearch& search) {
    const std::size_t count = broadPhase.boxes.size();
    for (const Slot slot : search.movedBodies) {
        forProxiesOf(broadPhase, slot, [&](std::uint32_t i) {
            if (!broadPhase.proxies[i].isStaleInTree) {
                broadPhase.proxies[i].isStaleInTree = true;
                broadPhase.staleProxies.push_back(i);
            }
        });
    }
    constexpr std::size_t staleFactor = 8;
    if (!flags.pairsStale && broadPhase.staleProxies.size() * search.movedBodies.size() <= staleFactor * count &&
        staleFactor * broadPhase.staleProxies.size() <= count) {
        return;
    }
    broadPhase.tree.fill(broadPhase.boxes);
    for (const std::uint32_t i : broadPhase.staleProxies) {
        broadPhase.proxies[i].isStaleInTree = false;
    }
    broadPhase.staleProxies.clear();
}

/// Insertion sort; falls back to std::sort if the pairs are not nearly sorted.
void sortNearlySorted(std::span<PairKey> pairs) {
    constexpr std::size_t movesPerPair = 16;
    std::size_t moves = 0;
    for (std::size_t i = 1; i < pairs.size(); ++i) {
        const PairKey pair = pairs[i];
        std::size_t k = i;
        for (; k > 0 && pair < pairs[k - 1]; --k) {
            pairs[k] = pairs[k - 1];
            ++moves;
        }
        pairs[k] = pair;
        if (moves > movesPerPair * pairs.size()) {
            std::sort(pairs.begin(), pairs.end());
            return;
        }
    }
}

/// Counting sort by body a, then by insertion the few pairs of each body, which the search finds nearly sorted. Few
/// pairs are sorted by comparison: counting costs a pass over all bodies.
void sortFound(const Bodies& bodies, PairSearch& search) {
    if (4 * search.foundPairs.size() < bodies.records.size()) {
        std::sort(search.foundPairs.begin(), search.foundPairs.end());
        return;
    }
    std::vector<std::uint32_t>& ends = search.pairEnds;
    ends.assign(bodies.records.size() + 1, 0);
    for (const PairKey& pair : search.foundPairs) {
        ++ends[pair.bodyA + 1];
    }
    for (std::size_t i = 1; i < ends.size(); ++i) {
        ends[i] += ends[i - 1];
    }
    search.sortedPairs.resize(search.foundPairs.size());
    for (const PairKey& pair : search.foundPairs) {
        search.sortedPairs[ends[pair.bodyA]++] = pair;
    }
    for (std::size_t i = 0, first = 0; i + 1 < ends.size(); first = ends[i++]) {
        sortNearlySorted(std::span(search.sortedPairs).subspan(first, ends[i] - first));
    }
    search.foundPairs.swap(search.sortedPairs);
}

} // namespace

void listProxies(const Bodies& bodies, BroadPhase& broadPhase, const Sleep& sleep, PairSearch& search) {
    broadPhase.proxies.clear();
    broadPhase.firstProxies.resize(bodies.records.size());
    search.movedBodies = bodies.moving;
    for (const Slot slot : bodies.moving) {
        listProxiesOf(bodies, broadPhase, slot);
    }
    for (const Slot slot : sleep.sleepers) {
        listProxiesOf(bodies, broadPhase, slot);
    }
    broadPhase.boxes.assign(broadPhase.proxies.size(), Aabb{});
    for (const Slot slot : sleep.sleepers) {
        std::uint32_t i = broadPhase.firstProxies[slot];
        for (const Part& part : *bodies.records[slot].parts) {
            broadPhase.boxes[i++] = fatBox(bodies.steps[slot], bodies.motions[slot], part);
        }
    }
    broadPhase.staleProxies.clear();
}

void enlargeAabbs(Bodies& bodies, BroadPhase& broadPhase, const PairSearch& search, double seconds) {
    constexpr std::size_t ahead = 4;
    for (std::size_t k = 0; k < search.movedBodies.size(); ++k) {
        if (k + ahead < search.movedBodies.size()) {
            prefetch(bodies.records[search.movedBodies[k + ahead]].parts);
            prefetch(bodies.records[search.movedBodies[k + ahead]].bounds);
        }
        const Slot slot = search.movedBodies[k];
        BodyStep& s = bodies.steps[slot];
        BodyRecord& record = bodies.records[slot];
        s.fat = fatAabbAround(bodies.motions[slot], s, seconds);
        record.bounds = Aabb{};
        std::uint32_t i = broadPhase.firstProxies[slot];
        for (const Part& part : *record.parts) {
            broadPhase.boxes[i] = fatBox(s, bodies.motions[slot], part);
            record.bounds.include(broadPhase.boxes[i++]);
        }
    }
}

std::size_t mostPairs(const BroadPhase& broadPhase) {
    constexpr std::size_t base = std::size_t{1} << 18; // about 50 MB of pairs, in small worlds
    constexpr std::size_t perProxy = 64;               // a disc in a dense heap has about 6
    return base + perProxy * broadPhase.proxies.size();
}

void collectPairs(const PairStage& stage) {
    stage.search.mostFound =
        mostPairs(stage.broadPhase) -
        (stage.flags.pairsStale ? 0 : std::min(stage.contacts.table.size(), mostPairs(stage.broadPhase)) / 2);
    refreshTree(stage.broadPhase, stage.flags, stage.search);
    markMovedProxies(stage.broadPhase, stage.search, true);
    stage.search.foundPairs.clear();
    const bool most =
        stage.broadPhase.staleProxies.empty() && 2 * stage.search.movedBodies.size() > stage.bodies.moving.size();
    if (most) {
        findAllMoving(stage);
    }
    for (const Slot slot : stage.search.movedBodies) {
        forProxiesOf(stage.broadPhase, slot, [&](std::uint32_t i) {
            if (!most) {
                findMovingOf(stage, i);
            }
            findStaticsOf(stage.broadPhase, stage.search, i);
        });
    }
    markMovedProxies(stage.broadPhase, stage.search, false);
    sortFound(stage.bodies, stage.search);
}

} // namespace spacetow
