#include "core/physics/sleep/sleep.h"

#include "core/geometry/bounds.h"
#include "core/physics/broad_phase/pairs.h"
#include "core/physics/contacts/constraint_list.h"
#include "core/physics/sleep/touches.h"
#include "core/physics/solver/integrate.h"
#include "core/physics/solver/islands.h"

#include <algorithm>

namespace spacetow {

namespace {

// No point of a body may be faster than this for it to fall asleep, m/s, and for so long, s.
constexpr double sleepSpeed = 0.01;
constexpr double sleepDelay = 0.5;

/// Bodies that no contact can move join nothing and are not woken by contacts.
bool isAnchor(const WorldData& data, Slot slot) {
    return data.motions[slot].inverseMass == 0 && data.motions[slot].inverseInertia == 0;
}

/// Anchors move as they are told, however slowly.
bool isStill(const WorldData& data, Slot slot) {
    const BodyMotion& m = data.motions[slot];
    const double speed =
        std::sqrt(m.velocity.squaredNorm()) + std::abs(m.angularVelocity) * data.steps[slot].outerRadius;
    return isAnchor(data, slot) ? speed == 0 : speed < sleepSpeed;
}

bool maySleep(const WorldData& data, Slot slot) {
    const BodyRecord& record = data.records[slot];
    return record.kind == BodyKind::Static || record.asleep || record.stillTime >= sleepDelay;
}

bool sleeps(const WorldData& data, const Pair& pair) {
    return data.records[pair.bodyA].asleep && (pair.staticB || data.records[pair.bodyB].asleep);
}

/// Pairs nobody of which moves on one side, the others on the other.
void partitionPairs(WorldData& data) {
    Sleep& sleep = data.sleep;
    data.scratch.changes.newTable.clear();
    data.scratch.sleep.newTable.clear();
    for (std::size_t i = 0, j = 0; i < data.table.size() || j < sleep.table.size();) {
        const bool first =
            j == sleep.table.size() || (i < data.table.size() && data.table.pairs[i] < sleep.table.pairs[j]);
        const PairTable& from = first ? data.table : sleep.table;
        const std::size_t index = first ? i++ : j++;
        (sleeps(data, from.pairs[index]) ? data.scratch.sleep.newTable : data.scratch.changes.newTable)
            .addFrom(from, index);
    }
    std::swap(data.table, data.scratch.changes.newTable);
    std::swap(sleep.table, data.scratch.sleep.newTable);
}

/// All lists that depend on who sleeps.
void rebuildLists(WorldData& data) {
    releaseConstraints(data);
    Sleep& sleep = data.sleep;
    sleep.sleepers.clear();
    for (const Slot slot : data.nonStatic) {
        if (data.records[slot].asleep) {
            sleep.sleepers.push_back(slot);
        }
    }
    partitionPairs(data);
    listMoving(data);
    listSensors(data);
    relistTouchedTags(data);
}

void wake(WorldData& data, Slot slot, int iteration) {
    BodyRecord& record = data.records[slot];
    BodyStep& s = data.steps[slot];
    record.asleep = false;
    record.stillTime = 0;
    const bool falls = record.kind == BodyKind::Dynamic && !record.positionFrozen;
    s.acceleration = falls ? data.sleep.gravity : Vec2(0, 0);
    s.angularAcceleration = 0;
    data.events.wokeUp.push_back({iteration, data.idOf(slot)});
}

/// Everybody whose island is marked.
void wakeMarked(WorldData& data, int iteration) {
    const std::vector<std::uint8_t>& marked = data.scratch.sleep.marked;
    bool any = false;
    for (const Slot slot : data.sleep.sleepers) {
        if (marked[data.records[slot].island] != 0) {
            wake(data, slot, iteration);
            any = true;
        }
    }
    if (any) {
        rebuildLists(data);
    }
}

void clearMarks(WorldData& data) {
    std::vector<std::uint8_t>& marked = data.scratch.sleep.marked;
    marked.resize(data.records.size());
    for (const Slot slot : data.sleep.sleepers) {
        marked[data.records[slot].island] = 0;
    }
}

void markIsland(WorldData& data, Slot slot) {
    if (data.records[slot].asleep) {
        data.scratch.sleep.marked[data.records[slot].island] = 1;
    }
}

void markNear(WorldData& data, Slot anchor) {
    Aabb box;
    for (const Part& part : *data.records[anchor].parts) {
        box.include(boundsOf(part, data.pose(anchor)));
    }
    for (const Slot slot : data.sleep.sleepers) {
        if (data.records[slot].bounds.overlaps(box)) {
            markIsland(data, slot);
        }
    }
}

/// The islands of those that are in a pair with a disturbed anchor.
void markPartners(WorldData& data, const std::vector<Slot>& disturbed) {
    const auto isDisturbed = [&](Slot slot) {
        return isAnchor(data, slot) && std::binary_search(disturbed.begin(), disturbed.end(), slot);
    };
    for (const Pair& pair : data.sleep.table.pairs) {
        if (isDisturbed(pair.bodyA)) {
            markIsland(data, pair.bodyB);
        }
        if (isDisturbed(pair.bodyB)) {
            markIsland(data, pair.bodyA);
        }
    }
    for (const ConnectorRecord& c : data.connectors) {
        if (c.used && (std::binary_search(disturbed.begin(), disturbed.end(), c.a) ||
                       std::binary_search(disturbed.begin(), disturbed.end(), c.b))) {
            markIsland(data, c.a);
            markIsland(data, c.b);
        }
    }
}

/// Joins two bodies, or lets an anchor that is not at rest keep the other awake.
void join(WorldData& data, Slot a, Slot b) {
    std::vector<Slot>& parents = data.scratch.sleep.parents;
    const bool anchorA = isAnchor(data, a);
    const bool anchorB = isAnchor(data, b);
    if (!anchorA && !anchorB) {
        joinSets(parents, a, b);
    } else if (!anchorA && !maySleep(data, b)) {
        data.scratch.sleep.marked[a] = 1;
    } else if (!anchorB && !maySleep(data, a)) {
        data.scratch.sleep.marked[b] = 1;
    }
}

/// Each body that may be joined to others by itself, and not marked.
void beginSets(WorldData& data) {
    SleepSearch& sleep = data.scratch.sleep;
    sleep.parents.resize(data.records.size());
    sleep.marked.resize(data.records.size());
    const auto begin = [&](Slot slot) {
        sleep.parents[slot] = slot;
        sleep.marked[slot] = 0;
    };
    std::for_each(data.moving.begin(), data.moving.end(), begin);
    for (const Pair& pair : data.table.pairs) {
        begin(pair.bodyA);
        begin(pair.bodyB);
    }
    for (const ConnectorRecord& c : data.connectors) {
        if (c.used) {
            begin(c.a);
            begin(c.b);
        }
    }
}

void joinIslands(WorldData& data) {
    for (const Pair& pair : data.table.pairs) {
        const bool touches = pair.contact != Pair::none && data.contacts[pair.contact].count > 0;
        if (pair.kind != PairKind::Sensor && touches) {
            join(data, pair.bodyA, pair.bodyB);
        }
    }
    for (const ConnectorRecord& c : data.connectors) {
        if (c.used && data.records[c.a].active && data.records[c.b].active) {
            join(data, c.a, c.b);
        }
    }
}

void putToSleep(WorldData& data, Slot slot, Slot island, int iteration) {
    BodyRecord& record = data.records[slot];
    BodyMotion& m = data.motions[slot];
    BodyStep& s = data.steps[slot];
    record.asleep = true;
    record.island = island;
    m.velocity.setZero();
    m.angularVelocity = 0;
    s.startVelocity.setZero();
    s.startAngularVelocity = 0;
    s.deltaPosition.setZero();
    s.deltaAngle = 0;
    s.correction.setZero();
    s.angleCorrection = 0;
    s.fraction = 1;
    s.movedProxy = s.pushed = s.bounced = false;
    data.motionBounds[slot] = s.motionBound;
    data.notePlannedMotion(slot);
    data.events.fellAsleep.push_back({iteration, data.idOf(slot)});
}

} // namespace

void disturb(WorldData& data, Slot slot) {
    BodyRecord& record = data.records[slot];
    record.stillTime = 0;
    const bool moves = record.active && !record.asleep && record.kind != BodyKind::Static;
    if (!data.sleep.sleepers.empty() && !moves) {
        data.sleep.disturbed.push_back(slot);
    }
}

void wakeDisturbed(WorldData& data, int iteration) {
    std::vector<Slot>& disturbed = data.sleep.disturbed;
    if (disturbed.empty()) {
        return;
    }
    std::sort(disturbed.begin(), disturbed.end());
    disturbed.erase(std::unique(disturbed.begin(), disturbed.end()), disturbed.end());
    clearMarks(data);
    for (const Slot slot : disturbed) {
        markIsland(data, slot);
        if (data.records[slot].used && data.records[slot].kind == BodyKind::Static) {
            markNear(data, slot);
        }
    }
    markPartners(data, disturbed);
    wakeMarked(data, iteration);
    disturbed.clear();
}

void beginSleep(WorldData& data, const Vec2& gravity) {
    Sleep& sleep = data.sleep;
    const bool all = !sleep.sleepers.empty() && (!sleep.allowed || gravity != sleep.gravity);
    sleep.gravity = sleep.allowed ? gravity : Vec2(0, 0);
    if (all) {
        data.scratch.sleep.marked.assign(data.records.size(), 1);
        wakeMarked(data, -1);
        sleep.disturbed.clear();
    }
    wakeDisturbed(data, -1);
}

bool wakeTouched(WorldData& data, const IterationStep& step) {
    if (data.sleep.sleepers.empty()) {
        return false;
    }
    bool any = false;
    const auto touch = [&](Slot slot) {
        if (data.records[slot].asleep && !isAnchor(data, slot)) {
            if (!any) {
                clearMarks(data);
            }
            markIsland(data, slot);
            any = true;
        }
    };
    for (const CircleContact& c : data.circleContacts) {
        touch(c.a);
        touch(c.b);
    }
    for (const GeneralContact& c : data.generalContacts) {
        touch(c.a);
        touch(c.b);
    }
    if (any) {
        restoreVelocities(data);
        wakeMarked(data, step.index);
        prepareSteps(data, step);
    }
    return any;
}

void fallAsleep(WorldData& data, double seconds, int iteration) {
    if (!data.sleep.allowed) {
        return;
    }
    bool anyReady = false;
    for (const Slot slot : data.moving) {
        double& stillTime = data.records[slot].stillTime;
        stillTime = isStill(data, slot) ? stillTime + seconds : 0;
        anyReady |= stillTime >= sleepDelay;
    }
    if (!anyReady) {
        return;
    }
    beginSets(data); // and mark who stays awake
    joinIslands(data);
    std::vector<Slot>& parents = data.scratch.sleep.parents;
    std::vector<std::uint8_t>& marked = data.scratch.sleep.marked;
    for (const Slot slot : data.moving) {
        if (marked[slot] != 0 || !maySleep(data, slot)) {
            marked[rootOf(parents, slot)] = 1;
        }
    }
    bool any = false;
    for (const Slot slot : data.moving) {
        const Slot island = rootOf(parents, slot);
        if (marked[island] == 0) {
            putToSleep(data, slot, island, iteration);
            any = true;
        }
    }
    if (any) {
        rebuildLists(data);
    }
}

} // namespace spacetow
