#include "core/physics/solver/hold_back.h"

#include "core/physics/contacts/contact_rules.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace spacetow {

namespace {

// So many bodies in a row hold each other back.
constexpr int roundsOfHolding = 8;

/// Two bodies at a point of contact.
struct Closing {
    Slot a, b;
    bool yieldsA, yieldsB;
    double speedA, speedB; // m/s along the normal
    double separation;
};

/// What is known of the bodies while they are held back, by slot.
struct Holding {
    std::vector<double>& fractions;
    std::vector<std::uint8_t>& changed; // the round after that in which the fraction has changed; 1 at first if below 1
    const std::vector<std::uint8_t>& driven;
    double dt;
    int round;
};

/// The body goes no further than this part of its way.
bool hold(const Holding& h, Slot slot, double fraction) {
    if (fraction >= h.fractions[slot]) {
        return false;
    }
    h.fractions[slot] = fraction;
    h.changed[slot] = static_cast<std::uint8_t>(h.round + 1);
    return true;
}

/// Where the solver has not converged, bodies in contact would still go into each other: they go as far as the slop.
/// What is held back holds back what follows it, but only from where it is met: the rest of a heap falls on meanwhile.
bool limitClosing(const Holding& h, const Closing& c) {
    // What nothing holds back takes along what it holds back: both have the same part of their way to each other left.
    const double fractionA = h.fractions[c.yieldsA ? c.a : c.b];
    const double fractionB = h.fractions[c.yieldsB ? c.b : c.a];
    const double room = roomToClose(c.separation);
    if (h.dt * (fractionA * c.speedA - fractionB * c.speedB) <= room) {
        return false;
    }
    if (c.yieldsA && c.yieldsB && c.speedA > 0 && c.speedB > 0) {
        return hold(h, c.a, (room / h.dt + fractionB * c.speedB) / c.speedA);
    }
    if (c.yieldsA && c.yieldsB && c.speedA < 0 && c.speedB < 0) {
        return hold(h, c.b, (room / h.dt - fractionA * c.speedA) / -c.speedB);
    }
    const double both = std::min(fractionA, fractionB);
    const double closing = h.dt * (c.speedA - c.speedB);
    const double fraction = closing * both > room ? room / closing : both;
    const bool heldA = c.yieldsA && hold(h, c.a, fraction);
    const bool heldB = c.yieldsB && hold(h, c.b, fraction);
    return heldA || heldB;
}

double speedAlong(const Pace& pace, double normalX, double normalY, double lever) {
    return pace.x * normalX + pace.y * normalY + pace.turn * lever;
}

template <class Batch>
Closing closingAt(const std::vector<Pace>& paces, const Batch& batch, std::uint32_t i) {
    return {.a = batch.a[i],
            .b = batch.b[i],
            .yieldsA = batch.massA[i] > 0 || batch.inertiaA[i] > 0,
            .yieldsB = batch.massB[i] > 0 || batch.inertiaB[i] > 0,
            .speedA = speedAlong(paces[batch.a[i]], batch.normalX[i], batch.normalY[i], 0),
            .speedB = speedAlong(paces[batch.b[i]], batch.normalX[i], batch.normalY[i], 0)};
}

bool holdBackAt(const std::vector<Pace>& paces, const Holding& h, const RoundBatch& batch, std::uint32_t i) {
    Closing closing = closingAt(paces, batch, i);
    closing.separation = batch.separation[i];
    return limitClosing(h, closing);
}

bool holdBackAt(const std::vector<Pace>& paces, const Holding& h, const ConstraintBatch& batch, std::uint32_t i) {
    const Closing center = closingAt(paces, batch, i);
    const double turnA = paces[center.a].turn;
    const double turnB = paces[center.b].turn;
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

/// Whether no contact closes too fast, but in islands that something drives.
template <class Batch>
bool noneCloses(const std::vector<std::uint8_t>& driven, const Batches<Batch>& batches) {
    bool none = true;
    forLanes(batches, &BatchNotes::closes, [&](Lane at) {
        none &= (driven[batches[at.batch].a[at.lane]] & driven[batches[at.batch].b[at.lane]]) != 0;
    });
    return none;
}

/// Visits what closes too fast at first, then what touches bodies that have been held back since: no other can have
/// changed.
template <class Batch>
bool holdBackOnce(const std::vector<Pace>& paces, const Holding& h, const Batches<Batch>& batches) {
    const int since = std::max(h.round, 1);
    bool changed = false;
    for (std::uint32_t k = 0; k < batches.size(); ++k) {
        const Batch& batch = batches[k];
        const unsigned closes = h.round == 0 ? batches.notes(k).closes : 0;
        for (std::uint32_t i = 0; i < 4; ++i) {
            const Slot a = batch.a[i];
            const Slot b = batch.b[i];
            const bool isNew = (closes >> i & 1) != 0 || h.changed[a] >= since || h.changed[b] >= since;
            if (isNew && (h.driven[a] & h.driven[b]) == 0) {
                changed |= holdBackAt(paces, h, batch, i);
            }
        }
    }
    return changed;
}

/// What is held back has been accelerated for as long as it moved.
void takeBackAcceleration(WorldData& data) {
    for (const Slot slot : data.moving) {
        BodyStep& s = data.steps[slot];
        s.fraction = data.islands.fractions[slot];
        if (s.fraction < s.accounted) {
            const double lost = 1 - s.fraction / s.accounted;
            const Pace& start = data.batches.starts[slot];
            Pace& planned = data.batches.planned[slot];
            const Pace change{lost * (planned.x - start.x), lost * (planned.y - start.y),
                              lost * (planned.turn - start.turn), 0};
            for (Pace* pace : {&planned, &data.batches.paces[slot]}) {
                pace->x -= change.x;
                pace->y -= change.y;
                pace->turn -= change.turn;
            }
            s.accounted = s.fraction;
        }
    }
}

/// Whether nothing has been held back so far, and nothing is to be.
bool allGoFreely(const WorldData& data) {
    const auto isHeld = [&](Slot slot) { return data.steps[slot].fraction < 1; };
    return std::none_of(data.moving.begin(), data.moving.end(), isHeld) &&
           noneCloses(data.islands.driven, data.batches.round) && noneCloses(data.islands.driven, data.batches.general);
}

/// What is held back so far holds back what follows it.
void passOn(WorldData& data, double dt) {
    Islands& islands = data.islands;
    islands.fractions.assign(data.motions.size() + 1, 1);
    islands.held.assign(data.motions.size() + 1, 0);
    for (const Slot slot : data.moving) {
        islands.fractions[slot] = data.steps[slot].fraction;
        islands.held[slot] = data.steps[slot].fraction < 1 ? 1 : 0;
    }
    bool changed = true;
    for (int round = 0; round < roundsOfHolding && changed; ++round) {
        const Holding holding{islands.fractions, islands.held, islands.driven, dt, round};
        changed = holdBackOnce(data.batches.paces, holding, data.batches.round);
        changed |= holdBackOnce(data.batches.paces, holding, data.batches.general);
    }
}

} // namespace

void holdBack(WorldData& data, double dt) {
    if (!allGoFreely(data)) {
        passOn(data, dt);
        takeBackAcceleration(data);
    }
}

void holdBackFollowers(WorldData& data, double dt) {
    const auto isStopped = [&](Slot slot) { return data.steps[slot].fraction < data.steps[slot].accounted; };
    if (std::none_of(data.moving.begin(), data.moving.end(), isStopped)) {
        return;
    }
    passOn(data, dt);
    for (const Slot slot : data.moving) {
        data.steps[slot].fraction = data.islands.fractions[slot];
    }
}

} // namespace spacetow
