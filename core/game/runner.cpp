#include "core/game/runner.h"

#include "core/game/crowd.h"

#include <algorithm>
#include <future>
#include <new>
#include <stdexcept>
#include <utility>

namespace spacetow {
namespace {

using Clock = std::chrono::steady_clock;

double seconds(Clock::time_point time) {
    return std::chrono::duration<double>(time.time_since_epoch()).count();
}

constexpr auto patience = std::chrono::milliseconds(500); // after which nobody looks
constexpr auto glance = std::chrono::milliseconds(50);    // between two looks whether somebody does
constexpr std::int64_t crowdInterval = 50;                // updates

std::int64_t ticks(Clock::time_point time) {
    return time.time_since_epoch().count();
}

Clock::time_point timePoint(double time) {
    return Clock::time_point(std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(time)));
}

} // namespace

Runner::Runner(const Level& level, Mode mode, std::uint64_t seed)
    : m_mode(mode), m_start(level, seed), m_session(m_start), m_last(m_session.snapshot()),
      m_pacer(m_session.updateSeconds()) {
    m_recording.seed = seed;
    post(m_last);
    if (mode == Mode::Threaded) {
        m_thread = std::jthread([this](const std::stop_token& stop) { run(stop); });
    }
}

Runner::~Runner() = default;

void Runner::hold(const Controls& controls) {
    const std::uint8_t bits = toBits(controls);
    const std::uint8_t before = m_held.exchange(bits);
    m_latched.fetch_or(static_cast<std::uint8_t>(bits & ~before)); // what is held already needs no latch
}

void Runner::attend() {
    m_attended = ticks(Clock::now());
}

bool Runner::isUnattended() const {
    const std::int64_t last = m_attended;
    return last != 0 && Clock::now() - Clock::time_point(Clock::duration(last)) > patience;
}

void Runner::pause() {
    command([this] {
        m_paused = true;
        post(m_last);
    });
}

void Runner::resume() {
    command([this] {
        m_paused = false;
        m_pacer.restart(seconds(Clock::now()));
        post(m_last);
    });
}

void Runner::stepOnce() {
    command([this] { update(); });
}

void Runner::restart() {
    command([this] { beginAnew(); });
}

void Runner::follow(std::vector<Replay::Run> recorded) {
    command([this, runs = std::move(recorded)] {
        m_followed = runs;
        beginAnew();
    });
}

void Runner::beginAnew() {
    if (m_edited || m_session.sharedLevel() != m_start.sharedLevel()) {
        m_start = Session(m_edited ? m_edited : m_session.sharedLevel(), m_recording.seed);
        m_edited = nullptr;
    }
    m_session = m_start;
    m_recording.runs.clear();
    m_followedRun = 0;
    m_followedTime = 0;
    m_latched.store(0);
    m_pacer = Pacer(m_session.updateSeconds() / m_speed);
    m_pacer.restart(seconds(Clock::now()));
    m_last = m_session.snapshot(m_quadtree);
    post(m_last);
}

void Runner::wantQuadtree(bool wanted) {
    command([this, wanted] {
        m_quadtree = wanted;
        showAgain();
    });
}

void Runner::wantSession(bool wanted) {
    command([this, wanted] {
        m_withSession = wanted;
        showAgain();
    });
}

void Runner::setGrab(std::optional<Grab> grab) {
    command([this, grab] { m_grab = grab; });
}

void Runner::setSpeed(double speed) {
    command([this, speed] {
        m_speed = speed >= slowest ? std::min(speed, fastest) : slowest;
        m_pacer.setPeriod(m_session.updateSeconds() / m_speed);
        m_pacer.restart(seconds(Clock::now()));
        post(m_last);
    });
}

void Runner::setLevel(std::shared_ptr<const Level> level) {
    command([this, level = std::move(level)] {
        m_edited = level;
        showAgain();
    });
}

void Runner::showAgain() {
    if (m_edited) {
        Session edited = m_session;
        edited.adopt(m_edited);
        m_last = edited.snapshot(m_quadtree);
    } else {
        m_last = m_session.snapshot(m_quadtree);
    }
    post(m_last);
}

Replay Runner::recording() {
    auto promise = std::make_shared<std::promise<Replay>>();
    std::future<Replay> answer = promise->get_future();
    command([this, promise = std::move(promise)] { promise->set_value(m_recording); });
    try {
        return answer.get();
    } catch (const std::future_error&) { // nobody is there to answer
        return {};
    }
}

void Runner::advance(int updates) {
    EXPECTS(m_mode == Mode::Manual);
    for (int i = 0; i < updates && !m_paused && fault() == RunnerFault::None; ++i) {
        guarded([this] { update(); });
    }
}

void Runner::command(Command command) {
    if (m_mode == Mode::Manual) {
        if (fault() == RunnerFault::None) {
            guarded(command);
        }
        return;
    }
    {
        const std::lock_guard lock(m_mutex);
        if (fault() != RunnerFault::None) {
            return;
        }
        m_commands.push_back(std::move(command));
    }
    m_wake.notify_one();
}

void Runner::obeyCommands() {
    std::vector<Command> commands;
    {
        const std::lock_guard lock(m_mutex);
        commands.swap(m_commands);
    }
    for (const Command& command : commands) {
        command();
    }
}

template <class Do>
void Runner::guarded(const Do& work) {
    try {
        work();
    } catch (const std::bad_alloc&) {
        m_fault = RunnerFault::Memory;
    } catch (const std::length_error&) { // more than there could ever be room for
        m_fault = RunnerFault::Memory;
    }
}

void Runner::run(const std::stop_token& stop) {
    m_pacer.restart(seconds(Clock::now()));
    while (!stop.stop_requested() && fault() == RunnerFault::None) {
        guarded([&] { turn(stop); });
    }
    const std::lock_guard lock(m_mutex); // nobody waits for an answer that never comes
    m_commands.clear();
}

/// Makes what is due, and waits for the next update or command.
void Runner::turn(const std::stop_token& stop) {
    obeyCommands();
    if (const bool unattended = !m_paused && isUnattended(); unattended != m_unattended) {
        m_unattended = unattended;
        m_pacer.restart(seconds(Clock::now()));
        post(m_last);
    }
    const int due = m_paused || m_unattended ? 0 : m_pacer.due(seconds(Clock::now()));
    for (int i = 0; i < due && !stop.stop_requested() && fault() == RunnerFault::None; ++i) {
        m_more = i + 1 < due;
        update();
    }
    m_more = false;
    std::unique_lock lock(m_mutex);
    const auto called = [this] { return !m_commands.empty(); };
    if (m_paused) {
        m_wake.wait(lock, stop, called);
    } else {
        m_wake.wait_until(lock, stop, m_unattended ? Clock::now() + glance : timePoint(m_pacer.next()), called);
    }
}

Controls Runner::nextControls() {
    const Controls held = controlsFromBits(m_held.load() | m_latched.exchange(0));
    if (m_followedRun == m_followed.size()) {
        return held;
    }
    const Replay::Run& run = m_followed[m_followedRun];
    if (++m_followedTime == run.count) {
        ++m_followedRun;
        m_followedTime = 0;
    }
    return run.controls;
}

void Runner::update() {
    if (m_session.updates() % crowdInterval == 0 && isCrowded(m_session.world())) {
        m_fault = RunnerFault::Crowd;
        return;
    }
    const Controls controls = nextControls();
    m_session.step(StepInput{controls, m_grab, std::exchange(m_edited, nullptr)});
    keepPace();
    if (m_session.updates() <= maxReplayUpdates) {
        m_recording.append(controls);
    }
    const std::shared_ptr<const Snapshot> before = m_last;
    m_last = m_session.snapshot(m_quadtree);
    m_sounds.fetch_or(m_last->sounds);
    post(before);
}

/// A level may have been given another length of its updates.
void Runner::keepPace() {
    const double period = m_session.updateSeconds() / m_speed;
    if (period != m_pacer.period()) {
        m_pacer.setPeriod(period);
    }
}

void Runner::post(std::shared_ptr<const Snapshot> before) {
    std::shared_ptr<const Session> session;
    if (m_withSession && !m_more) {
        const auto copy = std::make_shared<Session>(m_session);
        if (m_edited) {
            copy->adopt(m_edited);
        }
        session = copy;
    } else if (const std::shared_ptr<const Frame> last = m_frames.latest(); m_withSession && last) {
        session = last->session;
    }
    m_frames.post(
        std::make_shared<const Frame>(Frame{std::move(before), m_last, Clock::now(), m_pacer.period(), m_speed,
                                            m_paused || m_unattended, m_pacer.lost(), std::move(session)}));
}

} // namespace spacetow
