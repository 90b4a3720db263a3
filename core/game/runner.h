#pragma once
// Runs a session in real time on a thread of its own and hands out pictures of it. Any thread may call the members;
// no lock is held while the session steps. While paused no time passes.

#include "core/base/mailbox.h"
#include "core/game/course.h"
#include "core/game/pacer.h"
#include "core/game/session_lender.h"
#include "core/game/step_profile.h"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

namespace spacetow {

/// The newest two pictures, to be blended while the next update is awaited.
struct Frame {
    std::shared_ptr<const Snapshot> before, now; // never null; the same in the first frame and after every leap in time
    std::chrono::steady_clock::time_point at;    // when `now` was taken
    double period = 0.02;                        // s that pass between the two; simulated are `speed` times as many
    double speed = 1;                            // of the game, in that of the clock
    bool paused = false;
    std::shared_ptr<const Session> session{};          // a copy, of `now` or a little older; null unless it is wanted
    std::shared_ptr<const Snapshot> ofSession{};       // of the moment at which it is
    std::shared_ptr<const TimelineSummary> timeline{}; // never null
    std::shared_ptr<const StepProfile> profile{};      // null unless it is wanted
};

/// Why a game has ended by itself.
enum class RunnerFault : std::uint8_t { None, Memory, Crowd };

class Runner {
  public:
    /// A manual runner has no thread: `advance` makes its updates, and everything else happens at once. A deferred one
    /// is threaded, and builds its session in its thread too: it has no frame until that is done. What it is told
    /// meanwhile it does then.
    enum class Mode { Threaded, Deferred, Manual };

    /// A threaded runner starts at once.
    explicit Runner(std::shared_ptr<const Level> level, Mode mode = Mode::Threaded, std::uint64_t seed = 1);
    explicit Runner(const Level& level, Mode mode = Mode::Threaded, std::uint64_t seed = 1)
        : Runner(std::make_shared<const Level>(level), mode, seed) {}
    ~Runner();
    Runner(const Runner&) = delete;
    Runner& operator=(const Runner&) = delete;

    /// What is held down from now on. A key that is let go before the next update still counts in that one.
    void hold(const Controls& controls);
    void pause();
    void resume();
    /// One update, whether paused or not; before the end of the run, the next one as it was. What is held down now
    /// counts in it, also when it is let go before the update is made.
    void stepOnce();
    /// Whoever looks at a moment, here and below, has paused. To go on from there is to begin another future.
    void stepBack();
    /// One iteration of the next update, for looking only; the last one makes the update. Likewise.
    void stepIteration();
    /// The moment after so many updates, or the nearest that is kept.
    void seek(std::int64_t update);
    /// Goes on along the run as it was, and pauses at its end.
    void watch();
    /// Begins anew with a recorded run, and pauses: all of it is simulated at once, and can be looked at.
    /// `then`: see Course::open.
    void open(const Replay& recorded, const std::shared_ptr<const Level>& then = nullptr);
    /// What is being simulated ends where it has come to.
    void stopSimulating();
    /// Back to the first update with the same seed; the recording starts again as well.
    void restart();
    /// Begins anew and holds what the recording held, instead of what is held down, until the recording ends. Its seed
    /// is that of the runner.
    void follow(const Replay& recorded);
    void follow(std::vector<Replay::Run> recorded);
    /// Whether frames have a copy of the session. While time passes, a tenth of it at most is spent on copies: that of
    /// a large level may be some updates old.
    void wantSession(bool wanted);
    /// Whether updates are timed, and frames have the figures. It costs looks at the clock.
    void wantProfile(bool wanted);
    /// The object that somebody looks at, 0 for none: see Timeline::setFocus.
    void setFocus(Key object);
    /// What the mouse holds from the next update on; none lets go.
    void setGrab(const std::optional<Grab>& grab) {
        command([this, grab] { m_grab = grab; });
    }
    /// So many times as fast as the clock, within `slowest` … `fastest`.
    void setSpeed(double speed);
    static constexpr double slowest = 1.0 / 16, fastest = 8;
    /// The level as it has been edited: shown at once, and taken over with the next update. Before the end of the run
    /// the future is simulated again, beside what else happens. A restart begins with it.
    void setLevel(std::shared_ptr<const Level> level);

    /// Whether a ship that waits for its pilot has all else wait too, as long as no key is down and the mouse holds
    /// nothing: else what moves would be somewhere else whenever one begins. Not in recordings.
    void waitForPilot(bool waits) {
        command([this, waits] { m_forPilot = waits; });
    }
    /// Somebody looks. Who has once said so and then is silent for half a second does not see what happens, nor can
    /// they let go of a key: the game waits for them.
    void attend();
    /// When it is not None, nothing moves any more.
    RunnerFault fault() const { return m_fault; }

    /// Null only before a deferred runner has built its session.
    std::shared_ptr<const Frame> frame() const { return m_frames.latest(); }
    /// Sound bits of all updates since the last call.
    std::uint32_t takeSounds() { return m_sounds.exchange(0); }
    /// What is recorded when the update that runs has ended. It is what is returned that waits for it, in any thread;
    /// the runner may be gone by then. Empty after a fault.
    std::function<Recording()> askRecording();

    /// Of a manual runner: makes updates unless paused.
    void advance(int updates = 1);

  private:
    using Command = std::function<void()>;

    void build(std::shared_ptr<const Level> level, std::uint64_t seed);
    void command(Command command);
    void obeyCommands();
    bool isAsked();
    void run(const std::stop_token& stop);
    void turn(const std::stop_token& stop);
    bool isUnattended() const;
    bool awaitsPilot() const {
        return m_forPilot && !m_watching && m_followed.isAtEnd() && !m_grab && m_held == 0 && m_latched == 0 &&
               m_course->isShownAsIs() && wouldMoveUnsteered(*m_last);
    }
    /// Does it, and remembers when it could not be done.
    template <class Do>
    void guarded(const Do& work);
    void beginAnew();
    void leap();
    StepInput nextInput(std::uint8_t held);
    std::uint8_t takeHeld();
    /// With what is held down now, unless it is said.
    bool update(const std::optional<std::uint8_t>& held = {});
    void simulate();
    /// Then nothing moves any more.
    bool failsAt(std::int64_t update, const World& world);
    /// Time passes from now on, and frames say so.
    void restartPace();
    void keepPace();
    void post(std::shared_ptr<const Snapshot> before);
    /// When nothing has moved but how it is looked at.
    void showAgain();

    const Mode m_mode;

    // Of the runner's thread, or of the caller's when manual.
    std::optional<Course> m_course; // once it is built
    std::optional<Grab> m_grab;
    double m_speed = 1;
    std::shared_ptr<const Snapshot> m_last;
    InputReader m_followed{{}}; // instead of what is held, until it ends
    bool m_watching = false;
    bool m_prepared = true; // for going back
    Pacer m_pacer{0.02};
    bool m_paused = false;
    bool m_forPilot = false;
    bool m_waits = false; // though not paused: nobody looks, or nobody steers yet
    bool m_withSession = false;
    SessionLender m_lender;
    std::chrono::steady_clock::time_point m_nextCopy{}; // not before, while time passes
    std::optional<StepWatch> m_watch;                   // while a profile is wanted
    bool m_more = false;                                // updates are due at once

    // Between the threads.
    Mailbox<Frame> m_frames;
    std::atomic<std::uint8_t> m_held = 0, m_latched = 0; // bits of Controls
    std::atomic<std::uint32_t> m_sounds = 0;
    std::atomic<std::int64_t> m_attended = 0; // when; 0: never
    std::atomic<RunnerFault> m_fault = RunnerFault::None;
    std::mutex m_mutex;
    std::condition_variable_any m_wake;
    std::vector<Command> m_commands; // guarded by m_mutex
    bool m_asked = false;            // likewise: one of them is a question
    std::jthread m_thread;           // last, so that it ends first
};

} // namespace spacetow
