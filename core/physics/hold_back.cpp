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

bool closesTooFast(const WorldData& data, const Constraint& c) {
    const ConstraintBatch& batch = data.batches.general[c.lane.batch];
    const std::uint32_t i = c.lane.lane;
    return batch.velocity1[i] < batch.closing1[i] || batch.velocity2[i] < batch.closing2[i];
}

/// Visits what closes too fast at first, then only what touches bodies that are held back: no other can have changed.
bool holdBackOnce(WorldData& data, double dt, bool first) {
    const std::vector<Pace>& paces = data.batches.paces;
    const std::vector<std::uint8_t>& held = data.islands.held;
    bool changed = false;
    for (const RoundContact& c : data.roundContacts) {
        const RoundBatch& batch = data.batches.round[c.lane.batch];
        const std::uint32_t i = c.lane.lane;
        if ((first && batch.velocity[i] < batch.closing[i]) || held[c.a] != 0 || held[c.b] != 0) {
            const double x = batch.normalX[i];
            const double y = batch.normalY[i];
            const Closing closing{c.a, c.b, speedAlong(paces[c.a], x, y, 0), speedAlong(paces[c.b], x, y, 0),
                                  c.separation};
            changed |= limitClosing(data, closing, dt);
        }
    }
    for (const Constraint& c : data.constraints) {
        if (held[c.a] == 0 && held[c.b] == 0 && !(first && closesTooFast(data, c))) {
            continue;
        }
        for (std::size_t k = 0; k < static_cast<std::size_t>(c.count); ++k) {
            const ConstraintPoint& p = c.points[k];
            const Closing closing{c.a, c.b, speedAlong(paces[c.a], c.normal.x(), c.normal.y(), p.leverA),
                                  speedAlong(paces[c.b], c.normal.x(), c.normal.y(), p.leverB), p.separation};
            changed |= limitClosing(data, closing, dt);
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
    data.islands.held.assign(data.motions.size(), 0);
    for (const Slot slot : data.moving) {
        data.islands.held[slot] = data.steps[slot].fraction < 1 ? 1 : 0;
    }
    for (int round = 0; round < roundsOfHolding && holdBackOnce(data, dt, round == 0); ++round) {
    }
    takeBackAcceleration(data);
}

} // namespace spacetow
