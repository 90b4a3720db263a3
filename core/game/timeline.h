#pragma once
// The last minute of a run, kept so that any moment of it can be looked at again: saved sessions at intervals, and what
// came from outside in each update between them. A timeline is a value; copies share what is saved. What `at` answers
// is, by its hash, what a fresh run of the same inputs would be.
//
// Saved sessions are so far apart that all of them together stay within `Limits::bytes`: a small level is saved every
// few updates, 2,000 balls three times a second. How long a session takes to copy and to simulate grows with its bytes,
// too, so that looking at any moment takes about the same time everywhere.

#include "core/game/input_runs.h"
#include "core/game/mark_list.h"
#include "core/game/session.h"
#include "core/game/tracks.h"

#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <vector>

namespace spacetow {

class Timeline {
  public:
    struct Limits {
        double seconds = 60;                        // that can be gone back
        std::size_t bytes = std::size_t{420} << 20; // for saved sessions
        std::int64_t leastInterval = 5;             // updates
    };

    explicit Timeline(const Session& start) : Timeline(start, Limits()) {}
    Timeline(const Session& start, const Limits& limits);

    /// The updates between which every moment can be looked at; 0 is the start of the run.
    std::int64_t first() const { return m_saved.front().update; }
    std::int64_t last() const { return m_last; }

    /// The run has gone on by one update, from `last`.
    void add(const StepInput& input, const Session& after);
    /// The session after so many updates, within `first` … `last`. Simulates from the nearest session that is saved,
    /// and keeps some on the way, so that going on backwards from there is quick.
    std::shared_ptr<const Session> at(std::int64_t update);
    /// So many updates would be simulated for it.
    std::int64_t updatesTo(std::int64_t update) const { return update - nearest(update).update; }
    /// Simulates, so many updates at a time, what will be needed for going back from there beyond the nearest saved
    /// session. True when nothing is left to be done.
    bool prepareBackFrom(std::int64_t update, int updates);

    /// What came from outside in the update after this one; `first` ≤ update < `last`.
    const StepInput& input(std::int64_t update) const;
    /// Of all later updates.
    InputRuns inputsFrom(std::int64_t update) const;

    /// Another future begins after this session, which is one of the timeline. What was to come stays as a ghost, if
    /// so.
    void goOnFrom(const Session& session, bool withGhost = true);
    /// How far back one can go from now on.
    void setSeconds(double seconds) { m_limits.seconds = seconds; }

    /// The object that somebody looks at, 0 for none: its touches are marked from the next update on, those of another
    /// one are no longer, and its way is shown before others.
    void setFocus(Key object);

    const MarkList& marks() const { return m_marks; }
    /// Of futures that were given up, the newest last.
    const std::vector<std::shared_ptr<const Ghost>>& ghosts() const { return m_ghosts; }
    /// Where ship and payload, or the bodies of a sandbox, have been from this update on; thinned.
    std::vector<TracedPath> pathsFrom(std::int64_t update) const { return m_tracks.pathsFrom(update); }

    /// Memory of what is saved, about.
    std::size_t bytes() const;
    std::size_t savedSessions() const { return m_saved.size(); }

  private:
    struct Saved {
        std::int64_t update;
        std::size_t bytes;
        std::shared_ptr<const Session> session;
    };
    struct Run {
        std::int64_t from; // updates before it
        StepInput input;
    };
    static constexpr std::size_t mostNear = 16; // sessions

    static Saved saved(const Session& session);
    std::int64_t interval() const;
    std::int64_t stride() const;
    std::size_t runAt(std::int64_t update) const;
    const Saved& nearest(std::int64_t update) const;
    /// Goes on to the moment, and keeps what is passed.
    void simulate(Session& session, std::int64_t until);
    void keepNear(const Session& session);
    void save(const Session& session);
    void forgetOld();
    void mark(const StepInput& input, const Session& after);
    std::optional<MarkKind> focusMark(const Session& after) const;

    Limits m_limits;
    std::deque<Saved> m_saved;
    std::vector<Saved> m_near; // in order; those around the moment that was looked at last
    std::deque<Run> m_inputs;
    std::int64_t m_last = 0;
    std::int64_t m_looked = 0;        // the moment that was looked at last
    std::int64_t m_lastTouch = -1000; // update of the last mark of one
    std::int64_t m_lastFocus = -1000; // likewise, of what is looked at
    Key m_focus = 0;
    double m_updateSeconds = 0.02;
    Phase m_phase = Phase::Sandbox; // at the end
    MarkList m_marks;
    std::vector<std::shared_ptr<const Ghost>> m_ghosts;
    Tracks m_tracks;
};

/// A future that is simulated a little at a time, and put on a timeline.
class Future {
  public:
    /// `from` is the end of the timeline.
    Future(const Session& from, InputRuns inputs)
        : m_session(from), m_inputs(std::move(inputs)), m_goal(from.updates() + m_inputs.updates()) {}

    bool isDone() const { return m_inputs.isAtEnd(); }
    /// The last update, when it is done.
    std::int64_t goal() const { return m_goal; }
    const Session& session() const { return m_session; }
    /// So many updates, or those that are left.
    void advance(Timeline& timeline, int updates);

  private:
    Session m_session;
    InputReader m_inputs;
    std::int64_t m_goal;
};

} // namespace spacetow
