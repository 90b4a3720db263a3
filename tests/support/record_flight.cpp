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

} // namespace

std::optional<FlightPlan> flightPlan(const std::string& levelFile) {
    if (levelFile == "01_first_haul.json") {
        return FlightPlan{{{Vec2(3.2, 7.6), 0.8},
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
