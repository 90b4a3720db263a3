#pragma once
// What stands for what in files of recorded flights, for those who read and who write them.

#include "core/game/replay.h"

#include <array>
#include <string_view>
#include <utility>

namespace spacetow::replay_words {

inline constexpr std::array<std::pair<FlightEnd, std::string_view>, 3> outcomes{
    {{FlightEnd::Won, "won"}, {FlightEnd::Lost, "lost"}, {FlightEnd::UnderWay, "running"}}};
inline constexpr std::array<std::pair<RunKind, std::string_view>, 2> kinds{
    {{RunKind::Game, "game"}, {RunKind::Simulation, "simulation"}}};

} // namespace spacetow::replay_words
