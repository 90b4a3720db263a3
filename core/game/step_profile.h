#pragma once
// How long the stages of the last updates took. Seconds of the clock, which decide nothing in the game.

#include "core/physics/def/stage_times.h"

#include <array>
#include <cstddef>
#include <vector>

namespace spacetow {

class StepProfile {
  public:
    static constexpr std::size_t kept = 250;          // updates: five seconds of a game
    using Stages = std::array<float, stepStageCount>; // s, by stage

    /// Of one more update, by the stages.
    void note(const Stages& stages);
    /// Oldest first; at most `kept`.
    std::vector<Stages> history() const;
    std::size_t size() const { return m_updates.size(); }

    struct Figures {
        double now = 0, average = 0, maximum = 0; // s, of what is kept
    };
    Figures of(StepStage stage) const;
    /// Of whole updates.
    Figures together() const;

  private:
    template <class Sum>
    Figures figures(const Sum& sum) const;

    std::vector<Stages> m_updates; // a ring
    std::size_t m_next = 0;        // where the next one goes
};

/// Asks a clock during updates, and notes each in a profile.
class StepWatch {
  public:
    explicit StepWatch(std::function<std::int64_t()> nanoseconds) { m_times.clock = std::move(nanoseconds); }

    StageTimes& times() { return m_times; }
    /// After an update.
    void note();
    const StepProfile& profile() const { return m_profile; }

  private:
    StageTimes m_times;
    StepProfile m_profile;
};

} // namespace spacetow
