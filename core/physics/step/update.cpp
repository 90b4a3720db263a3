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

/// Adds the time since the last call to the stage, if stages are timed.
void recordTime(const WorldData& data, StepStage stage) {
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

/// Finds the pairs of moved proxies, and updates the data that depends on pairs.
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
    recordTime(data, StepStage::Pairs);
}

/// Integrates without contacts, and finds the pairs for this motion. Returns false if a state was not finite.
bool predictMotion(const Stages& stages, const IterationStep& step, bool first) {
    WorldData& data = stages.data;
    // In the first iteration a fat AABB is enlarged unless it contains the motion of the whole update.
    const double ahead = first ? step.remaining - step.dt : 0;
    integrateVelocities(stages.forces, step);
    measureMotion(data.bodies, data.flags, data.scratch.search, ahead);
    const bool fault = data.flags.anyFault;
    if (fault) {
        isolateFaults(data.bodies, data.events, step.index);
        measureMotion(data.bodies, data.flags, data.scratch.search, ahead);
    }
    recordTime(data, StepStage::Motion);
    if (data.flags.anyMovedProxy) {
        refreshPairs(stages, step);
    }
    return !fault;
}

void stopAtTimesOfImpact(const Stages& stages, const IterationStep& step) {
    WorldData& data = stages.data;
    measureMotion(data.bodies, data.flags, data.scratch.search, 0);
    recordTime(data, StepStage::Impacts);
    if (data.flags.anyMovedProxy) {
        refreshPairs(stages, step);
    }
    stopAtImpacts(stages.toi);
    limitPenetrationOfFollowers(data.bodies, data.constraints, data.scratch.solver, step.dt);
    recordTime(data, StepStage::Impacts);
}

/// Keeps bodies that a kinematic body pushes out of immovable ones.
void limitPushedBodies(const Stages& stages, const IterationStep& step) {
    WorldData& data = stages.data;
    findDisplaced(data.bodies, data.flags, data.scratch.solver, data.scratch.search);
    if (data.flags.anyMovedProxy) {
        refreshPairs(stages, step);
    }
    keepOutOfStatics(stages.crush, step.index);
}

void collideAndMove(const Stages& stages, const IterationStep& step) {
    WorldData& data = stages.data;
    findContacts(stages.contacts, step);
    while (wakeTouched(stages.sleep, step)) {
        predictMotion(stages, step, false);
        findContacts(stages.contacts, step);
    }
    recordTime(data, StepStage::Contacts);
    findComponents(stages.solver);
    markPushedByKinematic(data.bodies, data.contactGraph, data.scratch.solver);
    solveVelocities(stages.solver, step);
    findPlatforms(data.bodies, data.contacts.table, data.constraints);
    recordTime(data, StepStage::Solver);
    if (data.flags.anyFast || data.flags.anySweep || data.flags.anyDeflected) {
        stopAtTimesOfImpact(stages, step);
    }
    moveWithPlatforms(data.bodies);
    recordTime(data, StepStage::Advance);
    if (mayCrush(stages.crush)) {
        limitPushedBodies(stages, step);
    } else {
        data.crushed.clear();
    }
    recordTime(data, StepStage::Crush);
    advance(data.bodies, step.dt);
    recordTime(data, StepStage::Advance);
    findOverlaps(data.bodies, data.contacts);
    reportTouches(stages.touches, step.index);
    recordTime(data, StepStage::Touches);
}

void setLength(Bodies& bodies, IterationStep& step, double dt) {
    step.dt = dt;
    step.substep = dt / step.substeps;
    prepareSteps(bodies, step);
}

void runPart(const Stages& stages, const IterationStep& step, double whole) {
    beginPart(stages.contacts, step.dt / whole);
    collideAndMove(stages, step);
    endPart(stages.contacts, step.dt / whole);
}

/// Divides the iteration into parts; `share` is the fraction of the first one.
void iterateInParts(const Stages& stages, IterationStep step, double share) {
    WorldData& data = stages.data;
    const double whole = step.dt;
    const std::size_t reports = data.events.tagsTouched.size();
    double left = whole;
    for (int parts = maxParts - 1; share < 1; --parts) {
        restoreVelocities(data.bodies);
        setLength(data.bodies, step, share * left);
        predictMotion(stages, step, false);
        runPart(stages, step, whole);
        left -= step.dt;
        step.remaining -= step.dt;
        setLength(data.bodies, step, left);
        const bool sound = predictMotion(stages, step, false);
        share = sound && data.flags.anyFast && parts > 1 ? safeFraction(data.bodies, data.contacts, 1.0 / parts) : 1;
    }
    runPart(stages, step, whole);
    setLength(data.bodies, step, whole);
    joinTagReports(data.events, reports);
}

void iterate(const Stages& stages, const IterationStep& step) {
    WorldData& data = stages.data;
    if (data.bodies.moving.empty() && !data.sleep.sleepers.empty()) {
        reportTouches(stages.touches, step.index);
        return;
    }
    const bool sound = predictMotion(stages, step, step.index == 0);
    const double share = sound && data.flags.anyFast ? safeFraction(data.bodies, data.contacts, 1.0 / maxParts) : 1;
    if (share < 1) {
        iterateInParts(stages, step, share);
    } else {
        collideAndMove(stages, step);
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
    recordTime(data, StepStage::Changes);
    for (step.index = 0; step.index < parameters.iterations; ++step.index) {
        iterate(stages, step);
        step.remaining -= step.dt;
        if (applyPending(data, step.index)) {
            refreshBodyLists(data);
            prepareSteps(data.bodies, step);
            recordTime(data, StepStage::Changes);
        }
    }
    saveAllImpulses(data.contacts, data.constraints, data.flags);
    fallAsleep(stages.sleep, parameters.seconds, parameters.iterations - 1);
    collectTouchedTags(data.bodies, data.contacts, data.sleep);
    recordTime(data, StepStage::Sleep);
}

} // namespace spacetow
