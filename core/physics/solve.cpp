#include "core/physics/solve.h"

#include "core/physics/contact_rules.h"
#include "core/physics/energy_limit.h"
#include "core/physics/hold_back.h"

#include <algorithm>
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

// What is known of contacts lies in the order in which they came about: it is fetched this long before it is needed.
constexpr std::size_t contactsAhead = 8;

// What no velocity falls short of.
constexpr double noTarget = -1e30;

void loadPaces(WorldData& data) {
    ContactBatches& batches = data.batches;
    batches.paces.resize(data.motions.size() + 1);
    batches.planned.resize(data.motions.size());
    batches.starts.resize(data.motions.size());
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

/// Two points with nearly the same effect make the system singular: the one that overlaps more acts for both. A point
/// at which no push can move anything does not act at all.
void packBlock(const Constraint& c, ConstraintBatch& batch, std::uint32_t i, double perSecond) {
    const ConstraintPoint& p = c.points[0];
    const ConstraintPoint& q = c.points[1];
    const bool acts1 = p.normalMass > 0;
    const bool acts2 = c.count == 2 && q.normalMass > 0;
    const double mass1 = acts1 ? p.normalMass : 1;
    const double mass2 = acts2 ? q.normalMass : mass1;
    const double k11 = 1 / mass1;
    const double k22 = 1 / mass2;
    double coupling = acts1 && acts2 ? c.coupling : 0;
    double determinant = k11 * k22 - coupling * coupling;
    batch.target1[i] = acts1 ? p.target : noTarget;
    batch.target2[i] = acts2 ? q.target : noTarget;
    batch.impulse1[i] = p.normalImpulse;
    batch.impulse2[i] = q.normalImpulse;
    const double largest = std::max(k11, k22);
    if (acts1 && acts2 && largest * largest >= 1000 * determinant) {
        const bool first = p.separation <= q.separation;
        (first ? batch.target2 : batch.target1)[i] = noTarget;
        (first ? batch.impulse1 : batch.impulse2)[i] = p.normalImpulse + q.normalImpulse;
        (first ? batch.impulse2 : batch.impulse1)[i] = 0;
        coupling = 0;
        determinant = k11 * k22;
    }
    batch.leverA1[i] = p.leverA;
    batch.leverB1[i] = p.leverB;
    batch.leverA2[i] = q.leverA;
    batch.leverB2[i] = q.leverB;
    batch.k11[i] = k11;
    batch.k22[i] = k22;
    batch.mass1[i] = mass1;
    batch.mass2[i] = mass2;
    batch.coupling[i] = coupling;
    batch.inverseDeterminant[i] = 1 / determinant;
    batch.closing1[i] = -perSecond * roomToClose(p.separation);
    batch.closing2[i] = c.count == 2 ? -perSecond * roomToClose(q.separation) : noTarget;
}

void packGeneral(WorldData& data, double perSecond) {
    Batches<ConstraintBatch>& batches = data.batches.general;
    batches.reset(data.motions.size());
    for (Constraint& c : data.constraints) {
        const BodyMotion& a = data.motions[c.a];
        const BodyMotion& b = data.motions[c.b];
        c.lane = batches.open(c.a, a.yields(), c.b, b.yields());
        ConstraintBatch& batch = batches[c.lane.batch];
        const std::uint32_t i = c.lane.lane;
        batch.normalX[i] = c.normal.x();
        batch.normalY[i] = c.normal.y();
        batch.massA[i] = a.inverseMass;
        batch.massB[i] = b.inverseMass;
        batch.inertiaA[i] = a.inverseInertia;
        batch.inertiaB[i] = b.inverseInertia;
        batch.tangentLeverA[i] = c.tangentLeverA;
        batch.tangentLeverB[i] = c.tangentLeverB;
        batch.tangentMass[i] = c.tangentMass;
        batch.friction[i] = c.friction;
        batch.tangentImpulse[i] = c.tangentImpulse;
        packBlock(c, batch, i, perSecond);
    }
}

/// The way that the surfaces at a point are pushed apart in this iteration, as an impulse, kg m.
double wayOut(double separation, double velocity, double normalMass, double dt) {
    const double excess = -linearSlop - separation - dt * std::max(velocity, 0.0);
    return excess > 0 ? std::min(std::min(pushOutShare, pushOutRate * dt) * excess, pushOutSpeed * dt) * normalMass : 0;
}

/// What it costs to push two bodies apart, J: the work against the forces that act on them.
void noteWork(WorldData& data, Slot a, Slot b, const Vec2& push, double dt) {
    const ContactBatches& batches = data.batches;
    const Pace& startA = batches.starts[a];
    const Pace& startB = batches.starts[b];
    const Pace& plannedA = batches.planned[a];
    const Pace& plannedB = batches.planned[b];
    const double work = push.x() * (startB.x - plannedB.x - startA.x + plannedA.x) +
                        push.y() * (startB.y - plannedB.y - startA.y + plannedA.y);
    data.islands.balances[data.islands.roots[data.motions[a].yields() ? a : b]].pushes += work / dt;
}

void pushApart(WorldData& data, const RoundContact& c, const RoundBatch& batch, double way) {
    const std::uint32_t i = c.lane.lane;
    const Vec2 push = way * Vec2(batch.normalX[i], batch.normalY[i]);
    data.steps[c.a].push -= batch.massA[i] * push;
    data.steps[c.b].push += batch.massB[i] * push;
}

void finish(WorldData& data, const RoundContact& c, double dt) {
    const RoundBatch& batch = data.batches.round[c.lane.batch];
    const std::uint32_t i = c.lane.lane;
    const double impulse = batch.normalImpulse[i];
    if (c.separation < -linearSlop) {
        const double way = wayOut(c.separation, batch.velocity[i], batch.normalMass[i], dt);
        pushApart(data, c, batch, way);
        noteWork(data, c.a, c.b, way * Vec2(batch.normalX[i], batch.normalY[i]), dt);
    }
    if (c.bounces && impulse > 0) {
        data.steps[c.a].bounced = data.steps[c.b].bounced = true;
    }
    Contact& kept = data.contacts[c.contact];
    kept.tangentImpulse = c.bounces ? 0 : batch.tangentImpulse[i]; // what stopped an impact is not carried on
    kept.points[0].normalImpulse = c.bounces ? 0 : impulse;
    data.table.marks[c.pair].now = impulse > 0 || c.separation <= 0;
}

void pushApart(WorldData& data, const Constraint& c, const ConstraintPoint& p, double push) {
    const BodyMotion& a = data.motions[c.a];
    const BodyMotion& b = data.motions[c.b];
    data.steps[c.a].push -= push * a.inverseMass * c.normal;
    data.steps[c.b].push += push * b.inverseMass * c.normal;
    data.steps[c.a].pushTurn -= push * a.inverseInertia * p.leverA;
    data.steps[c.b].pushTurn += push * b.inverseInertia * p.leverB;
}

void finish(WorldData& data, const Constraint& c, double dt) {
    const ConstraintBatch& batch = data.batches.general[c.lane.batch];
    const std::uint32_t lane = c.lane.lane;
    const std::array<double, 2> impulses{batch.impulse1[lane], batch.impulse2[lane]};
    const std::array<double, 2> velocities{batch.velocity1[lane], batch.velocity2[lane]};
    bool bounces = false;
    for (std::size_t i = 0; i < static_cast<std::size_t>(c.count); ++i) {
        const ConstraintPoint& p = c.points[i];
        if (p.separation < -linearSlop) {
            const double way = wayOut(p.separation, velocities[i], p.normalMass, dt);
            pushApart(data, c, p, way);
            noteWork(data, c.a, c.b, way * c.normal, dt);
        }
        if (p.bounces && impulses[i] > 0) {
            data.steps[c.a].bounced = data.steps[c.b].bounced = true;
        }
        ContactPoint& kept = data.contacts[p.contact].points[p.index];
        bounces |= p.bounces;
        kept.normalImpulse = p.bounces ? 0 : impulses[i];
        data.table.marks[p.pair].now |= impulses[i] > 0 || p.separation <= 0;
    }
    data.contacts[c.points[0].contact].tangentImpulse = bounces ? 0 : batch.tangentImpulse[lane];
}

/// What is held back has less energy; and what has less energy may have to be held back.
void settle(WorldData& data, double dt) {
    bool changed = true;
    for (int round = 0; changed && round < roundsOfSettling; ++round) {
        if (measureVelocities(data.batches)) {
            holdBack(data, dt);
        }
        changed = limitGain(data);
    }
    if (changed) {
        measureVelocities(data.batches);
    }
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
    packGeneral(data, 1 / step.dt);
    warmStart(data.batches);
    for (int pass = 0; pass < step.passes; ++pass) {
        solvePass(data.batches);
    }
    settle(data, step.dt);
    const std::vector<RoundContact>& round = data.roundContacts;
    for (std::size_t i = 0; i < round.size(); ++i) {
        if (i + contactsAhead < round.size()) {
            __builtin_prefetch(&data.contacts[round[i + contactsAhead].contact], 1);
        }
        finish(data, round[i], step.dt);
    }
    for (const Constraint& c : data.constraints) {
        finish(data, c, step.dt);
    }
    limitPushes(data);
    takePaces(data, step.dt);
}

} // namespace spacetow
