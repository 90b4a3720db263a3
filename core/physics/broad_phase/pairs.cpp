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

/// Clears the scratch data by slot of the bodies that were listed as moving: the solver writes no other slots.
void clearBySlot(SolverScratch& solver, ToiSearch& toi, const std::vector<Slot>& moved) {
    clearSlots(solver.velocities, moved);
    clearSlots(solver.corrections, moved);
    clearSlots(solver.pushedByKinematic, moved);
    clearSlots(solver.unconverged, moved);
    clearSlots(solver.limited, moved);
    clearSlots(toi.shortenedAt, moved);
    for (const Slot slot : moved) {
        if (slot < solver.fractions.size()) {
            solver.fractions[slot] = 1;
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
    flags.contactGraphStale = true;
}

void listMoving(Bodies& bodies, SolverScratch& solver, ToiSearch& toi) {
    clearBySlot(solver, toi, bodies.moving);
    bodies.moving.clear();
    for (const BodyKind kind : {BodyKind::Kinematic, BodyKind::Dynamic}) {
        for (const Slot slot : bodies.nonStatic) {
            const BodyRecord& record = bodies.records[slot];
            if (record.active && !record.asleep && record.kind == kind) {
                bodies.moving.push_back(slot);
            }
        }
    }
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

bool findPairs(const PairStage& stage, const IterationStep& step) {
    if (stage.flags.pairsStale) {
        listProxies(stage.bodies, stage.broadPhase, stage.sleep, stage.search);
    }
    enlargeAabbs(stage.bodies, stage.broadPhase, stage.search, step.remaining);
    collectPairs(stage);
    stage.flags.anyMovedProxy = false;
    return comparePairs(stage);
}

void changePairs(const Bodies& bodies, Contacts& contacts, StepFlags& flags, PairChanges& changes) {
    changeTable(bodies, contacts, flags, changes);
    flags.contactGraphStale = true;
    if (flags.pairsStale || !contacts.sensors.empty() ||
        std::any_of(changes.newPairs.begin(), changes.newPairs.end(), isSensor)) {
        listSensors(contacts, flags);
    }
    flags.pairsStale = false;
}

} // namespace spacetow
