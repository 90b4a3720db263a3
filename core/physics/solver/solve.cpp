#include "core/physics/solver/solve.h"

#include "core/physics/contacts/contact_rules.h"
#include "core/physics/lanes/solver_kernels.h"
#include "core/physics/solver/contact_graph.h"
#include "core/physics/solver/energy_limit.h"
#include "core/physics/solver/impulse_log.h"
#include "core/physics/solver/limit_penetration.h"
#include "core/physics/solver/solve_unconverged.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace spacetow {

namespace {

// Overlap is reduced at this rate, 1/s, by at most this share an iteration and not faster than this, m/s.
constexpr double correctionRate = 40;
constexpr double correctionShare = 0.2;
constexpr double correctionSpeed = 25;

constexpr int roundsOfConverging = 3;

// Contacts may change the way of a body in an iteration by as much, of its inner radius or m, without it meeting
// anything that is not known.
constexpr double smallDeflection = 0.01;

void gatherVelocities(const Bodies& bodies, SolverScratch& solver) {
    SolverScratch& scratch = solver;
    scratch.velocities.resize(bodies.motions.size() + 1);
    scratch.plannedVelocities.resize(bodies.motions.size());
    scratch.startVelocities.resize(bodies.motions.size());
    beginBySlot(scratch.corrections, bodies.motions.size() + 1, BodyVelocity{});
    scratch.velocities.back() = scratch.corrections.back() = {};
    for (const Slot slot : bodies.moving) {
        const BodyMotion& m = bodies.motions[slot];
        const BodyStep& s = bodies.steps[slot];
        scratch.corrections[slot] = {};
        scratch.startVelocities[slot] = {s.startVelocity.x(), s.startVelocity.y(), s.startAngularVelocity, 0};
        // Not a copy of the other: reading at once what was just written in parts stalls.
        scratch.plannedVelocities[slot] = {m.velocity.x(), m.velocity.y(), m.angularVelocity, 0};
        scratch.velocities[slot] = {m.velocity.x(), m.velocity.y(), m.angularVelocity, 0};
    }
}

void markTouch(Contacts& contacts, const CircleContact& c, bool touches) {
    contacts.table.flags[c.pair].touching = touches;
}

void markTouch(Contacts& contacts, const GeneralContact& c, bool touches) {
    if (!c.merged) {
        contacts.table.flags[c.points[0].pair].touching = touches;
    }
}

/// Each point of a merged contact belongs to a pair of its own. Of pairs without a point is known whether they touch
/// since they were merged: when that may have changed they are to be merged anew.
void markMerged(Contacts& contacts, Constraints& constraints, StepFlags& flags, GeneralContact& c) {
    const ConstraintBatch& batch = constraints.batches.general[c.lane.batch];
    const std::uint32_t i = c.lane.lane;
    std::array<bool, 2> touching{};
    bool any = false;
    bool open = false; // since more than the slop apart
    for (std::size_t k = 0; k < c.count; ++k) {
        const bool near = (k == 0 ? batch.separation1 : batch.separation2)[i] <= linearSlop;
        touching[k] = near || (k == 0 ? batch.impulse1 : batch.impulse2)[i] > 0;
        contacts.table.flags[c.points[k].pair].touching |= touching[k];
        any |= touching[k];
        open |= !near;
    }
    flags.mergeStale |= flags.constraintsRebuilt ? any && open : touching != c.touching;
    c.touching = touching;
}

void markMerged(Contacts& contacts, Constraints& constraints, StepFlags& flags) {
    if (!constraints.mergedPairs.empty()) {
        for (GeneralContact& c : constraints.generalContacts) {
            if (c.merged) {
                markMerged(contacts, constraints, flags, c);
            }
        }
    }
}

template <class Batch, class Kind>
void markTouches(Contacts& contacts, Batches<Batch>& batches, const std::vector<Kind>& list) {
    for (std::size_t i = 0; i < batches.size(); ++i) {
        BatchFlags& flags = batches.flags(i);
        const unsigned changed = flags.touches ^ flags.touched;
        for (unsigned lanes = changed; lanes != 0; lanes &= lanes - 1) {
            const auto lane = static_cast<unsigned>(std::countr_zero(lanes));
            markTouch(contacts, list[batches.anchors(i).owner[lane]], (flags.touches >> lane & 1) != 0);
        }
        flags.touched = flags.touches;
    }
}

/// What stopped an impact is not carried on.
void finishBounces(Bodies& bodies, Constraints& constraints) {
    for (const CircleContact& c : constraints.circleContacts) {
        if (c.bounces) {
            CircleBatch& batch = constraints.batches.circles[c.lane.batch];
            bodies.steps[c.a].bounced |= batch.normalImpulse[c.lane.lane] > 0;
            bodies.steps[c.b].bounced |= batch.normalImpulse[c.lane.lane] > 0;
            batch.normalImpulse[c.lane.lane] = batch.tangentImpulse[c.lane.lane] = 0;
        }
    }
    for (const GeneralContact& c : constraints.generalContacts) {
        if (!c.bounces) {
            continue;
        }
        ConstraintBatch& batch = constraints.batches.general[c.lane.batch];
        for (std::size_t k = 0; k < c.count; ++k) {
            Wide& impulse = k == 0 ? batch.impulse1 : batch.impulse2;
            if (c.points[k].bounces) {
                bodies.steps[c.a].bounced |= impulse[c.lane.lane] > 0;
                bodies.steps[c.b].bounced |= impulse[c.lane.lane] > 0;
                impulse[c.lane.lane] = 0;
            }
        }
        batch.tangentImpulse[c.lane.lane] = 0;
    }
}

/// What is held back has less energy; and what has less energy may have to be held back.
void converge(const SolverStage& stage, double dt) {
    reserveForUnconverged(stage);
    if (stage.flags.constraintsRebuilt) { // as after each change of a mass that contacts bear
        solveReweighed(stage);
    }
    for (int round = 0; round < roundsOfConverging; ++round) {
        const bool closes = measureVelocities(stage.constraints.batches, stage.solver.velocities);
        const bool holds = closes && (round > 0 || solveClosingComponents(stage));
        if (holds) {
            limitPenetration(stage.bodies, stage.constraints, stage.solver, dt);
        }
        if ((round > 0 && !holds) || !limitEnergyGain(stage)) {
            return;
        }
    }
    measureVelocities(stage.constraints.batches, stage.solver.velocities);
}

/// Bodies that the contacts pushed go where their new velocity takes them.
void applyVelocities(Bodies& bodies, StepFlags& flags, const SolverScratch& solver, double dt) {
    flags.anyDeflected = false;
    for (const Slot slot : bodies.moving) {
        BodyMotion& m = bodies.motions[slot];
        BodyStep& s = bodies.steps[slot];
        const BodyVelocity& velocity = solver.velocities[slot];
        s.pushed = isPush({velocity.x - m.velocity.x(), velocity.y - m.velocity.y()},
                          (velocity.angular - m.angularVelocity) * s.outerRadius);
        if (s.pushed) {
            m.velocity = {velocity.x, velocity.y};
            m.angularVelocity = velocity.angular;
            const Vec2 change = dt * m.velocity - s.deltaPosition;
            const double turnChange = dt * m.angularVelocity - s.deltaAngle;
            s.deflected = std::abs(change.x()) + std::abs(change.y()) + std::abs(turnChange) * s.outerRadius >
                          std::max(smallDeflection * s.innerRadius, linearSlop);
            flags.anyDeflected |= s.deflected;
            s.deltaPosition = dt * m.velocity;
            s.deltaAngle = dt * m.angularVelocity;
            flags.anyFast |= isFast(s);
        }
        if (s.bounced) { // flies freely from here on: the velocity is that at the end, the way is that of the mean
            s.deltaPosition -= 0.5 * dt * dt * s.acceleration;
        }
    }
}

} // namespace

void solveVelocities(const SolverStage& stage, const IterationStep& step) {
    gatherVelocities(stage.bodies, stage.solver);
    warmStart(stage.constraints.batches, stage.solver.velocities);
    for (int pass = 0; pass < step.passes; ++pass) {
        solvePass(stage.constraints.batches, stage.solver.velocities);
    }
    converge(stage, step.dt);
    markTouches(stage.contacts, stage.constraints.batches.circles, stage.constraints.circleContacts);
    markTouches(stage.contacts, stage.constraints.batches.general, stage.constraints.generalContacts);
    markMerged(stage.contacts, stage.constraints, stage.flags);
    if (stage.impulses.on) {
        logImpulses(stage.bodies, stage.constraints, stage.impulses);
    }
    if (stage.flags.anyBounce) {
        finishBounces(stage.bodies, stage.constraints);
    }
    const double share = std::min(correctionShare, correctionRate * step.dt);
    if (correctPositions(stage.constraints.batches, stage.solver.corrections,
                         {step.dt, share, correctionSpeed * step.dt})) {
        applyCorrections(stage, step.dt);
    }
    applyVelocities(stage.bodies, stage.flags, stage.solver, step.dt);
}

} // namespace spacetow
