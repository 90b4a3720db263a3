#include "editor/canvas/layer_cache.h"

#include "editor/canvas/grid_painter.h"
#include "editor/canvas/overlay_painter.h"
#include "editor/canvas/scene_painter.h"

#include <algorithm>
#include <cmath>

namespace spacetow {

namespace {

/// Whether the level with this object in it looks different far away from the object.
bool makesRock(const Object& object) {
    const auto* body = std::get_if<BodyObject>(&object.data);
    return body != nullptr && std::ranges::any_of(body->shapes, [](const LevelShape& shape) {
               const auto* chain = std::get_if<EdgeChain>(&shape);
               return chain != nullptr && chain->closed && std::isinf(chain->depth);
           });
}

} // namespace

const QPixmap& LayerCache::layer(const Request& request) {
    const QSize size(static_cast<int>(std::ceil(request.view.size.x() * request.pixelRatio)),
                     static_cast<int>(std::ceil(request.view.size.y() * request.pixelRatio)));
    if (m_pixmap.size() != size || m_pixmap.devicePixelRatio() != request.pixelRatio) {
        m_pixmap = QPixmap(size);
        m_pixmap.setDevicePixelRatio(request.pixelRatio);
        m_valid = false;
    }
    if (!m_valid || !isCurrent(request) || !shiftTo(request)) {
        m_painted = request;
        m_valid = true;
        paint(QRect(QPoint(0, 0), size));
    }
    return m_pixmap;
}

void LayerCache::setMoving(const Level& before, const Level& after) {
    std::unordered_set<Key> differing;
    bool rock = false;
    const int count = std::max(before.objects.size(), after.objects.size());
    for (int i = 0; i < count; ++i) {
        if (after.objects.sharesPiece(i, before.objects)) {
            continue;
        }
        for (const Level* level : {&before, &after}) {
            if (i < level->objects.size()) {
                differing.insert(level->objects[i].key);
                rock = rock || makesRock(level->objects[i]);
            }
        }
    }
    for (const Object& object : after.objects) {
        if (const auto* connector = std::get_if<ConnectorObject>(&object.data)) {
            if (differing.contains(connector->a) || differing.contains(connector->b)) {
                differing.insert(object.key);
            }
        }
    }
    if (rock || differing.empty()) {
        clearMoving();
    } else if (!std::ranges::all_of(differing, [this](Key key) { return m_moving.contains(key); })) {
        m_moving.merge(differing);
        m_valid = false;
    }
}

void LayerCache::clearMoving() {
    m_valid = m_valid && m_moving.empty();
    m_moving.clear();
}

bool LayerCache::isCurrent(const Request& request) const {
    // What is moving is not in the picture, so that another level does no harm as long as the rest is shared.
    const bool sameLevel = request.level == m_painted.level || hasMoving();
    return sameLevel && request.gridStep == m_painted.gridStep && request.overlays == m_painted.overlays &&
           request.selection == m_painted.selection && request.view.scale == m_painted.view.scale &&
           request.shade == m_painted.shade;
}

bool LayerCache::shiftTo(const Request& request) {
    const Vec2 moved = (m_painted.view.toScreen(Vec2(0, 0)) - request.view.toScreen(Vec2(0, 0))) * request.pixelRatio;
    const Vec2 whole(std::round(moved.x()), std::round(moved.y()));
    if ((moved - whole).cwiseAbs().maxCoeff() > 0.02 || std::abs(whole.x()) >= m_pixmap.width() ||
        std::abs(whole.y()) >= m_pixmap.height()) {
        return false;
    }
    m_painted.level = request.level;
    m_painted.view = request.view;
    if (whole.x() != 0 || whole.y() != 0) {
        QRegion exposed;
        m_pixmap.scroll(static_cast<int>(-whole.x()), static_cast<int>(-whole.y()), m_pixmap.rect(), &exposed);
        paint(exposed);
    }
    return true;
}

void LayerCache::paint(const QRegion& where) {
    const double ratio = m_painted.pixelRatio;
    for (const QRect& device : where) {
        // Whole device pixels, and a view of the strip alone, so that what lies outside costs nothing.
        const QRectF strip(device.x() / ratio, device.y() / ratio, device.width() / ratio, device.height() / ratio);
        Viewport view = m_painted.view;
        const QPointF middle = strip.center();
        view.center = m_painted.view.toWorld(Vec2(middle.x(), middle.y()));
        view.size = Vec2(strip.width(), strip.height());
        QPainter painter(&m_pixmap);
        painter.setClipRect(strip);
        painter.translate(strip.topLeft());
        const Stage stage{painter, view, editingTheme(m_painted.shade)};
        painter.fillRect(QRectF(QPointF(0, 0), strip.size()), stage.theme.background);
        if (m_painted.gridStep > 0) {
            paintGrid(stage, m_painted.gridStep);
        }
        paintObjects(stage, *m_painted.level, [this](const Object& object) { return !isMoving(object.key); });
        if (m_painted.overlays.any()) {
            paintLevelOverlays(stage, *m_painted.level, m_painted.overlays);
        }
        paintSelection(stage, *m_painted.level, m_painted.selection);
    }
}

} // namespace spacetow
