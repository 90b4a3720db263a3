#include "core/physics/hold_back.h"

#include "core/physics/contact_rules.h"

#include <algorithm>

namespace spacetow {

namespace {

// So many bodies in a row hold each other back.
constexpr int roundsOfHolding = 8;

/// Two bodies at a point of contact.
struct Closing {
    Slot a, b;
    double speedA, speedB; // m/s along the normal
    double separation;
};

/// Where the solver has not converged, bodies in contact would still go into each other: they go as far as the slop.
/// What is held back holds back what follows it.
bool limitClosing(WorldData& data, const Closing& c, double dt) {
    // What nothing holds back takes along what it holds back: both have the same part of their way to each other left.
    const bool yieldsA = data.motions[c.a].yields();
    const bool yieldsB = data.motions[c.b].yields();
    const double fractionA = data.steps[yieldsA ? c.a : c.b].fraction;
    const double fractionB = data.steps[yieldsB ? c.b : c.a].fraction;
    if (yieldsA && yieldsB && data.islands.driven[data.islands.roots[c.a]] != 0) {
        return false;
    }
    const double room = roomToClose(c.separation);
    if (dt * (fractionA * c.speedA - fractionB * c.speedB) <= room) {
        return false;
    }
    const double both = std::min(fractionA, fractionB);
    const double closing = dt * (c.speedA - c.speedB);
    const double fraction = closing * both > room ? room / closing : both;
    bool changed = false;
    for (const Slot slot : {c.a, c.b}) {
        if (data.motions[slot].yields() && fraction < data.steps[slot].fraction) {
            data.steps[slot].fraction = fraction;
            data.islands.held[slot] = 1;
            changed = true;
        }
    }
    return changed;
}

double speedAlong(const Pace& pace, double normalX, double normalY, double lever) {
    return pace.x * normalX + pace.y * normalY + pace.turn * lever;
}

bool holdBackAt(WorldData& data, const RoundBatch& batch, std::uint32_t i, double dt) {
    const Slot a = batch.a[i];
    const Slot b = batch.b[i];
    const double x = batch.normalX[i];
    const double y = batch.normalY[i];
    const std::vector<Pace>& paces = data.batches.paces;
    return limitClosing(
        data, {a, b, speedAlong(paces[a], x, y, 0), speedAlong(paces[b], x, y, 0), batch.separation[i]}, dt);
}

bool holdBackAt(WorldData& data, const ConstraintBatch& batch, std::uint32_t i, double dt) {
    const Slot a = batch.a[i];
    const Slot b = batch.b[i];
    const double x = batch.normalX[i];
    const double y = batch.normalY[i];
    const std::vector<Pace>& paces = data.batches.paces;
    const auto limitPoint = [&](double leverA, double leverB, double separation) {
        return limitClosing(
            data, {a, b, speedAlong(paces[a], x, y, leverA), speedAlong(paces[b], x, y, leverB), separation}, dt);
    };
    const bool changed = limitPoint(batch.leverA1[i], batch.leverB1[i], batch.separation1[i]);
    return limitPoint(batch.leverA2[i], batch.leverB2[i], batch.separation2[i]) || changed;
}

/// Visits what closes too fast at first, then only what touches bodies that are held back: no other can have changed.
template <class Batch>
bool holdBackOnce(WorldData& data, const Batches<Batch>& batches, double dt, bool first) {
    const std::vector<std::uint8_t>& held = data.islands.held;
    bool changed = false;
    for (std::uint32_t k = 0; k < batches.size(); ++k) {
        const Batch& batch = batches[k];
        const unsigned closes = first ? batches.notes(k).closes : 0;
        for (std::uint32_t i = 0; i < 4; ++i) {
            if (((closes >> i & 1) | held[batch.a[i]] | held[batch.b[i]]) != 0) {
                changed |= holdBackAt(data, batch, i, dt);
            }
        }
    }
    return changed;
}

/// What is held back has been accelerated for as long as it moved.
void takeBackAcceleration(WorldData& data) {
    for (const Slot slot : data.moving) {
        BodyStep& s = data.steps[slot];
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

} // namespace

void holdBack(WorldData& data, double dt) {
    data.islands.driven.assign(data.motions.size(), 0);
    for (const Islands::Driver& driver : data.islands.drivers) {
        const BodyMotion& m = data.motions[driver.slot];
        data.islands.driven[driver.pushed] |= m.angularVelocity != 0 || m.velocity != Vec2(0, 0) ? 1 : 0;
    }
    data.islands.held.assign(data.motions.size() + 1, 0);
    for (const Slot slot : data.moving) {
        data.islands.held[slot] = data.steps[slot].fraction < 1 ? 1 : 0;
    }
    bool changed = true;
    for (int round = 0; round < roundsOfHolding && changed; ++round) {
        changed = holdBackOnce(data, data.batches.round, dt, round == 0);
        changed |= holdBackOnce(data, data.batches.general, dt, round == 0);
    }
    takeBackAcceleration(data);
}

} // namespace spacetow
