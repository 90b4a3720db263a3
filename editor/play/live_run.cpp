#include "editor/play/live_run.h"

#include "core/game/blend.h"
#include "core/level/build.h"

#include <QGuiApplication>
#include <QScreen>

#include <algorithm>
#include <new>
#include <utility>

namespace spacetow {
namespace {

/// Blended for the time that has passed since the newer picture was taken.
double shareOf(const Frame& frame) {
    const std::chrono::duration<double> since = std::chrono::steady_clock::now() - frame.at;
    return std::clamp(since.count() / frame.period, 0.0, 1.0);
}

/// A level like those of the campaign is built within a frame.
bool takesLongToBuild(const Level& level) {
    constexpr std::size_t most = 1000;
    return partsToBuild(level, most) > most;
}

} // namespace

LiveRun::LiveRun(QObject* parent, Runner::Mode mode) : QObject(parent), m_mode(mode) {
    m_frames.setTimerType(Qt::PreciseTimer);
    connect(&m_frames, &QTimer::timeout, this, &LiveRun::look);
}

LiveRun::~LiveRun() = default;

void LiveRun::start(std::shared_ptr<const Level> level, Kind wanted) {
    stop();
    m_kind = wanted;
    begin(std::move(level), nullptr);
}

void LiveRun::start(std::shared_ptr<const Level> level, const Replay& recorded,
                    const std::shared_ptr<const Level>& then) {
    stop();
    m_kind = recorded.kind;
    const Recorded whole{recorded, then};
    begin(std::move(level), &whole);
}

void LiveRun::begin(std::shared_ptr<const Level> level, const Recorded* recorded) {
    const bool deferred = m_mode == Runner::Mode::Threaded && takesLongToBuild(*level);
    try {
        m_runner = std::make_unique<Runner>(std::move(level), deferred ? Runner::Mode::Deferred : m_mode,
                                            recorded != nullptr ? recorded->replay.seed : 1);
    } catch (const std::bad_alloc&) {
        fail(RunnerFault::Memory);
        return;
    }
    m_runner->waitForPilot(m_kind == Kind::Game);
    m_runner->wantSession(!m_sessionWanted.empty());
    m_runner->wantProfile(m_profile);
    m_runner->setFocus(m_focus);
    if (recorded != nullptr) {
        m_runner->open(recorded->replay, recorded->then);
        m_runner->watch();
        m_watching = true;
    }
    const QScreen* const screen = QGuiApplication::primaryScreen();
    const double rate = screen != nullptr ? std::clamp(screen->refreshRate(), 30.0, 240.0) : 60.0;
    m_frames.start(static_cast<int>(1000 / rate));
    m_starting = deferred;
    if (m_starting) {
        m_startTime.start();
        m_startTold.start();
        Q_EMIT startingChanged();
    } else {
        beStarted();
    }
}

void LiveRun::awaitStart() {
    constexpr qint64 interval = 200; // ms
    if (m_runner->frame() != nullptr) {
        m_starting = false;
        beStarted();
        Q_EMIT startingChanged();
    } else if (m_startTold.elapsed() >= interval) {
        m_startTold.start();
        Q_EMIT startingChanged();
    }
}

void LiveRun::beStarted() {
    if (phase() == Phase::Sandbox) {
        m_kind = Kind::Simulation;
    }
    m_pace = {};
    m_shownPhase = phase();
    Q_EMIT started();
}

void LiveRun::stop() {
    m_frames.stop();
    m_held.clear();
    m_waiting = m_watching = m_rewinding = false;
    m_behind = 0;
    setSpeed(1);
    std::erase_if(m_ending, [](const auto& task) { return !task->isRunning(); });
    if (!m_runner) {
        return;
    }
    const bool ran = !std::exchange(m_starting, false);
    m_ending.push_back(std::make_unique<BackgroundTask>());
    m_ending.back()->start([run = std::shared_ptr<Runner>(std::move(m_runner))](const std::stop_token&) mutable {
        run.reset();
        return [] {};
    });
    if (std::exchange(m_paused, false)) {
        Q_EMIT pausedChanged(false);
    }
    if (ran) {
        Q_EMIT stopped();
    } else {
        Q_EMIT startingChanged();
    }
}

int LiveRun::ending() const {
    return static_cast<int>(std::ranges::count_if(m_ending, [](const auto& task) { return task->isRunning(); }));
}

void LiveRun::setPaused(bool paused) {
    m_rewinding = false;
    if (!m_runner || m_paused == paused) {
        return;
    }
    m_paused = paused;
    if (paused) {
        m_runner->pause();
    } else {
        goOn();
    }
    Q_EMIT pausedChanged(paused);
    Q_EMIT advanced();
}

void LiveRun::goOn() {
    m_pace.lookAnew();
    m_runner->hold(m_held.controls());
    if (m_waiting) {
        return;
    }
    if (m_watching) {
        m_runner->watch();
    } else {
        m_runner->resume();
    }
}

void LiveRun::setWaiting(bool waiting) {
    if (!m_runner || m_waiting == waiting) {
        return;
    }
    m_waiting = waiting;
    if (waiting) {
        letGo(); // the releases go elsewhere
        m_runner->pause();
    } else if (!m_paused) {
        goOn();
    }
}

void LiveRun::stepOnce() {
    if (m_runner) {
        setPaused(true);
        m_runner->hold(m_held.controls());
        m_runner->stepOnce();
        Q_EMIT advanced();
    }
}

void LiveRun::stepBack() {
    if (m_runner) {
        setPaused(true);
        m_runner->stepBack();
        Q_EMIT advanced();
    }
}

void LiveRun::stepIteration() {
    if (m_runner) {
        setPaused(true);
        m_runner->hold(m_held.controls());
        m_runner->stepIteration();
        Q_EMIT advanced();
    }
}

void LiveRun::seek(std::int64_t update) {
    if (m_runner) {
        setPaused(true);
        m_runner->seek(update);
        Q_EMIT advanced();
    }
}

void LiveRun::seekFirst() {
    if (const auto timeline = this->timeline()) {
        seek(timeline->first);
    }
}

void LiveRun::seekLast() {
    if (const auto timeline = this->timeline()) {
        seek(std::max(timeline->last, timeline->goal));
    }
}

void LiveRun::setRewinding(bool rewinding) {
    if (!isRunning() || m_rewinding == rewinding) {
        return;
    }
    if (rewinding) {
        m_ranBefore = !m_paused;
        setPaused(true);
        m_rewinding = true;
        m_rewoundTo = timeline()->shown;
        m_rewindTime.start();
    } else {
        setPaused(!m_ranBefore);
    }
}

/// Twice as fast as it went forwards, or as fast as the computer can.
void LiveRun::rewind() {
    const auto timeline = this->timeline();
    const double seconds = 2 * std::max(1.0, m_speed) * static_cast<double>(m_rewindTime.elapsed()) / 1000;
    const auto updates = static_cast<std::int64_t>(seconds / timeline->updateSeconds);
    if (updates < 1 || timeline->shown > m_rewoundTo) {
        return; // what was asked for last is still to come
    }
    m_rewindTime.restart();
    m_rewoundTo = std::max(timeline->first, timeline->shown - updates);
    m_runner->seek(m_rewoundTo);
}

void LiveRun::setSpeed(double speed) {
    const double next = std::clamp(speed, Runner::slowest, Runner::fastest);
    if (next == m_speed) {
        return;
    }
    m_speed = next;
    m_pace.lookAnew();
    if (m_runner) {
        m_runner->setSpeed(next);
    }
    Q_EMIT speedChanged();
}

void LiveRun::setFocus(Key object) {
    if (std::exchange(m_focus, object) != object && m_runner) {
        m_runner->setFocus(object);
    }
}

void LiveRun::setGrab(const std::optional<Grab>& grab) {
    if (m_runner) {
        m_runner->setGrab(grab);
    }
}

void LiveRun::setLevel(std::shared_ptr<const Level> level) {
    if (m_runner) {
        m_runner->setLevel(std::move(level));
        Q_EMIT advanced();
    }
}

void LiveRun::restart() {
    if (m_runner) {
        letGo();
        m_watching = false;
        m_runner->restart();
        setPaused(false);
        Q_EMIT advanced();
    }
}

void LiveRun::wantSession(const void* who, bool wanted) {
    const bool before = !m_sessionWanted.empty();
    wanted ? m_sessionWanted.insert(who).second : m_sessionWanted.erase(who) > 0;
    if (m_runner && before == m_sessionWanted.empty()) {
        m_runner->wantSession(!m_sessionWanted.empty());
    }
}

void LiveRun::wantProfile(bool wanted) {
    if (std::exchange(m_profile, wanted) != wanted && m_runner) {
        m_runner->wantProfile(wanted);
    }
}

void LiveRun::setKeys(const PlayKeys& keys) {
    m_keys = keys;
    letGo(); // what is held may mean something else now
}

bool LiveRun::press(const QKeyEvent& event) {
    const bool steers = m_held.press(event, m_keys);
    if (steers && m_runner && !m_paused) {
        if (std::exchange(m_watching, false)) {
            m_runner->resume(); // whoever steers takes over
        }
        m_runner->hold(m_held.controls());
    }
    return steers;
}

void LiveRun::release(const QKeyEvent& event) {
    m_held.release(event);
    if (m_runner) {
        m_runner->hold(m_held.controls());
    }
}

void LiveRun::letGo() {
    m_held.clear();
    if (m_runner) {
        m_runner->hold({});
    }
}

void LiveRun::tapIfOver() {
    if (phase() == Phase::Crashed || phase() == Phase::GameOver) {
        Controls tap = m_held.controls();
        tap.tow = true;
        m_runner->hold(tap);
        m_runner->hold(m_held.controls());
    }
}

void LiveRun::look() {
    if (const RunnerFault fault = m_runner->fault(); fault != RunnerFault::None) {
        fail(fault);
        return;
    }
    if (m_starting) {
        awaitStart();
        return;
    }
    m_runner->attend();
    watchPace();
    if (m_rewinding) {
        rewind();
    }
    const std::shared_ptr<const Frame> frame = m_runner->frame();
    if (m_watching && !m_paused && frame->paused && frame->timeline->shown >= frame->timeline->goal) {
        m_watching = false; // it has ended, and waits to be gone on from
        m_paused = true;
        Q_EMIT pausedChanged(true);
    }
    if (const bool same = std::exchange(m_seen, frame) == frame; !same || !frame->paused) {
        Q_EMIT advanced();
    }
    if (m_runner && phase() != m_shownPhase) {
        m_shownPhase = phase();
        Q_EMIT phaseChanged();
    }
}

void LiveRun::watchPace() {
    const std::shared_ptr<const Frame> frame = m_runner->frame();
    const std::chrono::duration<double> now = std::chrono::steady_clock::now().time_since_epoch();
    const double behind = m_pace.behind({now.count(), frame->now->update, frame->period, frame->paused});
    if (behind != m_behind) {
        m_behind = behind;
        Q_EMIT paceChanged();
    }
}

/// Once whoever has called is done.
void LiveRun::fail(RunnerFault fault) {
    stop();
    QMetaObject::invokeMethod(
        this, [this, fault] { Q_EMIT failed(fault); }, Qt::QueuedConnection);
}

Phase LiveRun::phase() const {
    return isRunning() ? m_runner->frame()->now->phase : Phase::Sandbox;
}

Snapshot LiveRun::picture() const {
    const std::shared_ptr<const Frame> frame = m_runner->frame();
    const bool still = frame->paused || m_mode == Runner::Mode::Manual;
    return blended(*frame->before, *frame->now, still ? 1 : shareOf(*frame));
}

} // namespace spacetow
