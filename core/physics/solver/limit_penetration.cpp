#include "core/physics/solver/limit_penetration.h"

#include "core/physics/contacts/contact_rules.h"
#include "core/physics/solver/contact_graph.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace spacetow {

namespace {

// So many bodies in a row hold each other back.
constexpr int roundsOfLimiting = 8;

/// Two bodies at a point of contact.
struct Closing {
    Slot a, b;
    bool yieldsA, yieldsB;
    double speedA, speedB; // m/s along the normal
    double separation;
};

/// What is known of the bodies while penetration is limited, by slot.
struct PenetrationLimits {
    std::vector<double>& fractions;
    std::vector<std::uint8_t>& changed; // the round after that in which the fraction has changed; 1 at first if below 1
    const std::vector<std::uint8_t>& pushedByKinematic;
    double dt;
    int round;
};

/// The body makes no more than this fraction of its motion.
bool hold(const PenetrationLimits& h, Slot slot, double fraction) {
    if (fraction >= h.fractions[slot]) {
        return false;
    }
    h.fractions[slot] = fraction;
    h.changed[slot] = static_cast<std::uint8_t>(h.round + 1);
    return true;
}

/// Where the solver has not converged, bodies in contact would still go into each other: they go as far as the slop.
/// What is held back holds back what follows it, but only from where it is met: the rest of a heap falls on meanwhile.
bool limitClosing(const PenetrationLimits& h, const Closing& c) {
    // What nothing holds back takes along what it holds back: both have the same part of their way to each other left.
    const double fractionA = h.fractions[c.yieldsA ? c.a : c.b];
    const double fractionB = h.fractions[c.yieldsB ? c.b : c.a];
    const double allowance = formulas::penetrationAllowance(c.separation);
    if (h.dt * (fractionA * c.speedA - fractionB * c.speedB) <= allowance) {
        return false;
    }
    if (c.yieldsA && c.yieldsB && c.speedA > 0 && c.speedB > 0) {
        return hold(h, c.a, (allowance / h.dt + fractionB * c.speedB) / c.speedA);
    }
    if (c.yieldsA && c.yieldsB && c.speedA < 0 && c.speedB < 0) {
        return hold(h, c.b, (allowance / h.dt - fractionA * c.speedA) / -c.speedB);
    }
    const double both = std::min(fractionA, fractionB);
    const double closing = h.dt * (c.speedA - c.speedB);
    const double fraction = closing * both > allowance ? allowance / closing : both;
    const bool heldA = c.yieldsA && hold(h, c.a, fraction);
    const bool heldB = c.yieldsB && hold(h, c.b, fraction);
    return heldA || heldB;
}

double speedAlong(const BodyVelocity& velocity, double normalX, double normalY, double lever) {
    return velocity.x * normalX + velocity.y * normalY + velocity.angular * lever;
}

template <class Batch>
Closing closingAt(const std::vector<BodyVelocity>& velocities, const Batch& batch, std::uint32_t i) {
    return {.a = batch.a[i],
            .b = batch.b[i],
            .yieldsA = batch.massA[i] > 0 || batch.inertiaA[i] > 0,
            .yieldsB = batch.massB[i] > 0 || batch.inertiaB[i] > 0,
            .speedA = speedAlong(velocities[batch.a[i]], batch.normalX[i], batch.normalY[i], 0),
            .speedB = speedAlong(velocities[batch.b[i]], batch.normalX[i], batch.normalY[i], 0)};
}

bool limitContactAt(const std::vector<BodyVelocity>& velocities, const PenetrationLimits& h, const CircleBatch& batch,
                    std::uint32_t i) {
    Closing closing = closingAt(velocities, batch, i);
    closing.separation = batch.separation[i];
    return limitClosing(h, closing);
}

bool limitContactAt(const std::vector<BodyVelocity>& velocities, const PenetrationLimits& h,
                    const ConstraintBatch& batch, std::uint32_t i) {
    const Closing center = closingAt(velocities, batch, i);
    const double turnA = velocities[center.a].angular;
    const double turnB = velocities[center.b].angular;
    const auto limitAt = [&](double leverA, double leverB, double separation) {
        Closing closing = center;
        closing.speedA += turnA * leverA;
        closing.speedB += turnB * leverB;
        closing.separation = separation;
        return limitClosing(h, closing);
    };
    const bool changed = limitAt(batch.leverA1[i], batch.leverB1[i], batch.separation1[i]);
    return limitAt(batch.leverA2[i], batch.leverB2[i], batch.separation2[i]) || changed;
}

/// Whether no contact closes too fast, but in components that a kinematic body may push.
template <class Batch>
bool noneCloses(const std::vector<std::uint8_t>& pushedByKinematic, const Batches<Batch>& batches) {
    bool none = true;
    forLanes(batches, &BatchFlags::closes, [&](Lane at) {
        none &=
            (pushedByKinematic[batches[at.batch].a[at.lane]] & pushedByKinematic[batches[at.batch].b[at.lane]]) != 0;
    });
    return none;
}

/// Visits what closes too fast at first, then what touches bodies that have been held back since: no other can have
/// changed.
template <class Batch>
bool limitOnce(const std::vector<BodyVelocity>& velocities, const PenetrationLimits& h, const Batches<Batch>& batches) {
    const int since = std::max(h.round, 1);
    bool changed = false;
    for (std::uint32_t k = 0; k < batches.size(); ++k) {
        const Batch& batch = batches[k];
        const unsigned closes = h.round == 0 ? batches.flags(k).closes : 0;
        for (std::uint32_t i = 0; i < 4; ++i) {
            const Slot a = batch.a[i];
            const Slot b = batch.b[i];
            const bool isNew = (closes >> i & 1) != 0 || h.changed[a] >= since || h.changed[b] >= since;
            if (isNew && (h.pushedByKinematic[a] & h.pushedByKinematic[b]) == 0) {
                changed |= limitContactAt(velocities, h, batch, i);
            }
        }
    }
    return changed;
}

/// What is held back has been accelerated for as long as it moved.
void reduceAcceleration(Bodies& bodies, SolverScratch& solver) {
    for (const Slot slot : bodies.moving) {
        BodyStep& s = bodies.steps[slot];
        s.fraction = solver.fractions[slot];
        if (s.fraction < s.acceleratedFraction) {
            const double lost = 1 - s.fraction / s.acceleratedFraction;
            const BodyVelocity& start = solver.startVelocities[slot];
            BodyVelocity& planned = solver.plannedVelocities[slot];
            const BodyVelocity change{lost * (planned.x - start.x), lost * (planned.y - start.y),
                                      lost * (planned.angular - start.angular), 0};
            for (BodyVelocity* velocity : {&planned, &solver.velocities[slot]}) {
                velocity->x -= change.x;
                velocity->y -= change.y;
                velocity->angular -= change.angular;
            }
            s.acceleratedFraction = s.fraction;
        }
    }
}

/// Whether nothing has been held back so far, and nothing is to be.
bool noneLimited(const Bodies& bodies, const Constraints& constraints, const SolverScratch& solver) {
    const auto isLimited = [&](Slot slot) { return bodies.steps[slot].fraction < 1; };
    return std::none_of(bodies.moving.begin(), bodies.moving.end(), isLimited) &&
           noneCloses(solver.pushedByKinematic, constraints.batches.circles) &&
           noneCloses(solver.pushedByKinematic, constraints.batches.general);
}

/// What is held back so far holds back what follows it.
void propagateLimits(const Bodies& bodies, const Constraints& constraints, SolverScratch& solver, double dt) {
    SolverScratch& scratch = solver;
    beginBySlot(scratch.fractions, bodies.motions.size() + 1, 1.0);
    beginBySlot(scratch.limited, bodies.motions.size() + 1, std::uint8_t{0});
    for (const Slot slot : bodies.moving) {
        scratch.fractions[slot] = bodies.steps[slot].fraction;
        scratch.limited[slot] = bodies.steps[slot].fraction < 1 ? 1 : 0;
    }
    bool changed = true;
    for (int round = 0; round < roundsOfLimiting && changed; ++round) {
        const PenetrationLimits holding{scratch.fractions, scratch.limited, scratch.pushedByKinematic, dt, round};
        changed = limitOnce(scratch.velocities, holding, constraints.batches.circles);
        changed |= limitOnce(scratch.velocities, holding, constraints.batches.general);
    }
}

} // namespace

void limitPenetration(Bodies& bodies, const Constraints& constraints, SolverScratch& solver, double dt) {
    if (!noneLimited(bodies, constraints, solver)) {
        propagateLimits(bodies, constraints, solver, dt);
        reduceAcceleration(bodies, solver);
    }
}

void limitPenetrationOfFollowers(Bodies& bodies, const Constraints& constraints, SolverScratch& solver, double dt) {
    const auto isStopped = [&](Slot slot) {
        return bodies.steps[slot].fraction < bodies.steps[slot].acceleratedFraction;
    };
    if (std::none_of(bodies.moving.begin(), bodies.moving.end(), isStopped)) {
        return;
    }
    propagateLimits(bodies, constraints, solver, dt);
    for (const Slot slot : bodies.moving) {
        bodies.steps[slot].fraction = solver.fractions[slot];
    }
}

} // namespace spacetow
