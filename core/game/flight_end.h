#pragma once
// How a flight ends: what is compared of a stored one when it is flown again.

#include "core/math/vec.h"

#include <cstdint>
#include <optional>

namespace spacetow {

enum class FlightEnd : std::uint8_t {
    Won,
    Lost,     // and not won in a later attempt
    UnderWay, // neither, when the recording ends
    Unread,   // the file cannot be read
    Crowded,  // bodies crowd: see core/game/crowd.h
    Stopped,  // by the stop token
};

struct FlightResult {
    FlightEnd end = FlightEnd::Unread;
    double time = 0; // s, of the last attempt
    double fuel = 0; // s of thrust
    /// Where the ship was when it won, it or its payload was lost first, or the recording ended; none without a ship.
    std::optional<Vec2> place{};
    /// When that was, since the flight began.
    std::int64_t update = 0;
    double seconds = 0;

    bool operator==(const FlightResult&) const = default;
};

} // namespace spacetow
