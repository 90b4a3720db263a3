#pragma once
// Whether what runs keeps up with the clock, judged by the updates that have been made, however long each of them
// takes. Times are seconds of any steady clock.

#include <cstdint>
#include <optional>

namespace spacetow {

class PaceWatch {
  public:
    struct Reading {
        double now = 0;
        std::int64_t update = 0; // the newest
        double period = 0.02;    // s of the clock that an update should take
        bool paused = false;
    };

    /// By how many seconds the run is behind, while it falls back further; 0 while it keeps up. Looks once a second.
    double behind(const Reading& reading);
    /// The run goes on from elsewhere, or at another speed: what was before says nothing.
    void lookAnew() { m_last.reset(); }

  private:
    std::optional<Reading> m_last;
    double m_lost = 0; // s, in all
    double m_behind = 0;
};

} // namespace spacetow
