#pragma once
// The flights that are stored beside a level, and what becomes of each in the level as it is now. Beside cave.json they
// are cave.replay.json and cave.NAME.replay.json, unless these are beside a level cave.NAME.json.

#include "core/game/replay.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace spacetow {

struct StoredFlight {
    std::filesystem::path path;
    std::shared_ptr<const Replay> replay; // null where the file cannot be read,
    Error unread;                         // and why

    bool operator==(const StoredFlight&) const = default;
};

/// Sorted by their names. Reads the files.
std::vector<StoredFlight> flightsBeside(const std::filesystem::path& level);

/// Flies the whole recording, as `replayed` does.
FlightResult flightResult(const Level& level, const Replay& replay, const std::stop_token& stop = {});

enum class FlightNews : std::uint8_t {
    New,       // nobody knows how it ended before
    Same,      // as before, in the same update and place
    Elsewhere, // in the same way, but not there or not then
    Better,    // it is won now
    Worse,     // it was won before
    Other,     // neither, but in another way
};

/// Between flights that have been flown to an end.
FlightNews newsOf(const std::optional<FlightResult>& before, const FlightResult& now);

} // namespace spacetow
