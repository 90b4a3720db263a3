#include "core/physics/step/update.h"

#include "core/physics/broad_phase/find_pairs.h"
#include "core/physics/broad_phase/pairs.h"
#include "core/physics/contacts/constraint_list.h"
#include "core/physics/contacts/contact_pool.h"
#include "core/physics/contacts/narrow_phase.h"
#include "core/physics/def/stage_times.h"
#include "core/physics/sleep/sleep.h"
#include "core/physics/sleep/touches.h"
#include "core/physics/solver/contact_graph.h"
#include "core/physics/solver/crush.h"
#include "core/physics/solver/impulse_log.h"
#include "core/physics/solver/integrate.h"
#include "core/physics/solver/limit_penetration.h"
#include "core/physics/solver/moving_platforms.h"
#include "core/physics/solver/solve.h"
#include "core/physics/solver/time_of_impact.h"
#include "core/physics/step/body_lists.h"
#include "core/physics/step/deferred_changes.h"

#include <algorithm>

namespace spacetow {

namespace {

/// The views of the stages, made once for each update.
struct Stages {
    WorldData& data;
    PairStage pairs{data};
    ForceStage forces{data};
    ContactStage contacts{data};
    SolverStage solver{data};
    ToiStage toi{data};
    CrushStage crush{data};
    SleepStage sleep{data};
    TouchStage touches{data};
};

/// What has been done since the stage before belongs to this one.
void ended(const WorldData& data, StepStage stage) {
    if (data.scratch.times != nullptr) {
        data.scratch.times->end(stage);
    }
}

IterationStep iterationStep(const UpdateParameters& p) {
    const double dt = p.seconds / p.iterations;
    // Coarse iterations need up to 4 passes; fine ones converge from one iteration to the next.
    const int passes = std::clamp(8 / p.iterations, 2, 4);
    return {dt, dt / p.substeps, p.substeps, p.seconds, 0, passes};
}

// The most parts of one iteration.
constexpr int maxParts = 64;

/// The pairs of bodies that have left their fat AABBs, and what depends on pairs.
void refreshPairs(const Stages& stages, const IterationStep& step) {
    WorldData& data = stages.data;
    data.flags.pairsStale |= data.contacts.table.size() >= mostPairs(data.broadPhase);
    if (data.flags.pairsStale || !data.constraints.mergedPairs.empty()) {
        releaseConstraints(data.contacts, data.constraints, data.flags);
    }
    if (data.flags.pairsStale) {
        resetSlots(stages.solver, data.bodies.slotsToReset);
        data.bodies.slotsToReset.clear();
        resetManifolds(data.contacts);
    }
    if (findPairs(stages.pairs, step)) {
        freeContactsOfDropped(stages.contacts);
        changePairs(data.bodies, data.contacts, data.flags, data.scratch.changes);
        remapPairs(stages.contacts);
    }
    ended(data, StepStage::Pairs);
}

/// The motion as if nothing were touched, and the pairs for it. False when something was not finite.
bool planMotion(const Stages& stages, const IterationStep& step, bool first) {
    WorldData& data = stages.data;
    const double ahead = first ? step.remaining - step.dt : 0; // fat AABBs for a whole update, if they will do
    integrateVelocities(stages.forces, step);
    measureMotion(data.bodies, data.flags, data.scratch.search, ahead);
    const bool fault = data.flags.anyFault;
    if (fault) {
        isolateFaults(data.bodies, data.events, step.index);
        measureMotion(data.bodies, data.flags, data.scratch.search, ahead);
    }
    ended(data, StepStage::Motion);
    if (data.flags.anyMovedProxy) {
        refreshPairs(stages, step);
    }
    return !fault;
}

void stopWhatMeets(const Stages& stages, const IterationStep& step) {
    WorldData& data = stages.data;
    measureMotion(data.bodies, data.flags, data.scratch.search, 0);
    ended(data, StepStage::Impacts);
    if (data.flags.anyMovedProxy) {
        refreshPairs(stages, step);
    }
    stopAtImpacts(stages.toi);
    limitPenetrationOfFollowers(data.bodies, data.constraints, data.scratch.solver, step.dt);
    ended(data, StepStage::Impacts);
}

/// What a kinematic body pushes is kept out of what stands still.
void limitPushedByKinematic(const Stages& stages, const IterationStep& step) {
    WorldData& data = stages.data;
    measureCorrections(data.bodies, data.flags, data.scratch.solver, data.scratch.search);
    if (data.flags.anyMovedProxy) {
        refreshPairs(stages, step);
    }
    keepOutOfStatics(stages.crush, step.index);
}

void makeMotion(const Stages& stages, const IterationStep& step) {
    WorldData& data = stages.data;
    findContacts(stages.contacts, step);
    while (wakeTouched(stages.sleep, step)) {
        planMotion(stages, step, false);
        findContacts(stages.contacts, step);
    }
    ended(data, StepStage::Contacts);
    findComponents(stages.solver);
    markPushedByKinematic(data.bodies, data.contactGraph, data.scratch.solver);
    solveVelocities(stages.solver, step);
    findPlatforms(data.bodies, data.contacts.table, data.constraints);
    ended(data, StepStage::Solver);
    if (data.flags.anyFast || data.flags.anySweep || data.flags.anyDeflected) {
        stopWhatMeets(stages, step);
    }
    moveWithPlatforms(data.bodies);
    ended(data, StepStage::Advance);
    if (mayCrush(stages.crush)) {
        limitPushedByKinematic(stages, step);
    } else {
        data.crushed.clear();
    }
    ended(data, StepStage::Crush);
    advance(data.bodies, step.dt);
    ended(data, StepStage::Advance);
    findOverlaps(data.bodies, data.contacts);
    reportTouches(stages.touches, step.index);
    ended(data, StepStage::Touches);
}

void setDuration(Bodies& bodies, IterationStep& step, double dt) {
    step.dt = dt;
    step.substep = dt / step.substeps;
    prepareSteps(bodies, step);
}

void makePart(const Stages& stages, const IterationStep& step, double whole) {
    beginPart(stages.contacts, step.dt / whole);
    makeMotion(stages, step);
    endPart(stages.contacts, step.dt / whole);
}

/// The iteration as planned is too long: it is made in parts.
void iterateInParts(const Stages& stages, IterationStep step, double share) {
    WorldData& data = stages.data;
    const double whole = step.dt;
    const std::size_t reports = data.events.tagsTouched.size();
    double left = whole;
    for (int parts = maxParts - 1; share < 1; --parts) {
        restoreVelocities(data.bodies);
        setDuration(data.bodies, step, share * left);
        planMotion(stages, step, false);
        makePart(stages, step, whole);
        left -= step.dt;
        step.remaining -= step.dt;
        setDuration(data.bodies, step, left);
        const bool sound = planMotion(stages, step, false);
        share = sound && data.flags.anyFast && parts > 1 ? safeFraction(data.bodies, data.contacts, 1.0 / parts) : 1;
    }
    makePart(stages, step, whole);
    setDuration(data.bodies, step, whole);
    joinTagReports(data.events, reports);
}

void iterate(const Stages& stages, const IterationStep& step) {
    WorldData& data = stages.data;
    if (data.bodies.moving.empty() && !data.sleep.sleepers.empty()) {
        reportTouches(stages.touches, step.index);
        return;
    }
    const bool sound = planMotion(stages, step, step.index == 0);
    const double share = sound && data.flags.anyFast ? safeFraction(data.bodies, data.contacts, 1.0 / maxParts) : 1;
    if (share < 1) {
        iterateInParts(stages, step, share);
    } else {
        makeMotion(stages, step);
    }
}

} // namespace

void updateWorld(WorldData& data, const UpdateParameters& parameters) {
    if (data.scratch.times != nullptr) {
        data.scratch.times->begin();
    }
    const Stages stages{data};
    data.events.clear();
    if (data.impulses.on) {
        beginImpulseLog(data.impulses, parameters.seconds);
    }
    beginSleep(stages.sleep, parameters.gravity);
    applyPending(data, -1);
    if (data.flags.connectionsStale) {
        refreshConnections(data.bodies, data.forces, data.flags);
    }
    IterationStep step = iterationStep(parameters);
    refreshBodyLists(data);
    prepareMotion(data.bodies, step, parameters.gravity);
    ended(data, StepStage::Changes);
    for (step.index = 0; step.index < parameters.iterations; ++step.index) {
        iterate(stages, step);
        step.remaining -= step.dt;
        if (applyPending(data, step.index)) {
            refreshBodyLists(data);
            prepareSteps(data.bodies, step);
            ended(data, StepStage::Changes);
        }
    }
    saveAllImpulses(data.contacts, data.constraints, data.flags);
    fallAsleep(stages.sleep, parameters.seconds, parameters.iterations - 1);
    collectTouchedTags(data.bodies, data.contacts, data.sleep);
    ended(data, StepStage::Sleep);
}

} // namespace spacetow
