#include "editor/canvas/canvas.h"

#include "core/level/edits.h"
#include "editor/canvas/guide_painter.h"
#include "editor/canvas/highlight_painter.h"
#include "editor/canvas/node_painter.h"
#include "editor/canvas/overlay_painter.h"
#include "editor/canvas/scene_painter.h"
#include "editor/canvas/snap_painter.h"
#include "editor/canvas/tag_painter.h"

#include <QGuiApplication>
#include <QMouseEvent>
#include <QPainter>

#include <cmath>

namespace spacetow {

namespace {

Vec2 toVec(const QPointF& point) {
    return {point.x(), point.y()};
}

Qt::CursorShape shapeFor(CursorShape shape) {
    switch (shape) {
    case CursorShape::Arrow:
        return Qt::ArrowCursor;
    case CursorShape::Cross:
        return Qt::CrossCursor;
    case CursorShape::Move:
        return Qt::SizeAllCursor;
    case CursorShape::OpenHand:
        return Qt::OpenHandCursor;
    case CursorShape::Insert:
        return Qt::DragCopyCursor;
    case CursorShape::SizeAcross:
        return Qt::SizeHorCursor;
    case CursorShape::SizeUpright:
        return Qt::SizeVerCursor;
    case CursorShape::SizeRising:
        return Qt::SizeBDiagCursor;
    case CursorShape::SizeFalling:
        return Qt::SizeFDiagCursor;
    case CursorShape::Pointing:
        break;
    }
    return Qt::PointingHandCursor;
}

Aabb boundsOfSelected(const Edit& edit) {
    Aabb box;
    for (const Object& object : edit.level->objects) {
        if (edit.selection.contains(object.key)) {
            box.include(boundsOf(*edit.level, object));
        }
    }
    return box;
}

} // namespace

Canvas::Canvas(Document& document, Toolbox& toolbox, QWidget* parent)
    : QWidget(parent), m_document(document), m_toolbox(toolbox), m_entry(toolbox, *this) {
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setAttribute(Qt::WA_OpaquePaintEvent);
    setMinimumSize(240, 180);
    setAccessibleName(tr("Drawing board"));
    m_documentListener = m_document.changed.connect([this](const Change& change) { documentChanged(change); });
    m_toolboxListener = m_toolbox.changed.connect([this] {
        updateCursor();
        m_entry.follow(m_position.value_or(QPointF(rect().center())).toPoint());
        update();
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

void Canvas::setHighlighted(std::vector<Key> keys) {
    if (keys != m_highlighted) {
        m_highlighted = std::move(keys);
        update();
    }
}

void Canvas::zoom(double factor) {
    setView(m_view.zoomedAt(0.5 * m_view.size, factor));
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

Vec2 Canvas::pointerPosition() const {
    return m_position ? m_view.toWorld(toVec(*m_position)) : m_view.center;
}

Pointer Canvas::pointerAt(const QPointF& position, Qt::KeyboardModifiers modifiers) const {
    return {m_view.toWorld(toVec(position)), toVec(position),
            Modifiers{modifiers.testFlag(Qt::ShiftModifier), modifiers.testFlag(Qt::ControlModifier),
                      modifiers.testFlag(Qt::AltModifier) || m_belowHeld},
            m_view.pixel(), m_view.visible()};
}

void Canvas::documentChanged(const Change& change) {
    if (change.before.level != change.after.level) {
        if (m_document.hasPreview()) {
            m_layer.setMoving(*m_document.current().level, *change.after.level);
        } else {
            m_layer.clearMoving();
        }
    }
    update();
}

void Canvas::paintEvent(QPaintEvent*) {
    if (!m_document.hasPreview()) {
        m_layer.clearMoving();
    }
    const bool live = m_document.hasPreview();
    const Edit& shown = m_document.shown();
    LayerCache::Request request;
    request.view = m_view;
    request.level = shown.level;
    request.selection = live ? Selection() : shown.selection;
    request.overlays = live ? OverlayFlags() : m_overlays;
    request.gridStep = m_grid ? m_toolbox.snap.fineStep() : 0;
    request.pixelRatio = devicePixelRatioF();
    request.shade = shadeOf(palette());

    QPainter painter(this);
    painter.drawPixmap(0, 0, m_layer.layer(request));
    const Stage stage{painter, m_view, editingTheme(request.shade)};
    if (m_layer.hasMoving()) {
        paintObjects(stage, *shown.level, [this](const Object& object) { return m_layer.isMoving(object.key); });
    }
    if (m_toolbox.guidesVisible) {
        paintGuides(stage, *shown.level, m_toolbox.guideInReach());
    }
    if (live) {
        if (m_overlays.any()) {
            paintLevelOverlays(stage, *shown.level, m_overlays);
        }
        paintSelection(stage, *shown.level, shown.selection);
    }
    paintHighlight(stage, *shown.level, m_highlighted);
    if (m_overlays.tags) {
        paintTags(stage, *shown.level);
    }
    const Overlay overlay = m_toolbox.overlay();
    if (overlay.hovered != 0) {
        paintHovered(stage, *shown.level, overlay.hovered);
    }
    if (overlay.nodes) {
        paintNodes(stage, *shown.level, shown.selection, *overlay.nodes);
    }
    paintToolOverlay(stage, overlay);
    if (overlay.snap) {
        paintSnap(stage, *overlay.snap, m_snapName ? m_snapName(*overlay.snap) : QString());
    }
    if (hasFocus()) {
        painter.setPen(stroke(palette().color(QPalette::Highlight), 1));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5));
    }
}

void Canvas::resizeEvent(QResizeEvent*) {
    if (m_fitted) {
        fitLevel();
    } else {
        setView(m_view);
    }
}

void Canvas::panBy(const QPointF& pixels) {
    setView(m_view.panned(toVec(pixels)));
}

void Canvas::updateCursor() {
    if (m_drag == Drag::Pan) {
        setCursor(Qt::ClosedHandCursor);
    } else if (m_spaceHeld) {
        setCursor(Qt::OpenHandCursor);
    } else {
        setCursor(shapeFor(m_toolbox.cursor()));
    }
}

} // namespace spacetow
