#pragma once
// How long each stage of an update takes. The engine has no clock: whoever wants to know brings one, and what it says
// goes into these figures and nowhere else.

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>

namespace spacetow {

/// In the order of an update; all but the first and the last once an iteration.
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
    std::function<std::int64_t()> clock;              // ns since whenever
    std::array<std::int64_t, stepStageCount> spent{}; // ns, by stage; grows from update to update
    std::int64_t since = 0;                           // what is being measured began

    void begin() { since = clock(); }
    /// What has passed since belongs to the stage.
    void end(StepStage stage) {
        const std::int64_t now = clock();
        spent[static_cast<std::size_t>(stage)] += now - since;
        since = now;
    }
};

} // namespace spacetow
