#pragma once
// Winning flights of the shipped levels, flown by the autopilot. The recordings under tests/replays come from here.

#include "core/game/autopilot.h"
#include "core/game/replay.h"

#include <optional>
#include <string>

namespace spacetow::test {

/// The way through a shipped level, by the name of its file; none for levels that nobody has planned.
std::optional<FlightPlan> flightPlan(const std::string& levelFile);

/// Flies the plan at several speeds, the fastest first, until one wins; none when all fail.
std::optional<Replay> winningFlight(const Level& level, const FlightPlan& plan);

} // namespace spacetow::test
