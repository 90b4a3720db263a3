#include "core/physics/solver/solve.h"

#include "core/physics/contacts/contact_rules.h"
#include "core/physics/lanes/solver_kernels.h"
#include "core/physics/solver/energy_limit.h"
#include "core/physics/solver/hold_back.h"
#include "core/physics/solver/solve_on.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace spacetow {

namespace {

// Overlap is reduced at this rate, 1/s, by at most this share an iteration and not faster than this, m/s.
constexpr double pushOutRate = 40;
constexpr double pushOutShare = 0.2;
constexpr double pushOutSpeed = 25;

constexpr int roundsOfSettling = 3;

// Contacts may change the way of a body in an iteration by as much, of its inner radius or m, without it meeting
// anything that is not known.
constexpr double smallDetour = 0.01;

void loadPaces(WorldData& data) {
    ContactBatches& batches = data.batches;
    batches.paces.resize(data.motions.size() + 1);
    batches.planned.resize(data.motions.size());
    batches.starts.resize(data.motions.size());
    batches.pushes.assign(data.motions.size() + 1, {});
    batches.paces.back() = {};
    for (const Slot slot : data.moving) {
        const BodyMotion& m = data.motions[slot];
        const BodyStep& s = data.steps[slot];
        batches.starts[slot] = {s.startVelocity.x(), s.startVelocity.y(), s.startAngularVelocity, 0};
        // Not a copy of the other: reading at once what was just written in parts stalls.
        batches.planned[slot] = {m.velocity.x(), m.velocity.y(), m.angularVelocity, 0};
        batches.paces[slot] = {m.velocity.x(), m.velocity.y(), m.angularVelocity, 0};
    }
}

void markTouch(WorldData& data, const RoundContact& c, bool touches) {
    data.table.marks[c.pair].now = touches;
}

void markTouch(WorldData& data, const GeneralContact& c, bool touches) {
    if (!c.merged) {
        data.table.marks[c.points[0].pair].now = touches;
    }
}

/// Each point of a merged contact belongs to a pair of its own. Of pairs without a point is known whether they touch
/// since they were merged: when that may have changed they are to be merged anew.
void markMerged(WorldData& data, GeneralContact& c) {
    const ConstraintBatch& batch = data.batches.general[c.lane.batch];
    const std::uint32_t i = c.lane.lane;
    std::array<bool, 2> touching{};
    bool any = false;
    bool open = false; // since more than the slop apart
    for (std::size_t k = 0; k < c.count; ++k) {
        const bool near = (k == 0 ? batch.separation1 : batch.separation2)[i] <= linearSlop;
        touching[k] = near || (k == 0 ? batch.impulse1 : batch.impulse2)[i] > 0;
        data.table.marks[c.points[k].pair].now |= touching[k];
        any |= touching[k];
        open |= !near;
    }
    data.mergeDoubt |= data.justListed ? any && open : touching != c.touching;
    c.touching = touching;
}

void markMerged(WorldData& data) {
    if (!data.absorbed.empty()) {
        for (GeneralContact& c : data.generalContacts) {
            if (c.merged) {
                markMerged(data, c);
            }
        }
    }
}

template <class Batch, class Kind>
void markTouches(WorldData& data, Batches<Batch>& batches, const std::vector<Kind>& contacts) {
    for (std::size_t i = 0; i < batches.size(); ++i) {
        BatchNotes& notes = batches.notes(i);
        const unsigned changed = notes.touches ^ notes.touched;
        for (unsigned lanes = changed; lanes != 0; lanes &= lanes - 1) {
            const auto lane = static_cast<unsigned>(std::countr_zero(lanes));
            markTouch(data, contacts[batches.shapes(i).owner[lane]], (notes.touches >> lane & 1) != 0);
        }
        notes.touched = notes.touches;
    }
}

/// What stopped an impact is not carried on.
void finishBounces(WorldData& data) {
    for (const RoundContact& c : data.roundContacts) {
        if (c.bounces) {
            RoundBatch& batch = data.batches.round[c.lane.batch];
            data.steps[c.a].bounced |= batch.normalImpulse[c.lane.lane] > 0;
            data.steps[c.b].bounced |= batch.normalImpulse[c.lane.lane] > 0;
            batch.normalImpulse[c.lane.lane] = batch.tangentImpulse[c.lane.lane] = 0;
        }
    }
    for (const GeneralContact& c : data.generalContacts) {
        if (!c.bounces) {
            continue;
        }
        ConstraintBatch& batch = data.batches.general[c.lane.batch];
        for (std::size_t k = 0; k < c.count; ++k) {
            Wide& impulse = k == 0 ? batch.impulse1 : batch.impulse2;
            if (c.points[k].bounces) {
                data.steps[c.a].bounced |= impulse[c.lane.lane] > 0;
                data.steps[c.b].bounced |= impulse[c.lane.lane] > 0;
                impulse[c.lane.lane] = 0;
            }
        }
        batch.tangentImpulse[c.lane.lane] = 0;
    }
}

/// What is held back has less energy; and what has less energy may have to be held back.
void settle(WorldData& data, double dt) {
    reserveForSolvingOn(data);
    for (int round = 0; round < roundsOfSettling; ++round) {
        const bool closes = measureVelocities(data.batches);
        const bool holds = closes && (round > 0 || solveOnWhereClosing(data));
        if (holds) {
            holdBack(data, dt);
        }
        if ((round > 0 && !holds) || !limitGain(data)) {
            return;
        }
    }
    measureVelocities(data.batches);
}

/// Bodies that the contacts pushed go where their new velocity takes them.
void takePaces(WorldData& data, double dt) {
    data.anyDiverted = false;
    for (const Slot slot : data.moving) {
        BodyMotion& m = data.motions[slot];
        BodyStep& s = data.steps[slot];
        const Pace& pace = data.batches.paces[slot];
        s.pushed =
            isPush({pace.x - m.velocity.x(), pace.y - m.velocity.y()}, (pace.turn - m.angularVelocity) * s.outerRadius);
        if (s.pushed) {
            m.velocity = {pace.x, pace.y};
            m.angularVelocity = pace.turn;
            const Vec2 change = dt * m.velocity - s.shift;
            const double turnChange = dt * m.angularVelocity - s.turn;
            s.diverted = std::abs(change.x()) + std::abs(change.y()) + std::abs(turnChange) * s.outerRadius >
                         std::max(smallDetour * s.innerRadius, linearSlop);
            data.anyDiverted |= s.diverted;
            s.shift = dt * m.velocity;
            s.turn = dt * m.angularVelocity;
            data.anyFast |= travelsFar(s);
        }
        if (s.bounced) { // flies freely from here on: the velocity is that at the end, the way is that of the mean
            s.shift -= 0.5 * dt * dt * s.acceleration;
        }
    }
}

} // namespace

void solveVelocities(WorldData& data, const IterationStep& step) {
    loadPaces(data);
    warmStart(data.batches);
    for (int pass = 0; pass < step.passes; ++pass) {
        solvePass(data.batches);
    }
    settle(data, step.dt);
    markTouches(data, data.batches.round, data.roundContacts);
    markTouches(data, data.batches.general, data.generalContacts);
    markMerged(data);
    if (data.anyBounce) {
        finishBounces(data);
    }
    const double share = std::min(pushOutShare, pushOutRate * step.dt);
    if (pushApart(data.batches, {step.dt, share, pushOutSpeed * step.dt})) {
        takePushes(data, step.dt);
    }
    takePaces(data, step.dt);
}

} // namespace spacetow
