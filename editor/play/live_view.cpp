#include "editor/play/live_view.h"

#include "core/level/bounds.h"
#include "core/level/groups.h"
#include "editor/canvas/grid_painter.h"
#include "editor/canvas/guide_painter.h"
#include "editor/canvas/overlay_painter.h"
#include "editor/canvas/palette.h"
#include "editor/canvas/scene_painter.h"
#include "editor/play/backdrop.h"
#include "editor/play/chase.h"
#include "editor/play/crash_words.h"
#include "editor/play/grab_painter.h"
#include "editor/play/hud.h"
#include "editor/play/live_pose.h"
#include "editor/play/pause_menu.h"
#include "editor/play/scene_marks.h"

#include <QScopedValueRollback>

#include <algorithm>
#include <utility>

namespace spacetow {

LiveView::LiveView(Document& document, Toolbox& toolbox, Canvas& canvas, LiveRun& run)
    : m_document(document), m_toolbox(toolbox), m_canvas(canvas), m_run(run), m_hand(document, toolbox, run),
      m_menu(new PauseMenu(&canvas)) {
    connect(&run, &LiveRun::advanced, this, &LiveView::refresh);
    connect(&canvas, &Canvas::viewChanged, this, &LiveView::viewMoved);
    connect(m_menu, &PauseMenu::resumed, this, &LiveView::closeMenu);
    connect(m_menu, &PauseMenu::restarted, this, [this] {
        m_menu->hide();
        m_canvas.setFocus(Qt::OtherFocusReason);
        m_run.restart();
    });
    connect(m_menu, &PauseMenu::left, this, [this] {
        m_run.stop();
        Q_EMIT finished();
    });
    connect(&run, &LiveRun::pausedChanged, this, [this](bool paused) {
        if (!paused && (m_menu->isVisible() || m_run.isGame())) {
            m_menu->hide();
            m_canvas.setFocus(Qt::OtherFocusReason); // whoever lets a game go on wants to steer
        }
    });
    connect(&run, &LiveRun::stopped, this, [this] { m_menu->hide(); });
    m_ground.painted = [this] { m_canvas.update(); };
    m_marks.painted = [this] { refresh(); };
}

LiveView::~LiveView() {
    hide();
    m_run.wantSession(this, false);
}

void LiveView::knowLevel(const Level& level) {
    m_background = QString::fromStdString(level.rules.background);
    m_towRange = level.rules.towRange;
    m_goal = QString::fromStdString(level.description);
}

void LiveView::show(const Level& level, bool anew) {
    knowLevel(level);
    m_bounds = boundsOf(level);
    if (!isFinite(m_bounds.size())) {
        m_bounds = {};
    }
    m_ground.forget(m_canvas.groundPicture(!m_run.isGame())); // in space the board's rock would end at its border
    m_shown = true;
    m_framing = m_run.isGame() && m_canvas.isFitted() && !m_bounds.isEmpty() ? Framing::Whole : Framing::Free;
    m_lastUpdate = 0;
    m_sinceLook.start();
    m_sinceCount.start();
    m_frames = 0;
    m_canvas.showLive(this);
    m_lastView = m_canvas.view();
    if (m_run.isRunning()) {
        m_picture = m_run.picture();
        m_hand.see(m_picture);
    }
    const std::optional<Vec2> ship = shipIn(m_picture);
    if (anew || (m_run.isGame() && ship && !canFlyBy(m_canvas.view(), *ship))) {
        m_framing = Framing::Classic;
    }
    frame();
    m_firstScale = m_canvas.view().scale;
    m_following = true;
    m_marks.forget();
    m_frame.reset();
    m_run.wantSession(this, m_overlays.any());
}

void LiveView::hide() {
    if (!m_shown) {
        return;
    }
    m_hand.loseMouse();
    m_menu->hide();
    m_shown = false;
    m_ground.forget();
    m_marks.forget();
    m_frame.reset();
    m_canvas.showLive(nullptr);
}

void LiveView::setOverlays(const OverlayFlags& overlays) {
    m_overlays = overlays;
    m_run.wantSession(this, overlays.any());
    if (!overlays.any()) {
        m_frame.reset();
        m_marks.forget();
    }
    refresh(); // also where time stands
    m_canvas.update();
}

bool LiveView::hasWays() const {
    const auto timeline = m_run.timeline();
    return m_shown && timeline && (m_run.isPaused() || !timeline->ghosts.empty());
}

void LiveView::setKeys(const PlayKeys& keys) {
    m_run.setKeys(keys);
    m_menu->setKeys(keys);
    m_canvas.update();
}

void LiveView::refresh() {
    if (!m_shown || !m_run.isRunning()) {
        return;
    }
    takePicture();
    const std::shared_ptr<const Snapshot> before = std::exchange(m_marked, m_marks.picture());
    if (m_marks.isPainting() && m_marked && before == m_marked) {
        return; // there is nothing new until that is there
    }
    m_hand.see(m_picture);
    const double simulated = m_run.frame()->period * static_cast<double>(m_picture.update - m_lastUpdate);
    const double passed = m_run.isPaused() ? 0 : static_cast<double>(m_sinceLook.elapsed()) / 1000;
    m_sinceLook.restart();
    m_lastUpdate = m_picture.update;
    if (const std::optional<Vec2> ship = shipIn(m_picture); ship && m_following && m_run.isGame()) {
        constexpr double longest = 0.25; // s, of what the eye can follow
        moveView(chased(m_canvas.view(), {*ship, m_bounds}, std::clamp(std::max(simulated, passed), 0.0, longest)));
    }
    m_canvas.update();
}

/// Overlays and bodies of one moment.
void LiveView::takePicture() {
    const std::shared_ptr<const Frame> frame = m_run.frame();
    m_frame = m_overlays.any() && frame->session ? frame : nullptr;
    if (!m_frame) {
        m_picture = m_run.picture();
        return;
    }
    seeOverlays(m_canvas.frame());
    m_picture = m_marks.picture() ? *m_marks.picture() : *m_frame->ofSession;
}

void LiveView::seeOverlays(const Frame2D& frame) {
    if (m_frame) {
        m_marks.see({m_frame->session, m_frame->ofSession, m_overlays, m_canvas.overlayPalette(),
                     m_document.selection().keys(), m_overlays.names ? m_hand.hovered() : 0, &theme(), frame});
    }
}

const Theme& LiveView::theme() const {
    return m_run.isGame() ? canvasTheme() : editingTheme(shadeOf(m_canvas.palette()));
}

void LiveView::shiftView(const Vec2& pixels) {
    if (m_framing == Framing::Free) {
        moveView(m_canvas.view().panned(pixels));
    }
}

void LiveView::countFrame() {
    constexpr qint64 interval = 1000; // ms
    ++m_frames;
    if (const qint64 passed = m_sinceCount.elapsed(); passed >= interval) {
        m_sinceCount.restart();
        const double perSecond = 1000.0 * std::exchange(m_frames, 0) / static_cast<double>(passed);
        QMetaObject::invokeMethod( // not while it is being painted
            this, [this, perSecond] { Q_EMIT framesCounted(perSecond); }, Qt::QueuedConnection);
    }
}

void LiveView::frame() {
    Viewport view = m_canvas.view();
    view.size = Vec2(std::max(1, m_canvas.width()), std::max(1, m_canvas.height()));
    if (m_framing == Framing::Classic) {
        moveView(classicView(m_picture, m_bounds, view.size));
    } else if (m_framing == Framing::Whole) {
        moveView(view.showing(m_bounds));
    }
}

void LiveView::moveView(const Viewport& view) {
    const Viewport& now = m_canvas.view();
    if (view.center == now.center && view.scale == now.scale) {
        return;
    }
    const QScopedValueRollback<bool> guard(m_moving, true);
    m_canvas.setView(view);
}

/// Whoever moves the view looks at something else than the ship; a window of another size does not.
void LiveView::viewMoved() {
    const Viewport& view = m_canvas.view();
    const bool moved = !(view.center == m_lastView.center && view.scale == m_lastView.scale);
    m_lastView = view;
    if (m_shown && moved && !m_moving) {
        m_framing = Framing::Free;
        setFollowing(false);
    }
}

void LiveView::setFollowing(bool following) {
    if (m_following != following) {
        m_following = following;
        Q_EMIT followingChanged();
    }
}

void LiveView::follow() {
    const std::optional<Vec2> ship = shipIn(m_picture);
    if (!ship) {
        return;
    }
    Viewport view = m_canvas.view();
    view.scale = m_firstScale;
    view.center = *ship;
    moveView(view);
    setFollowing(true);
    m_canvas.update();
}

bool LiveView::showsTool() const {
    return !m_run.isGame() && m_toolbox.current() != ToolId::Select;
}

CursorShape LiveView::cursor() const {
    return showsTool() ? m_toolbox.cursor() : isGame() ? CursorShape::Arrow : m_hand.cursor();
}

Level LiveView::posedShown(std::span<const Key> keys) const {
    return posed({m_document.level(), *m_document.current().level}, m_picture, keys);
}

/// Background and grid, painted once for as long as they stay.
void LiveView::drawPaper(QPainter& painter, const Paper& wanted) {
    if (m_paper.isNull() || !(m_paperOf == wanted)) {
        m_paperOf = wanted;
        if (m_paper.size() != wanted.frame.deviceSize()) {
            m_paper = QPixmap(wanted.frame.deviceSize());
        }
        m_paper.setDevicePixelRatio(wanted.frame.pixelRatio);
        m_paper.fill(wanted.theme->background);
        QPainter paper(&m_paper);
        if (wanted.gridStep > 0) {
            paintGrid(Stage{paper, wanted.frame.view, *wanted.theme}, wanted.gridStep);
        }
    }
    painter.drawPixmap(0, 0, m_paper);
}

void LiveView::paintHold(const Stage& stage, LabelPainter& labels) const {
    const std::optional<Grab>& grab = m_hand.grab();
    const auto body = std::ranges::find_if(
        m_picture.moving, [&](const BodyPicture& one) { return grab && one.look->key == grab->object; });
    if (body == m_picture.moving.end()) {
        return;
    }
    const std::shared_ptr<const Session> session = m_run.session();
    const bool pulls = session && session->grabForce().has_value();
    paintGrab(stage, {body->pose.toWorld(grab->anchor), grab->target, pulls ? session->grabForce()->force.norm() : 0},
              labels);
}

void LiveView::paint(QPainter& painter, const Frame2D& frame) {
    countFrame();
    const bool game = m_run.isGame();
    const Theme& theme = this->theme();
    const Stage stage{painter, frame.view, theme};
    if (game) {
        paintBackdrop(stage, m_background);
    } else {
        drawPaper(painter, {frame, &theme, m_canvas.isGridVisible() ? m_toolbox.snap.fineStep() : 0});
    }
    m_ground.draw(painter, frame, m_picture, theme);
    if (!game && m_toolbox.guidesVisible) {
        paintGuides(stage, m_document.level(), {});
    }
    if (const auto timeline = m_run.timeline(); timeline && m_overlays.ways) {
        paintWays(stage, *timeline, overlayColors(m_canvas.overlayPalette(), theme.shade),
                  m_document.selection().keys());
    }
    paintFlame(stage, m_picture);
    paintMoving(stage, m_picture, &m_discs);
    seeOverlays(frame);
    m_leftOut = m_marks.draw(stage, frame);
    if (game) {
        paintTowRange(stage, m_picture, m_towRange);
    }
}

void LiveView::paintWords(const Stage& stage) const {
    constexpr double reach = 0.35; // m, of the ship's hull and a little more
    HudInput words{m_picture.phase, m_picture.hud, m_run.isPaused(), m_run.keys(), m_goal};
    if (m_picture.loss) {
        words.shipLost = m_picture.loss->ship;
        words.payloadLost = m_picture.loss->payload;
        words.cause = crashWords(*m_picture.loss, m_document.level());
    }
    if (const std::optional<Vec2> ship = shipIn(m_picture)) {
        const double half = stage.pixels(reach);
        words.ship = QRectF(stage.at(*ship) - QPointF(half, half), QSizeF(2 * half, 2 * half));
    }
    paintHud(stage.painter, hudLayout(words, m_canvas.size(), m_canvas.font()));
}

void LiveView::paintOver(QPainter& painter, const Frame2D& frame) {
    const Stage stage{painter, frame.view, theme()};
    if (const Key hovered = m_hand.hovered(); hovered != 0 && !showsTool() && !m_run.isGame()) {
        paintHovered(stage, posedShown(std::span(&hovered, 1)), hovered);
    }
    const Selection& selection = m_document.selection();
    if (!selection.empty()) {
        paintSelection(stage, posedShown(selection.keys()), selection);
    }
    LabelPainter labels(stage);
    paintToolOverlay(stage, m_hand.overlay(), labels);
    paintHold(stage, labels);
    if (m_menu->isVisible()) {
        painter.fillRect(m_canvas.rect(), QColor(4, 8, 18, 130));
    } else if (m_run.isGame()) {
        paintWords(stage);
    }
}

} // namespace spacetow
