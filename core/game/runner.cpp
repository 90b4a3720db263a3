#include "core/game/runner.h"

#include "core/game/crowd.h"

#include <algorithm>
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
constexpr auto glance = std::chrono::milliseconds(15);    // between two looks whether somebody does, or steers
constexpr auto slice = std::chrono::milliseconds(8);      // of simulating, between two looks at what is wanted

std::int64_t ticks(Clock::time_point time) {
    return time.time_since_epoch().count();
}

Clock::time_point timePoint(double time) {
    return Clock::time_point(std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(time)));
}

std::shared_ptr<const StepProfile> profileOf(const std::optional<StepWatch>& watch) {
    return watch ? std::make_shared<const StepProfile>(watch->profile()) : nullptr;
}

} // namespace

Runner::Runner(std::shared_ptr<const Level> level, Mode mode, std::uint64_t seed) : m_mode(mode) {
    if (mode != Mode::Deferred) {
        build(level, seed);
    }
    if (mode != Mode::Manual) {
        m_thread = std::jthread([this, level = std::move(level), seed](const std::stop_token& stop) mutable {
            if (!m_course) {
                guarded([&] { build(std::move(level), seed); });
            }
            run(stop);
        });
    }
}

void Runner::build(std::shared_ptr<const Level> level, std::uint64_t seed) {
    m_course.emplace(std::move(level), seed);
    m_last = m_course->session().snapshot();
    m_pacer = Pacer(m_course->session().updateSeconds());
    post(m_last);
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
        m_watching = false;
        restartPace();
    });
}

void Runner::watch() {
    command([this] {
        m_paused = false;
        m_watching = true;
        restartPace();
    });
}

void Runner::stepOnce() {
    command([this, held = takeHeld()] {
        const std::int64_t now = m_course->session().updates();
        if (m_course->isAtEnd()) {
            update(held);
        } else {
            m_course->seek(now + 1);
            leap();
        }
    });
}

void Runner::stepBack() {
    command([this] {
        m_followed = InputReader({});
        m_course->seek(m_course->session().updates() - 1);
        leap();
    });
}

void Runner::seek(std::int64_t update) {
    command([this, update] {
        m_followed = InputReader({});
        m_course->seek(update);
        leap();
    });
}

void Runner::stepIteration() {
    command([this, held = m_held.load()] {
        m_course->stepIteration({controlsFromBits(held), m_grab, {}});
        leap();
    });
}

void Runner::open(const Replay& recorded, const std::shared_ptr<const Level>& then) {
    command([this, recorded, then] {
        m_followed = InputReader({});
        m_course->open(recorded, then);
        leap();
        simulate();
    });
}

void Runner::stopSimulating() {
    command([this] {
        m_course->stopSimulating();
        post(m_last);
    });
}

/// To another moment.
void Runner::leap() {
    m_paused = true;
    m_watching = false;
    m_prepared = false;
    m_latched.store(0);
    keepPace();
    showAgain();
}

void Runner::restart() {
    command([this] { beginAnew(); });
}

void Runner::follow(const Replay& recorded) {
    command([this, recorded] {
        beginAnew();
        m_followed = InputReader(inputsOf(recorded, m_course->session().level()));
    });
}

void Runner::follow(std::vector<Replay::Run> recorded) {
    Replay replay;
    replay.runs = std::move(recorded);
    follow(replay);
}

void Runner::beginAnew() {
    m_course->restart();
    m_followed.restart();
    m_watching = false;
    m_latched.store(0);
    m_pacer = Pacer(m_course->session().updateSeconds() / m_speed);
    m_pacer.restart(seconds(Clock::now()));
    showAgain();
}

void Runner::setSpeed(double speed) {
    command([this, speed] {
        m_speed = speed >= slowest ? std::min(speed, fastest) : slowest;
        m_pacer.setPeriod(m_course->session().updateSeconds() / m_speed);
        restartPace();
    });
}

void Runner::setLevel(std::shared_ptr<const Level> level) {
    command([this, level = std::move(level)] {
        m_course->setLevel(level);
        showAgain();
        simulate();
    });
}

void Runner::showAgain() {
    m_last = m_course->isShownAsIs() ? m_course->session().snapshot() : m_course->shown().snapshot();
    post(m_last);
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
        m_asked = false;
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

bool Runner::isAsked() {
    const std::lock_guard lock(m_mutex);
    return m_asked;
}

void Runner::run(const std::stop_token& stop) {
    m_pacer.restart(seconds(Clock::now()));
    while (!stop.stop_requested() && fault() == RunnerFault::None) {
        guarded([&] { turn(stop); });
    }
    if (isAsked() && fault() == RunnerFault::None) {
        guarded([this] { obeyCommands(); }); // who asked for what was flown gets it, however soon the run was ended
    }
    const std::lock_guard lock(m_mutex); // nobody waits for an answer that never comes
    m_commands.clear();
}

/// Makes what is due, and waits for the next update or command.
void Runner::turn(const std::stop_token& stop) {
    obeyCommands();
    if (const bool waits = !m_paused && (isUnattended() || awaitsPilot()); waits != m_waits) {
        m_waits = waits;
        restartPace();
    }
    if (m_course->isSimulating()) {
        simulate();
    } else if (m_paused && !m_prepared) {
        m_prepared = m_course->prepareBack(4);
    }
    const int due = m_paused || m_waits ? 0 : m_pacer.due(seconds(Clock::now()));
    for (int i = 0; i < due && !stop.stop_requested() && fault() == RunnerFault::None; ++i) {
        m_more = i + 1 < due;
        if (!update()) {
            break;
        }
    }
    m_more = false;
    if (m_waits && m_withSession && Clock::now() >= m_nextCopy && m_frames.latest()->ofSession != m_last) {
        post(m_last); // nothing else would bring a newer copy
    }
    if (m_course->isSimulating() || (m_paused && !m_prepared)) {
        return;
    }
    m_lender.collect();
    std::unique_lock lock(m_mutex);
    const auto called = [this] { return !m_commands.empty(); };
    if (m_paused || m_waits) { // copies that come back are to be freed, keys to be seen
        m_wake.wait_for(lock, stop, m_paused ? patience : glance, called);
    } else {
        m_wake.wait_until(lock, stop, timePoint(m_pacer.next()), called);
    }
}

std::uint8_t Runner::takeHeld() {
    return static_cast<std::uint8_t>(m_held.load() | m_latched.exchange(0));
}

StepInput Runner::nextInput(std::uint8_t held) {
    return m_followed.isAtEnd() ? StepInput{controlsFromBits(held), m_grab, {}} : m_followed.next();
}

bool Runner::failsAt(std::int64_t update, const World& world) {
    const bool fails = isCrowdedAt(update, world);
    if (fails) {
        m_fault = RunnerFault::Crowd;
    }
    return fails;
}

/// False when nothing moves any more.
bool Runner::update(const std::optional<std::uint8_t>& held) {
    if (failsAt(m_course->session().updates(), m_course->session().world())) {
        return false;
    }
    m_course->observe(m_withSession, m_watch ? &m_watch->times() : nullptr);
    if (!m_watching) {
        m_course->goOn(nextInput(held ? *held : takeHeld()));
    } else if (!m_course->goAlong()) {
        if (!m_course->isSimulating()) {
            leap();
        }
        return false;
    }
    if (m_watch) {
        m_watch->note();
    }
    keepPace();
    const std::shared_ptr<const Snapshot> before = m_last;
    m_last = m_course->session().snapshot();
    m_sounds.fetch_or(m_last->sounds);
    post(before);
    return true;
}

/// A threaded runner does a little of it at a time, for it may be told something else meanwhile.
void Runner::simulate() {
    const Clock::time_point until = Clock::now() + slice;
    std::int64_t at = m_course->session().updates();
    while (m_course->isSimulating() && (m_mode == Mode::Manual || Clock::now() < until)) {
        if (failsAt(m_course->simulated(), m_course->newestWorld())) {
            return;
        }
        m_course->simulate(1);
    }
    if (at != m_course->session().updates()) {
        leap();
    } else {
        post(m_last);
    }
}

void Runner::restartPace() {
    m_pacer.restart(seconds(Clock::now()));
    post(m_last);
}

/// A level may have been given another length of its updates.
void Runner::keepPace() {
    const double period = m_course->session().updateSeconds() / m_speed;
    if (period != m_pacer.period()) {
        m_pacer.setPeriod(period);
    }
}

void Runner::post(std::shared_ptr<const Snapshot> before) {
    const std::shared_ptr<const Frame> last = m_frames.latest();
    m_lender.collect();
    std::shared_ptr<const Session> session;
    std::shared_ptr<const Snapshot> ofSession = m_last;
    if (m_withSession && !m_paused && last && last->session && (m_more || Clock::now() < m_nextCopy)) {
        session = last->session; // others follow soon
        ofSession = last->ofSession;
    } else if (m_withSession) {
        const Clock::time_point begun = Clock::now();
        session = m_lender.copyOf(m_course->isShownAsIs() ? m_course->session() : m_course->shown());
        constexpr int share = 10; // of the time, that copying takes at most
        const Clock::time_point done = Clock::now();
        m_nextCopy = m_mode == Mode::Manual ? done : done + share * (done - begun);
    }
    m_frames.post(std::make_shared<const Frame>(
        Frame{std::move(before), m_last, Clock::now(), m_pacer.period(), m_speed, m_paused || m_waits,
              std::move(session), std::move(ofSession), m_course->summary(m_paused), profileOf(m_watch)}));
}

} // namespace spacetow
