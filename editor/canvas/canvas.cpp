#include "editor/canvas/canvas.h"

#include "core/level/bounds.h"
#include "editor/canvas/grid_painter.h"
#include "editor/canvas/guide_painter.h"
#include "editor/canvas/node_painter.h"
#include "editor/canvas/overlay_painter.h"
#include "editor/canvas/palette.h"
#include "editor/canvas/problem_painter.h"
#include "editor/canvas/scene_painter.h"
#include "editor/canvas/snap_painter.h"
#include "editor/canvas/tag_painter.h"

#include <QGuiApplication>
#include <QMouseEvent>
#include <QPainter>

#include <cmath>
#include <utility>

namespace spacetow {

namespace {

Vec2 toVec(const QPointF& point) {
    return {point.x(), point.y()};
}

Aabb boundsOfSelected(const Edit& edit) {
    return boundsOf(*edit.level, edit.selection.keys());
}

} // namespace

Canvas::Canvas(Document& document, Toolbox& toolbox, QWidget* parent)
    : QWidget(parent), m_document(document), m_toolbox(toolbox), m_board([this] { update(); }), m_entry(toolbox, *this),
      m_edgeScroll(*this, [this](const QPointF& push) { scrollAtEdge(push); }) {
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setAttribute(Qt::WA_OpaquePaintEvent);
    setMinimumSize(240, 180);
    setAccessibleName(tr("Drawing board"));
    m_documentListener = m_document.changed.connect([this](const Change&) { update(); });
    m_toolboxListener = m_toolbox.changed.connect([this] {
        updateCursor();
        tellPlace();
        m_entry.follow(m_position.value_or(QPointF(rect().center())).toPoint());
        if (!(m_toolbox.overlay() == m_overlay)) {
            update();
        }
    });
}

Canvas::~Canvas() {
    m_document.changed.disconnect(m_documentListener);
    m_toolbox.changed.disconnect(m_toolboxListener);
}

void Canvas::setView(const Viewport& view) {
    m_view = view;
    m_view.size = Vec2(std::max(1, width()), std::max(1, height()));
    m_fitted = false;
    update();
    Q_EMIT viewChanged();
}

void Canvas::showLive(LiveScene* scene) {
    if (scene == m_live) {
        return;
    }
    loseMouse();
    if (m_live == nullptr) {
        m_kept = {m_view, m_fitted};
        m_fitted = false;
    }
    m_live = scene;
    setAccessibleName(isLive() ? tr("Drawing board, running") : tr("Drawing board"));
    if (m_live == nullptr) {
        setView(m_kept.view);
        if (m_kept.fitted) {
            fitLevel();
        }
    }
    updateCursor();
    update();
}

void Canvas::setGridVisible(bool visible) {
    m_grid = visible;
    update();
}

void Canvas::setGuidesVisible(bool visible) {
    m_toolbox.guidesVisible = visible;
    update();
}

void Canvas::setOverlays(const OverlayFlags& overlays) {
    m_overlays = overlays;
    update();
}

void Canvas::setOverlayPalette(const OverlayPalette& palette) {
    m_overlayPalette = palette;
    update();
}

void Canvas::setHighlighted(std::vector<Key> keys) {
    if (keys != *m_highlighted) {
        m_highlighted = std::make_shared<const std::vector<Key>>(std::move(keys));
        update();
    }
}

void Canvas::setDifference(std::shared_ptr<const ShownDifference> difference) {
    m_difference = std::move(difference);
    update();
}

void Canvas::setForces(std::vector<ForceArrow> arrows) {
    if (!arrows.empty() || !m_forces.empty()) {
        m_forces = std::move(arrows);
        update();
    }
}

void Canvas::setProblems(std::shared_ptr<const std::vector<ProblemMark>> marks, int current) {
    m_problems = std::move(marks);
    m_problem = current;
    update();
}

void Canvas::setReach(std::shared_ptr<const ShownReach> reach) {
    m_reach = std::move(reach);
    update();
}

void Canvas::showPlace(std::span<const Vec2> place) {
    constexpr double room = 1;         // m round the place
    constexpr double leastPixels = 12; // of a place that has an extent
    Aabb box;
    for (const Vec2& point : place) {
        box.include(point);
    }
    if (box.isEmpty()) {
        return;
    }
    const double extent = box.size().maxCoeff();
    if (!m_view.visible().contains(box.grown(0.1 * room)) || (extent > 0 && extent < leastPixels * m_view.pixel())) {
        setView(m_view.showing(box.grown(room)));
    }
}

void Canvas::zoom(double factor) {
    zoomAt(0.5 * m_view.size, factor);
}

void Canvas::zoomAt(const Vec2& screen, double factor) {
    constexpr double leastPixels = 24; // that the level is long
    constexpr double leastLevel = 10;  // m; a small one has room for a larger
    // What runs may have left the level far behind.
    const double length = std::max(leastLevel, boundsOf(m_document.level()).size().maxCoeff());
    const double least = isLive() ? Viewport::minScale : leastPixels / length;
    setView(m_view.zoomedAt(screen, factor < 1 ? std::max(factor, std::min(1.0, least / m_view.scale)) : factor));
}

void Canvas::zoomTo(double scale) {
    zoom(scale / m_view.scale);
}

void Canvas::fitLevel() {
    Viewport view = m_view;
    view.size = Vec2(std::max(1, width()), std::max(1, height()));
    setView(view.showing(boundsOf(m_document.level())));
    m_fitted = true;
}

void Canvas::centerSelection() {
    const Aabb box = boundsOfSelected(m_document.shown());
    Viewport view = m_view;
    const Aabb all = boundsOf(m_document.level());
    if (!box.isEmpty() || !all.isEmpty()) {
        view.center = (box.isEmpty() ? all : box).center();
    }
    setView(view);
}

void Canvas::frameSelection() {
    const Aabb box = boundsOfSelected(m_document.shown());
    setView(m_view.showing(box.isEmpty() ? boundsOf(m_document.level()) : box));
}

void Canvas::showAnew() {
    m_board.forget();
    fitLevel();
}

void Canvas::finishPainting() {
    repaint();
    m_board.finish();
    repaint();
}

Frame2D Canvas::frame() const {
    const double ratio = devicePixelRatioF();
    return {alignedToPixels(m_view, ratio), ratio};
}

void Canvas::paintEvent(QPaintEvent*) {
    const Edit& shown = m_document.shown();
    m_overlay = m_toolbox.overlay();
    const bool isLong = isLongToHover(*shown.level, m_overlay.hovered, m_view.visible());
    BoardRequest request;
    request.frame = frame();
    request.theme = &editingTheme(shadeOf(palette()));
    request.level = shown.level;
    request.base = m_document.current().level;
    request.live = m_document.hasPreview();
    request.selection = shown.selection;
    request.hovered = isLong ? m_overlay.hovered : 0;
    request.pointed = m_overlays.names ? m_overlay.hovered : 0;
    request.highlighted = m_highlighted;
    request.overlays = m_overlays;
    request.overlays.collides = false; // what is highlighted says so
    request.palette = m_overlayPalette;
    if (isLive()) {
        QPainter painter(this);
        paintLive(painter, request.frame);
        tellLeftOut(m_live->leftOut());
        return;
    }
    m_board.prepare(request);
    tellLeftOut(m_board.leftOut());
    composeStill({request.frame, request.theme, m_grid ? m_toolbox.snap.fineStep() : 0, m_board.stillRevision()});

    QPainter painter(this);
    painter.drawPixmap(0, 0, m_still);
    const Stage stage{painter, request.frame.view, *request.theme};
    if (m_toolbox.guidesVisible) {
        paintGuides(stage, *shown.level, m_toolbox.guideInReach());
    }
    m_board.drawRest(painter);
    if (m_difference) {
        paintDifference(stage, *shown.level, *m_difference);
    }
    if (m_reach) {
        paintReach(stage, *m_reach);
    }
    if (m_overlays.tags) {
        paintTags(stage, *shown.level);
    }
    if (m_overlays.problems && m_problems != nullptr) {
        drawProblems(painter, request.frame, *request.theme);
    }
    if (m_overlay.hovered != 0 && !isLong) {
        paintHovered(stage, *shown.level, m_overlay.hovered);
    }
    if (m_overlay.nodes) {
        paintNodes(stage, *shown.level, shown.selection, *m_overlay.nodes);
    }
    if (shown.level->objects.empty() && !m_toolbox.isBusy() && !m_beginning.isEmpty()) {
        paintInMiddle(stage, m_beginning);
    }
    LabelPainter labels(stage);
    paintForces(stage, m_forces, labels);
    paintToolOverlay(stage, m_overlay, labels);
    if (m_overlay.snap) {
        paintSnap(stage, *m_overlay.snap, m_snapName ? m_snapName(*m_overlay.snap) : QString(), labels);
    }
    paintFocus(painter);
}

/// Not while it is being painted.
void Canvas::tellLeftOut(const LeftOut& leftOut) {
    if (std::exchange(m_leftOut, leftOut) != leftOut) {
        QMetaObject::invokeMethod(this, &Canvas::leftOutChanged, Qt::QueuedConnection);
    }
}

void Canvas::paintFocus(QPainter& painter) const {
    if (hasFocus()) {
        painter.setPen(stroke(palette().color(QPalette::Highlight), 1));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5));
    }
}

/// What moves has left the place where the level has it: of the tool's marks only those are shown that go by the
/// ground.
void Canvas::paintLive(QPainter& painter, const Frame2D& frame) {
    m_live->paint(painter, frame);
    const Stage stage{painter, frame.view, editingTheme(shadeOf(palette()))};
    const Edit& shown = m_document.shown();
    if (m_reach) {
        paintReach(stage, *m_reach);
    }
    LabelPainter labels(stage);
    paintForces(stage, m_forces, labels);
    if (m_live->showsTool()) {
        if (m_overlay.nodes) {
            paintNodes(stage, *shown.level, shown.selection, *m_overlay.nodes);
        }
        paintToolOverlay(stage, m_overlay, labels);
        if (m_overlay.snap) {
            paintSnap(stage, *m_overlay.snap, m_snapName ? m_snapName(*m_overlay.snap) : QString(), labels);
        }
    } else if (m_toolbox.isDragging()) {
        paintToolOverlay(stage, m_overlay, labels);
    }
    m_live->paintOver(painter, frame);
    if (!m_live->isGame()) {
        paintFocus(painter);
    }
}

/// Background, grid and all of the level that stands still, in one picture for as long as it does.
void Canvas::composeStill(const Still& wanted) {
    if (wanted == m_composed && !m_still.isNull()) {
        return;
    }
    const QSize size = wanted.frame.deviceSize();
    const double ratio = wanted.frame.pixelRatio;
    m_composed.revision = wanted.revision;
    std::optional<QRegion> changes = m_board.takeStillChanges();
    if (m_still.size() != size || m_still.devicePixelRatio() != ratio) {
        m_still = QPixmap(size);
        m_still.setDevicePixelRatio(ratio);
        changes.reset();
    }
    QPainter painter(&m_still);
    if (changes && m_composed == wanted) {
        painter.scale(1 / ratio, 1 / ratio);
        painter.setClipRegion(*changes);
        painter.resetTransform();
    }
    m_composed = wanted;
    painter.fillRect(QRectF(0, 0, wanted.frame.view.size.x() + 1, wanted.frame.view.size.y() + 1),
                     wanted.theme->background);
    if (wanted.gridStep > 0) {
        paintGrid(Stage{painter, wanted.frame.view, *wanted.theme}, wanted.gridStep);
    }
    m_board.drawStill(painter);
}

/// A large level may have thousands of marks, which hardly ever change: one picture for as long as they do not.
void Canvas::drawProblems(QPainter& painter, const Frame2D& frame, const Theme& theme) {
    if (m_problems->empty()) {
        return;
    }
    const ShownMarks wanted{frame, &theme, m_problems, m_problem};
    if (!(wanted == m_shownMarks) || m_marks.isNull()) {
        m_shownMarks = wanted;
        if (m_marks.size() != frame.deviceSize()) {
            m_marks = QPixmap(frame.deviceSize());
        }
        m_marks.setDevicePixelRatio(frame.pixelRatio);
        m_marks.fill(Qt::transparent);
        QPainter marks(&m_marks);
        paintProblems({marks, frame.view, theme}, *m_problems, m_problem, markColors(theme.shade));
    }
    painter.drawPixmap(0, 0, m_marks);
}

void Canvas::resizeEvent(QResizeEvent* event) {
    const int top = mapTo(window(), QPoint(0, 0)).y();
    const int down = top - std::exchange(m_top, top);
    const QSize& before = event->oldSize();
    if (!isLive() && down != 0 && before.isValid() && event->size() == before - QSize(0, down)) {
        // A bar has come or gone above: what is drawn stays where it is on the screen.
        Viewport view = m_view;
        view.center.y() -= 0.5 * down * view.pixel();
        const bool fitted = m_fitted;
        setView(view);
        m_fitted = fitted;
    } else if (m_fitted) {
        fitLevel();
    } else {
        setView(m_view);
    }
}

void Canvas::panBy(const QPointF& pixels) {
    setView(m_view.panned(toVec(pixels)));
}

} // namespace spacetow
