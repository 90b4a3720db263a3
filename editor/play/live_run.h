#pragma once
// A game or a simulation that runs beside the editor, on a copy of the level. It owns the runner, turns keys into
// controls and watches whether the computer keeps up; it has no picture of its own, see live_view.h.

#include "core/game/runner.h"
#include "editor/canvas/background_task.h"
#include "editor/play/key_map.h"
#include "editor/play/pace_watch.h"

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include <memory>
#include <optional>
#include <set>
#include <vector>

namespace spacetow {

class LiveRun : public QObject {
    Q_OBJECT

  public:
    /// A game has lives, a head-up display and the keyboard; beside a simulation the editor works on.
    using Kind = RunKind;

    /// With a manual runner nothing moves but by Runner::advance, for tests and screenshots.
    explicit LiveRun(QObject* parent = nullptr, Runner::Mode mode = Runner::Mode::Threaded);
    ~LiveRun() override;

    /// Runs the level from its beginning; what was running before is stopped. A level without a ship is no game. What
    /// takes long to build is built beside the window: until then the run is starting, and can be told what to do.
    void start(std::shared_ptr<const Level> level, Kind wanted = Kind::Game);
    /// The same as it ran once, of the kind that it was: all of it can be looked at. Who steers takes over, and another
    /// future begins.
    /// `then`: see Course::open.
    void start(std::shared_ptr<const Level> level, const Replay& recorded,
               const std::shared_ptr<const Level>& then = nullptr);
    void start(const Level& level, Kind wanted = Kind::Game) { start(std::make_shared<const Level>(level), wanted); }
    /// Of a level that is too much an update takes seconds; nobody waits for the one that is running.
    void stop();
    bool isRunning() const { return m_runner != nullptr && !m_starting; }
    bool isStarting() const { return m_starting; }
    /// Since when, s.
    double startingFor() const { return static_cast<double>(m_startTime.elapsed()) / 1000; }
    /// Also what is starting, where that was wanted; whether the level has a ship is known when it runs.
    bool isGame() const { return m_runner && m_kind == Kind::Game; }
    /// Of what runs or is starting.
    Kind kind() const { return m_kind; }
    /// Runs whose last update has not ended yet.
    int ending() const;

    /// Ends a rewinding, as all do that go to another moment.
    void setPaused(bool paused);
    bool isPaused() const { return m_paused; }
    /// The run waits while something else in the window has the keyboard, and then is as it was before.
    void setWaiting(bool waiting);
    bool isWaiting() const { return m_waiting; }
    /// Pauses and makes one update.
    void stepOnce();
    /// Pauses, and shows the update before, or the next one by one iteration more.
    void stepBack();
    void stepIteration();
    /// Pauses, and shows the moment after so many updates; the ends of what can be looked at.
    void seek(std::int64_t update);
    void seekFirst();
    void seekLast();
    /// As long as it is on, time goes back; then it goes on as before, unless something else was said meanwhile.
    void setRewinding(bool rewinding);
    bool isRewinding() const { return m_rewinding; }
    void restart();
    /// Whether somebody needs copies of what runs, see session(). Each asks for itself.
    void wantSession(const void* who, bool wanted);
    /// Whether frames tell how long the stages of updates took.
    void wantProfile(bool wanted);
    /// A recorded flight goes its way, and nobody has taken over yet.
    bool isWatching() const { return m_watching; }

    /// So many times as fast as the clock; a step of them is twice as fast or half. Stays over restarts.
    double speed() const { return m_speed; }
    void setSpeed(double speed);
    void changeSpeed(bool faster) { setSpeed(faster ? 2 * m_speed : m_speed / 2); }
    /// The object that somebody looks at, 0 for none, in this run and the next ones: its touches are marked.
    void setFocus(Key object);
    /// What the mouse holds; none lets go.
    void setGrab(const std::optional<Grab>& grab);
    /// The level as it has been edited, from now on.
    void setLevel(std::shared_ptr<const Level> level);

    void setKeys(const PlayKeys& keys);
    const PlayKeys& keys() const { return m_keys; }
    /// True when the key steers. While paused it counts in the steps that follow, and when the run goes on.
    bool press(const QKeyEvent& event);
    void release(const QKeyEvent& event);
    void letGo();
    /// A key that steers nothing, for those messages that any key answers.
    void tapIfOver();

    /// Sandbox while nothing runs.
    Phase phase() const;
    /// How many have been made that can be seen; 0 while nothing runs.
    std::int64_t updates() const { return isRunning() ? m_runner->frame()->now->update : 0; }
    /// By how many seconds the run is behind real time, while it falls back further; 0 while it keeps up.
    double behind() const { return m_behind; }
    /// The newest two pictures; null while nothing runs.
    std::shared_ptr<const Frame> frame() const { return isRunning() ? m_runner->frame() : nullptr; }
    /// The newest copy of what runs; null while nothing does, or nobody wants it.
    std::shared_ptr<const Session> session() const { return isRunning() ? m_runner->frame()->session : nullptr; }
    std::shared_ptr<const TimelineSummary> timeline() const {
        return isRunning() ? m_runner->frame()->timeline : nullptr;
    }
    /// What there is to see now, between the newest two. Something must run.
    Snapshot picture() const;
    /// Null while nothing runs.
    Runner* runner() { return isRunning() ? m_runner.get() : nullptr; }

  signals:
    /// Still starting, or no longer; some times a second, for who shows for how long.
    void startingChanged();
    void started();
    void stopped();
    /// There may be something new to see; at the display's rate while time passes.
    void advanced();
    void pausedChanged(bool paused);
    void speedChanged();
    /// Seen at the display's rate.
    void phaseChanged();
    /// Seen once a second.
    void paceChanged();
    /// The run could not go on, and has been stopped.
    void failed(spacetow::RunnerFault fault);

  private:
    struct Recorded {
        const Replay& replay;
        const std::shared_ptr<const Level>& then; // null for none
    };
    void begin(std::shared_ptr<const Level> level, const Recorded* recorded);
    void awaitStart();
    void beStarted();
    void look();
    void watchPace();
    void fail(RunnerFault fault);
    void goOn();
    void rewind();

    const Runner::Mode m_mode;
    Kind m_kind = Kind::Game;
    std::unique_ptr<Runner> m_runner;
    bool m_starting = false;
    QElapsedTimer m_startTime, m_startTold;
    std::vector<std::unique_ptr<BackgroundTask>> m_ending;
    QTimer m_frames;
    PlayKeys m_keys;
    HeldKeys m_held;
    std::set<const void*> m_sessionWanted; // who wants it
    double m_speed = 1;
    Key m_focus = 0;
    std::shared_ptr<const Frame> m_seen; // the last that was told of
    bool m_watching = false;
    bool m_rewinding = false;
    bool m_ranBefore = false;     // it was rewound
    std::int64_t m_rewoundTo = 0; // shown or asked for
    QElapsedTimer m_rewindTime;
    bool m_profile = false;
    Phase m_shownPhase = Phase::Sandbox;
    PaceWatch m_pace;
    double m_behind = 0; // s
    bool m_paused = false;
    bool m_waiting = false; // though not paused
};

} // namespace spacetow
