#include "editor/play/play_view.h"

#include "core/game/blend.h"
#include "core/level/bounds.h"
#include "editor/canvas/scene_painter.h"
#include "editor/play/backdrop.h"
#include "editor/play/hud.h"
#include "editor/play/pause_menu.h"
#include "editor/play/scene_marks.h"

#include <QPainter>
#include <QScreen>

#include <algorithm>
#include <new>

namespace spacetow {
namespace {

const Vec2 classicView(40.0 / 3, 10); // m
constexpr double rockSeen = 0.6;      // m, of what lies beyond the level's bounds
constexpr double sideKept = 1.5;      // m, between the ship and the edge of the view

/// Along one axis, m.
struct Framing {
    double low, high; // of the level
    double half;      // of the view
    double kept;      // always in sight
};

/// The middle of the view along one axis: as little as possible beyond the level is in sight.
double framedAxis(double camera, const Framing& f) {
    const double wanted =
        f.high - f.low > 2 * f.half ? std::clamp(camera, f.low + f.half, f.high - f.half) : (f.low + f.high) / 2;
    const double room = std::max(0.0, f.half - sideKept);
    return std::clamp(wanted, f.kept - room, f.kept + room);
}

/// Where the ship is, or else what the camera looks at.
Vec2 leadOf(const Snapshot& snapshot) {
    const auto ship = std::ranges::find_if(snapshot.bodies,
                                           [](const BodyPicture& body) { return body.look->role == BodyRole::Ship; });
    return ship != snapshot.bodies.end() ? ship->pose.position : snapshot.camera;
}

/// Blended for the time that has passed since the newer picture was taken.
double shareOf(const Frame& frame) {
    const std::chrono::duration<double> since = std::chrono::steady_clock::now() - frame.at;
    return std::clamp(since.count() / frame.period, 0.0, 1.0);
}

} // namespace

PlayView::PlayView(QWidget* parent, Runner::Mode mode) : QWidget(parent), m_mode(mode), m_menu(new PauseMenu(this)) {
    setObjectName(QStringLiteral("playView"));
    setAccessibleName(tr("Running game"));
    setFocusPolicy(Qt::StrongFocus);
    setAttribute(Qt::WA_OpaquePaintEvent);
    m_frames.setTimerType(Qt::PreciseTimer);
    connect(&m_frames, &QTimer::timeout, this, &PlayView::showFrame);
    connect(m_menu, &PauseMenu::resumed, this, &PlayView::closeMenu);
    connect(m_menu, &PauseMenu::restarted, this, &PlayView::restart);
    connect(m_menu, &PauseMenu::left, this, [this] {
        stop();
        Q_EMIT finished();
    });
}

PlayView::~PlayView() = default;

void PlayView::start(const Level& level) {
    begin(level, 1);
}

void PlayView::start(const Level& level, const Replay& recorded) {
    begin(level, recorded.seed);
    if (m_runner) {
        m_runner->follow(recorded.runs);
    }
}

void PlayView::begin(const Level& level, std::uint64_t seed) {
    stop();
    try {
        m_runner = std::make_unique<Runner>(level, m_mode, seed);
    } catch (const std::bad_alloc&) {
        fail(RunnerFault::Memory);
        return;
    }
    m_background = QString::fromStdString(level.rules.background);
    m_towRange = level.rules.towRange;
    m_extent = classicView;
    m_bounds = boundsOf(level);
    if (!isFinite(m_bounds.size())) {
        m_bounds = {};
    }
    if (phase() == Phase::Sandbox && !m_bounds.isEmpty()) { // nothing to follow, so all of it should be in sight
        m_extent = m_extent.cwiseMax(1.08 * m_bounds.size());
        m_bounds = {};
    }
    m_runner->wantQuadtree(m_overlays.quadtree);
    m_lost = 0;
    m_paceTime.start();
    m_shownPhase = phase();
    follow();
    const double rate = screen() != nullptr ? std::clamp(screen()->refreshRate(), 30.0, 240.0) : 60.0;
    m_frames.start(static_cast<int>(1000 / rate));
    setFocus(Qt::OtherFocusReason);
    update();
}

void PlayView::stop() {
    m_frames.stop();
    m_menu->hide();
    m_held.clear();
    m_dragging = false;
    m_waiting = false;
    m_behind = 0;
    std::erase_if(m_ending, [](const auto& task) { return !task->isRunning(); });
    if (m_runner) {
        m_ending.push_back(std::make_unique<BackgroundTask>());
        m_ending.back()->start([game = std::shared_ptr<Runner>(std::move(m_runner))](const std::stop_token&) mutable {
            game.reset();
            return [] {};
        });
    }
    m_ground.forget();
    if (m_paused) {
        m_paused = false;
        Q_EMIT pausedChanged(false);
    }
}

int PlayView::ending() const {
    return static_cast<int>(std::ranges::count_if(m_ending, [](const auto& task) { return task->isRunning(); }));
}

void PlayView::setPaused(bool paused) {
    if (!m_runner || m_paused == paused) {
        return;
    }
    m_paused = paused;
    if (paused) {
        m_runner->pause();
    } else {
        m_menu->hide();
        setFocus(Qt::OtherFocusReason);
        goOn();
    }
    Q_EMIT pausedChanged(paused);
    update();
}

void PlayView::goOn() {
    m_runner->hold(m_held.controls());
    if (!m_waiting) {
        m_runner->resume();
    }
}

void PlayView::setWaiting(bool waiting) {
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

void PlayView::stepOnce() {
    if (m_runner) {
        setPaused(true);
        m_runner->hold(m_held.controls());
        m_runner->stepOnce();
        update();
    }
}

void PlayView::restart() {
    if (m_runner) {
        letGo();
        m_runner->restart();
        setPaused(false);
        follow();
        update();
    }
}

void PlayView::setOverlays(const OverlayFlags& overlays) {
    m_overlays = overlays;
    if (m_runner) {
        m_runner->wantQuadtree(overlays.quadtree);
    }
    update();
}

void PlayView::setKeys(const PlayKeys& keys) {
    m_keys = keys;
    m_menu->setKeys(keys);
    letGo(); // what is held may mean something else now
    update();
}

double PlayView::fittingScale() const {
    return std::min(width() / m_extent.x(), height() / m_extent.y());
}

Viewport PlayView::viewport() const {
    return m_runner ? viewport(picture()) : Viewport();
}

Viewport PlayView::viewport(const Snapshot& snapshot) const {
    Viewport view;
    view.size = Vec2(std::max(1, width()), std::max(1, height()));
    view.scale = std::clamp(m_zoom * fittingScale(), Viewport::minScale, Viewport::maxScale);
    view.center = m_lookedAt ? *m_lookedAt : framed(snapshot, view.scale);
    return view;
}

Vec2 PlayView::framed(const Snapshot& snapshot, double scale) const {
    if (m_bounds.isEmpty()) {
        return snapshot.camera;
    }
    const Aabb all = m_bounds.grown(rockSeen);
    const Vec2 lead = leadOf(snapshot);
    const Vec2& camera = snapshot.camera;
    return {framedAxis(camera.x(), {all.min.x(), all.max.x(), width() / scale / 2, lead.x()}),
            framedAxis(camera.y(), {all.min.y(), all.max.y(), height() / scale / 2, lead.y()})};
}

void PlayView::showFrame() {
    if (const RunnerFault fault = m_runner->fault(); fault != RunnerFault::None) {
        fail(fault);
        return;
    }
    m_runner->attend();
    watchPace();
    update();
    if (phase() != m_shownPhase) {
        m_shownPhase = phase();
        Q_EMIT phaseChanged();
    }
}

/// A moment's hold-up is nothing to speak of.
void PlayView::watchPace() {
    constexpr qint64 interval = 1000; // ms
    constexpr double bearable = 0.1;  // of the time that has passed
    if (m_paceTime.elapsed() < interval) {
        return;
    }
    const double passed = static_cast<double>(m_paceTime.restart()) / 1000;
    const double lost = m_runner->frame()->lost;
    const double behind = lost - m_lost > bearable * passed ? lost : 0;
    m_lost = lost;
    if (behind != m_behind) {
        m_behind = behind;
        Q_EMIT paceChanged();
    }
}

/// Once whoever has called is done.
void PlayView::fail(RunnerFault fault) {
    stop();
    QMetaObject::invokeMethod(
        this, [this, fault] { Q_EMIT failed(fault); }, Qt::QueuedConnection);
}

Phase PlayView::phase() const {
    return m_runner ? m_runner->frame()->now->phase : Phase::Sandbox;
}

Snapshot PlayView::picture() const {
    const std::shared_ptr<const Frame> frame = m_runner->frame();
    const bool still = frame->paused || m_mode == Runner::Mode::Manual;
    return blended(*frame->before, *frame->now, still ? 1 : shareOf(*frame));
}

void PlayView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    if (!m_runner) {
        painter.fillRect(rect(), canvasTheme().background);
        return;
    }
    const Snapshot snapshot = picture();
    paintScene(painter, snapshot);
    if (m_menu->isVisible()) {
        painter.fillRect(rect(), QColor(4, 8, 18, 130));
        return;
    }
    paintHud(painter, hudLayout({snapshot.phase, snapshot.hud, m_paused, m_keys}, size(), font()));
}

void PlayView::paintScene(QPainter& painter, const Snapshot& snapshot) {
    const Frame2D frame{alignedToPixels(viewport(snapshot), devicePixelRatioF()), devicePixelRatioF()};
    const Stage stage{painter, frame.view, canvasTheme()};
    paintBackdrop(stage, m_background);
    m_ground.draw(painter, frame, snapshot, canvasTheme());
    paintFlame(stage, snapshot);
    paintMoving(stage, snapshot, m_overlays);
    paintTowRange(stage, snapshot, m_towRange);
}

void PlayView::follow() {
    m_lookedAt.reset();
    m_zoom = 1;
}

void PlayView::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    if (m_runner && !m_menu->isVisible()) {
        setFocus(Qt::OtherFocusReason); // a hidden widget could not take it when the game was started
    }
}

void PlayView::resizeEvent(QResizeEvent*) {
    if (m_menu->isVisible()) {
        m_menu->placeIn(size());
    }
}

} // namespace spacetow
