#pragma once
// How long each stage of an update takes. The engine has no clock of its own: the caller supplies one. The times go
// into `spent`, and no computation reads them.

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>

namespace spacetow {

/// In the order in which they run. `Sleep` runs once an update. `Changes` runs once an update and after each iteration
/// with deferred changes. All others run once an iteration.
enum class StepStage : std::uint8_t {
    Changes,  // deferred removals and flags, lists of bodies, accelerations
    Motion,   // velocities, and the motion of each body by itself
    Pairs,    // the broad phase
    Contacts, // the narrow phase
    Solver,
    Impacts, // time of impact
    Crush,
    Advance,
    Touches, // sensors, events, tags
    Sleep,
};
constexpr std::size_t stepStageCount = 10;

struct StageTimes {
    std::function<std::int64_t()> clock;              // ns since any fixed moment
    std::array<std::int64_t, stepStageCount> spent{}; // ns, by stage; the sum over all updates so far
    std::int64_t since = 0;                           // ns: the reading of the clock when the current stage began

    void begin() { since = clock(); }
    /// Adds the time since `begin`, or since the last `end`, to the stage.
    void end(StepStage stage) {
        const std::int64_t now = clock();
        spent[static_cast<std::size_t>(stage)] += now - since;
        since = now;
    }
};

} // namespace spacetow
