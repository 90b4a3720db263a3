#include "core/physics/broad_phase/pairs.h"

#include "core/physics/broad_phase/find_pairs.h"
#include "core/physics/broad_phase/pair_changes.h"
#include "core/physics/broad_phase/statics.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace spacetow {

namespace {

bool isSensor(const Pair& pair) {
    return pair.kind == PairKind::Sensor;
}

template <class T>
void clearSlots(std::vector<T>& list, const std::vector<Slot>& slots) {
    for (const Slot slot : slots) {
        if (slot < list.size()) {
            list[slot] = T{};
        }
    }
}

/// What the solver keeps by slot of those that have moved begins anew: it writes no other.
void clearBySlot(Scratch& scratch, const std::vector<Slot>& moved) {
    clearSlots(scratch.solver.velocities, moved);
    clearSlots(scratch.solver.corrections, moved);
    clearSlots(scratch.solver.driven, moved);
    clearSlots(scratch.solver.unconverged, moved);
    clearSlots(scratch.solver.limited, moved);
    clearSlots(scratch.toi.shortenedAt, moved);
    for (const Slot slot : moved) {
        if (slot < scratch.solver.fractions.size()) {
            scratch.solver.fractions[slot] = 1;
        }
    }
}

// Up to so many are put into the lists one by one.
constexpr std::size_t fewBodies = 64;

bool isNonStatic(const BodyRecord& record) {
    return record.used && record.kind != BodyKind::Static;
}

/// In a sorted list, or not.
void put(std::vector<Slot>& list, Slot slot, bool in) {
    const auto at = std::lower_bound(list.begin(), list.end(), slot);
    const bool listed = at != list.end() && *at == slot;
    if (in && !listed) {
        list.insert(at, slot);
    } else if (!in && listed) {
        list.erase(at);
    }
}

void relist(Bodies& bodies, Slot slot) {
    const BodyRecord& record = bodies.records[slot];
    put(bodies.nonStatic, slot, isNonStatic(record));
    put(bodies.reporters, slot, record.used && record.reportsTouches);
}

void listBodies(Bodies& bodies) {
    bodies.nonStatic.clear();
    bodies.reporters.clear();
    for (Slot slot = 0; slot < bodies.records.size(); ++slot) {
        const BodyRecord& record = bodies.records[slot];
        if (isNonStatic(record)) {
            bodies.nonStatic.push_back(slot);
        }
        if (record.used && record.reportsTouches) {
            bodies.reporters.push_back(slot);
        }
    }
}

} // namespace

void listSensors(Contacts& contacts, StepFlags& flags) {
    contacts.sensors.clear();
    for (std::uint32_t i = 0; i < contacts.table.size(); ++i) {
        if (isSensor(contacts.table.pairs[i])) {
            contacts.sensors.push_back(i);
        }
    }
    flags.islandsStale = true;
}

void listMoving(WorldData& data) {
    clearBySlot(data.scratch, data.bodies.moving);
    data.bodies.moving.clear();
    for (const BodyKind kind : {BodyKind::Kinematic, BodyKind::Dynamic}) {
        for (const Slot slot : data.bodies.nonStatic) {
            const BodyRecord& record = data.bodies.records[slot];
            if (record.active && !record.asleep && record.kind == kind) {
                data.bodies.moving.push_back(slot);
            }
        }
    }
}

void prepareStructure(WorldData& data) {
    refreshStatics(data);
    data.flags.pairsStale |= std::exchange(data.flags.crowded, false);
    const std::size_t count = data.bodies.records.size();
    data.bodies.motionBounds.resize(count);
    data.bodies.mayNeedToi.resize(count);
    data.bodies.plannedMotions.resize(count);
    data.bodies.extents.resize(count);
    data.bodies.touchedTags.resize(count);
    if (data.sleep.allowed) {
        data.scratch.sleep.parents.resize(count);
        data.scratch.sleep.marked.resize(count);
    }
    if (data.bodies.changedBodies.empty()) {
        return;
    }
    if (data.bodies.changedBodies.size() <= fewBodies) {
        std::for_each(data.bodies.changedBodies.begin(), data.bodies.changedBodies.end(),
                      [&](Slot slot) { relist(data.bodies, slot); });
    } else {
        listBodies(data.bodies);
    }
    listMoving(data);
    for (const Slot slot : data.bodies.changedBodies) {
        data.bodies.motionBounds[slot] = data.bodies.records[slot].asleep ? data.bodies.steps[slot].motionBound : 0;
        data.bodies.mayNeedToi[slot] = 0;
        data.bodies.touchedTags[slot] = TagMask{};
    }
    data.bodies.renewed.insert(data.bodies.renewed.end(), data.bodies.changedBodies.begin(),
                               data.bodies.changedBodies.end());
    data.bodies.changedBodies.clear();
    data.flags.pairsStale = true;
}

void measureMotion(Bodies& bodies, StepFlags& flags, PairSearch& search, double ahead) {
    flags.anyMovedProxy = flags.pairsStale;
    flags.anyFault = flags.anyFast = false;
    search.movedBodies.clear();
    for (const Slot slot : bodies.moving) {
        BodyStep& s = bodies.steps[slot];
        const BodyMotion& m = bodies.motions[slot];
        const double reach = s.maxMotion();
        flags.anyFault |= !isSound(m, s);
        bodies.motionBounds[slot] = s.motionBound + reach;
        bodies.notePlannedMotion(slot);
        const bool far = exceedsMargin(s, reach);
        flags.anyFast |= far;
        bodies.mayNeedToi[slot] = far || s.bouncing || s.deflected ? 1 : 0;
        s.movedProxy = !s.fat.centers.contains(m.center) ||
                       !s.fat.centers.contains(Vec2(m.center + s.deltaPosition + ahead * m.velocity)) ||
                       std::abs(s.deltaAngle + ahead * m.angularVelocity) > s.fat.angleLeft;
        if (s.movedProxy) {
            search.movedBodies.push_back(slot);
        }
    }
    flags.anyMovedProxy |= !search.movedBodies.empty();
}

bool findPairs(WorldData& data, const IterationStep& step) {
    if (data.flags.pairsStale) {
        listProxies(data.bodies, data.broadPhase, data.sleep, data.scratch.search);
    }
    enlargeAabbs(data.bodies, data.broadPhase, data.scratch.search, step.remaining);
    collectPairs(data);
    data.flags.anyMovedProxy = false;
    return comparePairs(data);
}

void changePairs(const Bodies& bodies, Contacts& contacts, StepFlags& flags, PairChanges& changes) {
    changeTable(bodies, contacts, flags, changes);
    flags.islandsStale = true;
    if (flags.pairsStale || !contacts.sensors.empty() ||
        std::any_of(changes.newPairs.begin(), changes.newPairs.end(), isSensor)) {
        listSensors(contacts, flags);
    }
    flags.pairsStale = false;
}

} // namespace spacetow
