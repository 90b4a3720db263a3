#include "core/physics/sleep/sleep.h"

#include "core/base/sort_unique.h"
#include "core/geometry/bounds.h"
#include "core/physics/broad_phase/pairs.h"
#include "core/physics/contacts/constraint_list.h"
#include "core/physics/sleep/touches.h"
#include "core/physics/solver/contact_graph.h"
#include "core/physics/solver/integrate.h"

#include <algorithm>

namespace spacetow {

namespace {

// A body may fall asleep after no point of it has been faster than this, m/s, for this time, s.
constexpr double sleepSpeed = 0.01;
constexpr double sleepDelay = 0.5;

/// Whether the body is slow enough to sleep. An immovable body has to stand still: however slow it is, its owner wants
/// it to move.
bool isStill(const Bodies& bodies, Slot slot) {
    const BodyMotion& m = bodies.motions[slot];
    const double speed =
        std::sqrt(m.velocity.squaredNorm()) + std::abs(m.angularVelocity) * bodies.steps[slot].outerRadius;
    return bodies.motions[slot].isMovable() ? speed < sleepSpeed : speed == 0;
}

bool maySleep(const Bodies& bodies, Slot slot) {
    const BodyRecord& record = bodies.records[slot];
    return record.kind == BodyKind::Static || record.asleep || record.stillTime >= sleepDelay;
}

bool sleeps(const Bodies& bodies, const Pair& pair) {
    return bodies.records[pair.bodyA].asleep && (pair.staticB || bodies.records[pair.bodyB].asleep);
}

/// Merges the two pair tables, which are sorted, and divides them again into sleeping pairs and awake ones.
void partitionPairs(const SleepStage& stage) {
    Sleep& sleep = stage.sleep;
    stage.newTable.clear();
    stage.search.newTable.clear();
    for (std::size_t i = 0, j = 0; i < stage.contacts.table.size() || j < sleep.table.size();) {
        const bool first =
            j == sleep.table.size() ||
            (i < stage.contacts.table.size() && stage.contacts.table.pairs[i].key() < sleep.table.pairs[j].key());
        const PairTable& from = first ? stage.contacts.table : sleep.table;
        const std::size_t index = first ? i++ : j++;
        (sleeps(stage.bodies, from.pairs[index]) ? stage.search.newTable : stage.newTable).addFrom(from, index);
    }
    std::swap(stage.contacts.table, stage.newTable);
    std::swap(sleep.table, stage.search.newTable);
}

/// Rebuilds all lists that depend on the set of sleeping bodies.
void rebuildLists(const SleepStage& stage) {
    releaseConstraints(stage.contacts, stage.constraints, stage.flags);
    Sleep& sleep = stage.sleep;
    sleep.sleepers.clear();
    for (const Slot slot : stage.bodies.nonStatic) {
        if (stage.bodies.records[slot].asleep) {
            sleep.sleepers.push_back(slot);
        }
    }
    partitionPairs(stage);
    listMoving(stage.bodies, stage.solver, stage.toi);
    listSensors(stage.contacts, stage.flags);
    relistTouchedTags(stage.bodies, stage.sleep);
}

void wake(const SleepStage& stage, Slot slot, int iteration) {
    BodyRecord& record = stage.bodies.records[slot];
    BodyStep& s = stage.bodies.steps[slot];
    record.asleep = false;
    record.stillTime = 0;
    const bool falls = record.kind == BodyKind::Dynamic && !record.positionFrozen;
    s.acceleration = falls ? stage.sleep.gravity : Vec2(0, 0);
    s.angularAcceleration = 0;
    stage.events.wokeUp.push_back({iteration, stage.bodies.idOf(slot)});
}

/// Wakes the bodies of all marked islands.
void wakeMarked(const SleepStage& stage, int iteration) {
    const std::vector<std::uint8_t>& marked = stage.search.marked;
    bool any = false;
    for (const Slot slot : stage.sleep.sleepers) {
        if (marked[stage.bodies.records[slot].island] != 0) {
            wake(stage, slot, iteration);
            any = true;
        }
    }
    if (any) {
        rebuildLists(stage);
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

/// Marks the islands of the bodies near the present place of a static body.
void markNear(const Bodies& bodies, const Sleep& sleep, SleepSearch& sleepSearch, Slot wall) {
    const Aabb box = boundsOf(*bodies.records[wall].parts, bodies.pose(wall));
    for (const Slot slot : sleep.sleepers) {
        if (bodies.records[slot].bounds.overlaps(box)) {
            markIsland(bodies, sleepSearch, slot);
        }
    }
}

/// Marks the islands that have a pair with a requested immovable body, or a connector to any requested body.
void markPartners(const SleepStage& stage, const std::vector<Slot>& requested) {
    const auto isRequested = [&](Slot slot) {
        return !stage.bodies.motions[slot].isMovable() && std::binary_search(requested.begin(), requested.end(), slot);
    };
    for (const Pair& pair : stage.sleep.table.pairs) {
        if (isRequested(pair.bodyA)) {
            markIsland(stage.bodies, stage.search, pair.bodyB);
        }
        if (isRequested(pair.bodyB)) {
            markIsland(stage.bodies, stage.search, pair.bodyA);
        }
    }
    for (const ConnectorRecord& c : stage.forces.connectors) {
        if (c.used && (std::binary_search(requested.begin(), requested.end(), c.a) ||
                       std::binary_search(requested.begin(), requested.end(), c.b))) {
            markIsland(stage.bodies, stage.search, c.a);
            markIsland(stage.bodies, stage.search, c.b);
        }
    }
}

/// Joins two bodies to one island. An immovable body that may not sleep keeps the other body awake.
void join(const Bodies& bodies, SleepSearch& sleepSearch, Slot a, Slot b) {
    const auto end = [&](Slot slot) { return EdgeEnd{slot, bodies.motions[slot].isMovable()}; };
    addEdge(sleepSearch.parents, end(a), end(b), [&](Slot immovable, Slot other) {
        if (!maySleep(bodies, immovable)) {
            sleepSearch.marked[other] = 1;
        }
    });
}

/// Begins with one set for each body that may be in an island, none of them marked.
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

/// Joins the bodies of each island. Marks bodies that an immovable body keeps awake.
void findIslands(const Bodies& bodies, const Forces& forces, const Contacts& contacts, SleepSearch& sleepSearch) {
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

void putToSleep(const SleepStage& stage, Slot slot, Slot island, int iteration) {
    BodyRecord& record = stage.bodies.records[slot];
    BodyMotion& m = stage.bodies.motions[slot];
    BodyStep& s = stage.bodies.steps[slot];
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
    stage.bodies.motionBounds[slot] = s.motionBound;
    stage.bodies.notePlannedMotion(slot);
    stage.events.fellAsleep.push_back({iteration, stage.bodies.idOf(slot)});
}

} // namespace

void requestWake(Bodies& bodies, Sleep& sleep, Slot slot) {
    BodyRecord& record = bodies.records[slot];
    record.stillTime = 0;
    const bool moves = record.active && !record.asleep && record.kind != BodyKind::Static;
    if (!sleep.sleepers.empty() && !moves) {
        sleep.wakeRequests.push_back(slot);
    }
}

void wakeRequested(const SleepStage& stage, int iteration) {
    std::vector<Slot>& requested = stage.sleep.wakeRequests;
    if (requested.empty()) {
        return;
    }
    sortUnique(requested);
    clearMarks(stage.bodies, stage.sleep, stage.search);
    for (const Slot slot : requested) {
        markIsland(stage.bodies, stage.search, slot);
        if (stage.bodies.records[slot].used && stage.bodies.records[slot].kind == BodyKind::Static) {
            markNear(stage.bodies, stage.sleep, stage.search, slot);
        }
    }
    markPartners(stage, requested);
    wakeMarked(stage, iteration);
    requested.clear();
}

void beginSleep(const SleepStage& stage, const Vec2& gravity) {
    Sleep& sleep = stage.sleep;
    const bool all = !sleep.sleepers.empty() && (!sleep.allowed || gravity != sleep.gravity);
    sleep.gravity = sleep.allowed ? gravity : Vec2(0, 0);
    if (all) {
        stage.search.marked.assign(stage.bodies.records.size(), 1);
        wakeMarked(stage, -1);
        sleep.wakeRequests.clear();
    }
    wakeRequested(stage, -1);
}

bool wakeTouched(const SleepStage& stage, const IterationStep& step) {
    if (stage.sleep.sleepers.empty()) {
        return false;
    }
    bool any = false;
    const auto touch = [&](Slot slot) {
        if (stage.bodies.records[slot].asleep && stage.bodies.motions[slot].isMovable()) {
            if (!any) {
                clearMarks(stage.bodies, stage.sleep, stage.search);
            }
            markIsland(stage.bodies, stage.search, slot);
            any = true;
        }
    };
    for (const CircleContact& c : stage.constraints.circleContacts) {
        touch(c.a);
        touch(c.b);
    }
    for (const GeneralContact& c : stage.constraints.generalContacts) {
        touch(c.a);
        touch(c.b);
    }
    if (any) {
        restoreVelocities(stage.bodies);
        wakeMarked(stage, step.index);
        prepareSteps(stage.bodies, step);
    }
    return any;
}

void fallAsleep(const SleepStage& stage, double seconds, int iteration) {
    if (!stage.sleep.allowed) {
        return;
    }
    bool anyReady = false;
    for (const Slot slot : stage.bodies.moving) {
        double& stillTime = stage.bodies.records[slot].stillTime;
        stillTime = isStill(stage.bodies, slot) ? stillTime + seconds : 0;
        anyReady |= stillTime >= sleepDelay;
    }
    if (!anyReady) {
        return;
    }
    beginSets(stage.bodies, stage.forces, stage.contacts, stage.search);
    findIslands(stage.bodies, stage.forces, stage.contacts, stage.search);
    std::vector<Slot>& parents = stage.search.parents;
    std::vector<std::uint8_t>& marked = stage.search.marked;
    for (const Slot slot : stage.bodies.moving) {
        if (marked[slot] != 0 || !maySleep(stage.bodies, slot)) {
            marked[rootOf(parents, slot)] = 1;
        }
    }
    bool any = false;
    for (const Slot slot : stage.bodies.moving) {
        const Slot island = rootOf(parents, slot);
        if (marked[island] == 0) {
            putToSleep(stage, slot, island, iteration);
            any = true;
        }
    }
    if (any) {
        rebuildLists(stage);
    }
}

} // namespace spacetow
