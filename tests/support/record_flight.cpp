#include "tests/support/record_flight.h"

#include <array>

namespace spacetow::test {
namespace {

constexpr int longest = 10'000; // updates
constexpr int aftermath = 50;   // updates recorded after the win

FlightPlan slowed(FlightPlan plan, double factor) {
    for (std::vector<Waypoint>* route : {&plan.toPayload, &plan.toFinish}) {
        for (Waypoint& point : *route) {
            point.speed *= factor;
        }
    }
    return plan;
}

std::optional<Replay> flown(const Level& level, const FlightPlan& plan) {
    Replay replay;
    Session session(level, replay.seed);
    Autopilot pilot(plan);
    int after = 0;
    while (session.updates() < longest && after < aftermath) {
        const Controls controls = pilot.next(session);
        session.step(controls);
        replay.append(controls);
        if (session.phase() == Phase::Crashed || session.phase() == Phase::GameOver) {
            return std::nullopt;
        }
        after += session.phase() == Phase::Won ? 1 : 0;
    }
    return session.phase() == Phase::Won ? std::optional(replay) : std::nullopt;
}

FlightPlan firstHaul() {
    return {{{Vec2(3.2, 7.6), 0.8},
             {Vec2(5.2, 7.3), 0.8},
             {Vec2(5.35, 4.6), 0.8},
             {Vec2(4.6, 3.3), 0.8},
             {Vec2(3.1, 2.95), 0.55}},
            {{Vec2(3.6, 3.3), 0.4},
             {Vec2(5.2, 3.2), 0.7},
             {Vec2(8.6, 3.0), 0.7},
             {Vec2(10.6, 3.3), 0.6},
             {Vec2(11.0, 4.5), 0.6},
             {Vec2(11.0, 8.9), 0.7}}};
}

FlightPlan airlock() {
    return {{{Vec2(4.2, 4.2), 0.7},
             {Vec2(6.2, 1.9), 0.7},
             {Vec2(8.0, 1.8), 0.9},
             {Vec2(11.0, 2.4), 0.7},
             {Vec2(13.2, 2.95), 0.5}},
            {{Vec2(12.8, 3.6), 0.5},
             {Vec2(11.5, 6.5), 0.7},
             {Vec2(10.4, 8.3), 0.6},
             {Vec2(8.0, 8.5), 0.7},
             {Vec2(6.0, 8.5), 0.6},
             {Vec2(2.4, 8.5), 0.5}}};
}

FlightPlan revolvingDoor() {
    return {{{Vec2(5.6, 12.3), 0.6},
             {Vec2(6.5, 10.9), 0.7},
             {Vec2(6.9, 9.8), 0.6},
             {Vec2(8.6, 8.4), 0.8},
             {Vec2(8.9, 7.0), 0.8},
             {Vec2(8.4, 5.4), 0.8},
             {Vec2(6.9, 4.4), 0.8},
             {Vec2(6.4, 2.35), 0.5}},
            {{Vec2(6.4, 3.2), 0.5},
             {Vec2(6.9, 4.6), 0.6},
             {Vec2(8.7, 5.9), 0.7},
             {Vec2(8.9, 7.0), 0.7},
             {Vec2(8.8, 8.3), 0.7},
             {Vec2(7.9, 9.6), 0.7},
             {Vec2(6.5, 10.9), 0.6},
             {Vec2(7.0, 12.6), 0.6},
             {Vec2(10.0, 12.9), 0.6}}};
}

FlightPlan upsideDown() {
    return {{{Vec2(2.6, 4.0), 0.8},
             {Vec2(3.6, 7.0), 0.8},
             {Vec2(6.6, 8.0), 0.8},
             {Vec2(9.5, 7.4), 0.7},
             {Vec2(11.2, 6.75), 0.5}},
            {{Vec2(10.4, 6.2), 0.4},
             {Vec2(9.2, 5.6), 0.5},
             {Vec2(8.9, 4.2), 0.6},
             {Vec2(9.4, 2.2), 0.5},
             {Vec2(10.0, 1.0), 0.3}}};
}

} // namespace

std::optional<FlightPlan> flightPlan(const std::string& levelFile) {
    if (levelFile == "01_first_haul.json") {
        return firstHaul();
    }
    if (levelFile == "02_airlock.json") {
        return airlock();
    }
    if (levelFile == "03_revolving_door.json") {
        return revolvingDoor();
    }
    if (levelFile == "04_upside_down.json") {
        return upsideDown();
    }
    return std::nullopt;
}

std::optional<Replay> winningFlight(const Level& level, const FlightPlan& plan) {
    for (const double factor : std::array{1.0, 0.9, 0.8, 0.7, 0.6, 0.5}) {
        if (std::optional<Replay> replay = flown(level, slowed(plan, factor))) {
            return replay;
        }
    }
    return std::nullopt;
}

} // namespace spacetow::test
