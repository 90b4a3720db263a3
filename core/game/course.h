#pragma once
// A run and its timeline, without clock and thread: at one moment of it somebody looks. At its end the run goes on with
// new inputs; where it goes on from an earlier moment, another future begins. A level that is edited while the moment
// is an earlier one has the future simulated again, a little at a time.

#include "core/game/replay.h"
#include "core/game/timeline.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace spacetow {

/// What is to be shown of a timeline; immutable.
struct TimelineSummary {
    std::int64_t first = 0, last = 0; // updates that can be looked at
    std::int64_t shown = 0;
    std::int64_t goal = 0; // `last`, as soon as the future has been simulated
    double updateSeconds = 0.02;
    int futures = 0;                     // that have begun, restarts included: what is known of the updates after
    std::int64_t begun = 0;              // this one, where the newest began, is out of date when there is another
    std::optional<std::uint64_t> opened; // hash at the end of the recording that was opened, once that is simulated
    int iteration = 0;                   // of the next update that is shown; 0: none, the moment itself
    int iterations = 1;                  // of the next update
    MarkList marks;
    std::vector<std::shared_ptr<const Ghost>> ghosts;     // futures that were given up, the newest last
    std::shared_ptr<const std::vector<TracedPath>> paths; // of all that can be looked at; null while it runs
};

/// What is recorded of a run.
struct Recording {
    Replay run;                         // what it is of, and the name of the level, is left to who writes it
    std::shared_ptr<const Level> start; // with which it begins; null where there is none
    std::int64_t updates = 0;           // of the run, which may be longer than a recording can be

    bool isWhole() const { return run.updates() == updates; }
};

class Course {
  public:
    explicit Course(std::shared_ptr<const Level> level, std::uint64_t seed);

    /// At the moment that is looked at.
    const Session& session() const { return m_session; }
    /// The same as it is to be shown: with an edit that the next update will take over, or in the middle of that
    /// update.
    Session shown() const;
    bool isShownAsIs() const { return !m_edited && m_iteration == 0; }
    /// Somebody looks at the end of the run, and all of it has been simulated.
    bool isAtEnd() const { return !m_future && m_session.updates() == m_timeline.last(); }

    /// The object that somebody looks at, see Timeline::setFocus; stays over restarts.
    void setFocus(Key object);

    /// How the run goes on: whether sessions explain themselves (Session::setExplains), and who is told the times of
    /// stages; null for nobody, else it must outlive the updates.
    void observe(bool explains, StageTimes* times) {
        m_explains = explains;
        m_times = times;
    }

    /// Begins anew, with the level as it is now.
    void restart();
    /// One update more. From a moment before the end another future begins.
    void goOn(const StepInput& input);
    /// To the next moment of the run as it was. False at the end.
    bool goAlong();
    /// The moment after so many updates, or the nearest that there is; later than has been simulated: as soon as it is.
    void seek(std::int64_t update);
    /// Into the next update, by one iteration more; after the last one it is made, with `input` at the end of the run.
    void stepIteration(const StepInput& input);
    /// As it has been edited. At the end of the run the next update takes it over.
    void setLevel(std::shared_ptr<const Level> level);
    /// A recorded run, from the beginning; it is to be simulated. `then` is how its level has been edited at its end:
    /// what goes on from there, or begins anew, has that; null: it was played, not edited.
    void open(const Replay& recorded, const std::shared_ptr<const Level>& then = nullptr);

    bool isSimulating() const { return m_future.has_value(); }
    /// So many updates of the future.
    void simulate(int updates);
    /// The future ends where it has come to.
    void stopSimulating();
    /// How many updates of it there are, and the world after them.
    std::int64_t simulated() const { return m_timeline.last(); }
    const World& newestWorld() const { return m_future ? m_future->session().world() : m_session.world(); }
    /// A part of what going back will need; true when nothing is left.
    bool prepareBack(int updates) { return m_timeline.prepareBackFrom(m_session.updates(), updates); }

    /// All of the run, its future included; with its end, where that has been simulated.
    Replay recording();
    std::shared_ptr<const Level> startLevel() const { return m_start.sharedLevel(); }
    /// Of all of the run, its future included.
    std::int64_t updates() const { return m_future ? m_future->goal() : m_timeline.last(); }
    const Timeline& timeline() const { return m_timeline; }
    std::shared_ptr<const TimelineSummary> summary(bool withPaths);

  private:
    static constexpr double secondsBack = 60;

    void step(const StepInput& input);
    void record(const StepInput& input);
    /// Somebody looks at another moment, or at the same in another way.
    void arrive();
    void beginOtherFuture(bool withGhost);
    void endFuture();
    void countFuture();

    std::uint64_t m_seed;
    Key m_focus = 0;
    std::shared_ptr<const Level> m_level; // the newest
    bool m_levelGiven = false;            // in this run; otherwise that of the run holds
    Session m_start;
    Session m_session;
    Timeline m_timeline;
    std::shared_ptr<const Level> m_edited; // not in the session yet; null when it is
    InputRuns m_record;
    std::optional<Future> m_future;
    std::optional<std::int64_t> m_sought;    // not simulated yet
    int m_futures = 0;                       // that have begun
    std::int64_t m_begun = 0;                // where the newest did
    std::optional<std::int64_t> m_changedAt; // the moment whose future has been simulated again, while it is shown
    bool m_opening = false;                  // the future is that of a recording
    std::optional<std::uint64_t> m_opened;   // hash at its end
    int m_iteration = 0;
    bool m_explains = false;
    StageTimes* m_times = nullptr;
    StepInput m_partial;                                    // of the update that is shown in the middle
    std::shared_ptr<const std::vector<TracedPath>> m_paths; // null: to be made
};

} // namespace spacetow
