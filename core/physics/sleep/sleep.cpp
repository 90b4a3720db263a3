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
bool isAnchor(const Bodies& bodies, Slot slot) {
    return bodies.motions[slot].inverseMass == 0 && bodies.motions[slot].inverseInertia == 0;
}

/// Anchors move as they are told, however slowly.
bool isStill(const Bodies& bodies, Slot slot) {
    const BodyMotion& m = bodies.motions[slot];
    const double speed =
        std::sqrt(m.velocity.squaredNorm()) + std::abs(m.angularVelocity) * bodies.steps[slot].outerRadius;
    return isAnchor(bodies, slot) ? speed == 0 : speed < sleepSpeed;
}

bool maySleep(const Bodies& bodies, Slot slot) {
    const BodyRecord& record = bodies.records[slot];
    return record.kind == BodyKind::Static || record.asleep || record.stillTime >= sleepDelay;
}

bool sleeps(const Bodies& bodies, const Pair& pair) {
    return bodies.records[pair.bodyA].asleep && (pair.staticB || bodies.records[pair.bodyB].asleep);
}

/// Pairs nobody of which moves on one side, the others on the other.
void partitionPairs(WorldData& data) {
    Sleep& sleep = data.sleep;
    data.scratch.changes.newTable.clear();
    data.scratch.sleep.newTable.clear();
    for (std::size_t i = 0, j = 0; i < data.contacts.table.size() || j < sleep.table.size();) {
        const bool first = j == sleep.table.size() ||
                           (i < data.contacts.table.size() && data.contacts.table.pairs[i] < sleep.table.pairs[j]);
        const PairTable& from = first ? data.contacts.table : sleep.table;
        const std::size_t index = first ? i++ : j++;
        (sleeps(data.bodies, from.pairs[index]) ? data.scratch.sleep.newTable : data.scratch.changes.newTable)
            .addFrom(from, index);
    }
    std::swap(data.contacts.table, data.scratch.changes.newTable);
    std::swap(sleep.table, data.scratch.sleep.newTable);
}

/// All lists that depend on who sleeps.
void rebuildLists(WorldData& data) {
    releaseConstraints(data.contacts, data.constraints, data.flags);
    Sleep& sleep = data.sleep;
    sleep.sleepers.clear();
    for (const Slot slot : data.bodies.nonStatic) {
        if (data.bodies.records[slot].asleep) {
            sleep.sleepers.push_back(slot);
        }
    }
    partitionPairs(data);
    listMoving(data);
    listSensors(data.contacts, data.flags);
    relistTouchedTags(data.bodies, data.sleep);
}

void wake(WorldData& data, Slot slot, int iteration) {
    BodyRecord& record = data.bodies.records[slot];
    BodyStep& s = data.bodies.steps[slot];
    record.asleep = false;
    record.stillTime = 0;
    const bool falls = record.kind == BodyKind::Dynamic && !record.positionFrozen;
    s.acceleration = falls ? data.sleep.gravity : Vec2(0, 0);
    s.angularAcceleration = 0;
    data.events.wokeUp.push_back({iteration, data.bodies.idOf(slot)});
}

/// Everybody whose island is marked.
void wakeMarked(WorldData& data, int iteration) {
    const std::vector<std::uint8_t>& marked = data.scratch.sleep.marked;
    bool any = false;
    for (const Slot slot : data.sleep.sleepers) {
        if (marked[data.bodies.records[slot].island] != 0) {
            wake(data, slot, iteration);
            any = true;
        }
    }
    if (any) {
        rebuildLists(data);
    }
}

void clearMarks(const Bodies& bodies, const Sleep& sleep, SleepSearch& sleepSearch) {
    std::vector<std::uint8_t>& marked = sleepSearch.marked;
    marked.resize(bodies.records.size());
    for (const Slot slot : sleep.sleepers) {
        marked[bodies.records[slot].island] = 0;
    }
}

void markIsland(const Bodies& bodies, SleepSearch& sleepSearch, Slot slot) {
    if (bodies.records[slot].asleep) {
        sleepSearch.marked[bodies.records[slot].island] = 1;
    }
}

void markNear(const Bodies& bodies, const Sleep& sleep, SleepSearch& sleepSearch, Slot anchor) {
    Aabb box;
    for (const Part& part : *bodies.records[anchor].parts) {
        box.include(boundsOf(part, bodies.pose(anchor)));
    }
    for (const Slot slot : sleep.sleepers) {
        if (bodies.records[slot].bounds.overlaps(box)) {
            markIsland(bodies, sleepSearch, slot);
        }
    }
}

/// The islands of those that are in a pair with a disturbed anchor.
void markPartners(WorldData& data, const std::vector<Slot>& disturbed) {
    const auto isDisturbed = [&](Slot slot) {
        return isAnchor(data.bodies, slot) && std::binary_search(disturbed.begin(), disturbed.end(), slot);
    };
    for (const Pair& pair : data.sleep.table.pairs) {
        if (isDisturbed(pair.bodyA)) {
            markIsland(data.bodies, data.scratch.sleep, pair.bodyB);
        }
        if (isDisturbed(pair.bodyB)) {
            markIsland(data.bodies, data.scratch.sleep, pair.bodyA);
        }
    }
    for (const ConnectorRecord& c : data.forces.connectors) {
        if (c.used && (std::binary_search(disturbed.begin(), disturbed.end(), c.a) ||
                       std::binary_search(disturbed.begin(), disturbed.end(), c.b))) {
            markIsland(data.bodies, data.scratch.sleep, c.a);
            markIsland(data.bodies, data.scratch.sleep, c.b);
        }
    }
}

/// Joins two bodies, or lets an anchor that is not at rest keep the other awake.
void join(const Bodies& bodies, SleepSearch& sleepSearch, Slot a, Slot b) {
    std::vector<Slot>& parents = sleepSearch.parents;
    const bool anchorA = isAnchor(bodies, a);
    const bool anchorB = isAnchor(bodies, b);
    if (!anchorA && !anchorB) {
        joinSets(parents, a, b);
    } else if (!anchorA && !maySleep(bodies, b)) {
        sleepSearch.marked[a] = 1;
    } else if (!anchorB && !maySleep(bodies, a)) {
        sleepSearch.marked[b] = 1;
    }
}

/// Each body that may be joined to others by itself, and not marked.
void beginSets(const Bodies& bodies, const Forces& forces, const Contacts& contacts, SleepSearch& sleepSearch) {
    SleepSearch& sleep = sleepSearch;
    sleep.parents.resize(bodies.records.size());
    sleep.marked.resize(bodies.records.size());
    const auto begin = [&](Slot slot) {
        sleep.parents[slot] = slot;
        sleep.marked[slot] = 0;
    };
    std::for_each(bodies.moving.begin(), bodies.moving.end(), begin);
    for (const Pair& pair : contacts.table.pairs) {
        begin(pair.bodyA);
        begin(pair.bodyB);
    }
    for (const ConnectorRecord& c : forces.connectors) {
        if (c.used) {
            begin(c.a);
            begin(c.b);
        }
    }
}

void joinIslands(const Bodies& bodies, const Forces& forces, const Contacts& contacts, SleepSearch& sleepSearch) {
    for (const Pair& pair : contacts.table.pairs) {
        const bool touches = pair.contact != Pair::none && contacts.pool[pair.contact].count > 0;
        if (pair.kind != PairKind::Sensor && touches) {
            join(bodies, sleepSearch, pair.bodyA, pair.bodyB);
        }
    }
    for (const ConnectorRecord& c : forces.connectors) {
        if (c.used && bodies.records[c.a].active && bodies.records[c.b].active) {
            join(bodies, sleepSearch, c.a, c.b);
        }
    }
}

void putToSleep(WorldData& data, Slot slot, Slot island, int iteration) {
    BodyRecord& record = data.bodies.records[slot];
    BodyMotion& m = data.bodies.motions[slot];
    BodyStep& s = data.bodies.steps[slot];
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
    data.bodies.motionBounds[slot] = s.motionBound;
    data.bodies.notePlannedMotion(slot);
    data.events.fellAsleep.push_back({iteration, data.bodies.idOf(slot)});
}

} // namespace

void disturb(Bodies& bodies, Sleep& sleep, Slot slot) {
    BodyRecord& record = bodies.records[slot];
    record.stillTime = 0;
    const bool moves = record.active && !record.asleep && record.kind != BodyKind::Static;
    if (!sleep.sleepers.empty() && !moves) {
        sleep.disturbed.push_back(slot);
    }
}

void wakeDisturbed(WorldData& data, int iteration) {
    std::vector<Slot>& disturbed = data.sleep.disturbed;
    if (disturbed.empty()) {
        return;
    }
    std::sort(disturbed.begin(), disturbed.end());
    disturbed.erase(std::unique(disturbed.begin(), disturbed.end()), disturbed.end());
    clearMarks(data.bodies, data.sleep, data.scratch.sleep);
    for (const Slot slot : disturbed) {
        markIsland(data.bodies, data.scratch.sleep, slot);
        if (data.bodies.records[slot].used && data.bodies.records[slot].kind == BodyKind::Static) {
            markNear(data.bodies, data.sleep, data.scratch.sleep, slot);
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
        data.scratch.sleep.marked.assign(data.bodies.records.size(), 1);
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
        if (data.bodies.records[slot].asleep && !isAnchor(data.bodies, slot)) {
            if (!any) {
                clearMarks(data.bodies, data.sleep, data.scratch.sleep);
            }
            markIsland(data.bodies, data.scratch.sleep, slot);
            any = true;
        }
    };
    for (const CircleContact& c : data.constraints.circleContacts) {
        touch(c.a);
        touch(c.b);
    }
    for (const GeneralContact& c : data.constraints.generalContacts) {
        touch(c.a);
        touch(c.b);
    }
    if (any) {
        restoreVelocities(data.bodies);
        wakeMarked(data, step.index);
        prepareSteps(data.bodies, step);
    }
    return any;
}

void fallAsleep(WorldData& data, double seconds, int iteration) {
    if (!data.sleep.allowed) {
        return;
    }
    bool anyReady = false;
    for (const Slot slot : data.bodies.moving) {
        double& stillTime = data.bodies.records[slot].stillTime;
        stillTime = isStill(data.bodies, slot) ? stillTime + seconds : 0;
        anyReady |= stillTime >= sleepDelay;
    }
    if (!anyReady) {
        return;
    }
    beginSets(data.bodies, data.forces, data.contacts, data.scratch.sleep); // and mark who stays awake
    joinIslands(data.bodies, data.forces, data.contacts, data.scratch.sleep);
    std::vector<Slot>& parents = data.scratch.sleep.parents;
    std::vector<std::uint8_t>& marked = data.scratch.sleep.marked;
    for (const Slot slot : data.bodies.moving) {
        if (marked[slot] != 0 || !maySleep(data.bodies, slot)) {
            marked[rootOf(parents, slot)] = 1;
        }
    }
    bool any = false;
    for (const Slot slot : data.bodies.moving) {
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
