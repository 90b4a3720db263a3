#pragma once
// The flights that are stored beside a level, and what becomes of each in the level as it is now. Beside cave.json they
// are cave.replay.json and cave.NAME.replay.json.

#include "core/game/replay.h"

#include <filesystem>
#include <stop_token>
#include <string>
#include <vector>

namespace spacetow {

struct StoredFlight {
    std::filesystem::path path;
    std::shared_ptr<const Replay> replay; // null where the file cannot be read

    bool operator==(const StoredFlight&) const = default;
};

/// Sorted by their names. Reads the files.
std::vector<StoredFlight> flightsBeside(const std::filesystem::path& level);

enum class FlightEnd : std::uint8_t {
    Won,
    Lost,    // and not won in a later attempt
    Astray,  // still under way when the recording ends
    Unread,  // the file cannot be read
    Stopped, // by the stop token
};

struct FlightResult {
    FlightEnd end = FlightEnd::Unread;
    double time = 0; // s, of the last attempt
    double fuel = 0; // s of thrust
    /// Where the ship was when it won, was lost first, or the recording ended, and in which update.
    Vec2 place{0, 0};
    std::int64_t update = 0;

    bool operator==(const FlightResult&) const = default;
};

/// Flies the whole recording, as `replayed` does.
FlightResult flightResult(const Level& level, const Replay& replay, const std::stop_token& stop = {});

} // namespace spacetow
