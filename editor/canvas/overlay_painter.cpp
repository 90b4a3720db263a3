#include "editor/canvas/overlay_painter.h"

#include "core/game/ship.h"
#include "core/geometry/bounds.h"
#include "core/geometry/mass.h"
#include "core/level/build.h"
#include "core/level/edits.h"
#include "editor/canvas/painter_draw.h"

#include <algorithm>

namespace spacetow {

namespace {

/// The overlays in the stage's view and colours.
DebugView debugView(const Stage& stage, const OverlayFlags& overlays) {
    DebugView view;
    view.view = stage.view.transform();
    view.shapes = false;
    view.boxes = overlays.aabb;
    view.velocities = overlays.velocity;
    view.orientations = overlays.orientation;
    view.incircles = overlays.incircle;
    view.normals = overlays.normals;
    view.colors = {toColor(stage.theme.overlayBox), toColor(stage.theme.overlayIncircle),
                   toColor(stage.theme.overlayNormal), toColor(stage.theme.overlayOrientation),
                   toColor(stage.theme.overlayVelocity)};
    return view;
}

Vec2 massCenter(std::span<const Shape> shapes, const Transform& pose) {
    std::vector<MassProperties> masses;
    for (const Shape& shape : shapes) {
        masses.push_back(massOf(shape, 1));
    }
    return pose.toWorld(sum(masses).center);
}

/// The centre of mass is found where the velocity shows, and only there.
void paintBody(DebugBody body, const DebugView& view, DebugDraw& draw) {
    if (view.velocities && body.velocity.squaredNorm() > 0) {
        body.massCenter = massCenter(body.shapes, body.pose);
    }
    drawBody(body, view, draw);
}

void paintCells(const Stage& stage, const std::vector<Aabb>& cells) {
    PainterDraw draw(stage);
    for (const Aabb& cell : cells) {
        if (!cell.isEmpty()) {
            draw.rectangle(stage.view.transform().toView(cell), toColor(stage.theme.overlayCell));
        }
    }
}

/// The more a cell holds, the darker it is; a number where there is room for one.
void paintOccupied(const Stage& stage, const QuadtreeCell& cell) {
    constexpr int lightest = 10;
    constexpr int each = 12;
    constexpr int darkest = 110;
    constexpr double roomy = 40; // px; a number is no wider
    constexpr double beyond = 8; // px out of view, where nobody sees that it ends
    const QRectF whole(stage.at(Vec2(cell.box.min.x(), cell.box.max.y())),
                       stage.at(Vec2(cell.box.max.x(), cell.box.min.y())));
    const QRectF view(0, 0, stage.view.size.x(), stage.view.size.y());
    const QRectF box = whole & view.adjusted(-beyond, -beyond, beyond, beyond);
    const bool isRoomy = std::min(whole.width(), whole.height()) >= roomy;
    QColor fill = stage.theme.overlayCell;
    fill.setAlpha(std::min(lightest + each * cell.held, darkest));
    if (cell.held > 0) {
        stage.painter.fillRect(box, fill);
    }
    stage.painter.setPen(stroke(stage.theme.overlayCell, 1));
    stage.painter.drawRect(box);
    if (cell.held > 0 && isRoomy && view.adjusted(-roomy, -roomy, roomy, roomy).contains(whole.topLeft())) {
        stage.painter.drawText(whole.adjusted(4, 2, 0, 0), Qt::AlignLeft | Qt::AlignTop, QString::number(cell.held));
    }
}

void paintObjectOverlays(const Level& level, const Object& object, const DebugView& view, DebugDraw& draw) {
    DebugBody seen{.bounds = boundsOf(level, object)};
    std::vector<Shape> shapes;
    if (const auto* body = std::get_if<BodyObject>(&object.data)) {
        shapes = physicsShapes(*body);
        seen.kind = body->kind;
        seen.pose = {body->position, Rot::fromAngle(body->angle)};
        seen.velocity = body->velocity;
    } else if (const auto* ship = std::get_if<ShipObject>(&object.data)) {
        shapes = {shipHull()};
        seen.pose = {ship->position, Rot::fromAngle(ship->angle)};
    } else if (const auto* payload = std::get_if<PayloadObject>(&object.data)) {
        shapes = {Circle{Vec2(0, 0), payload->radius}};
        seen.pose.position = payload->position;
    } else if (const auto* finish = std::get_if<FinishObject>(&object.data)) {
        shapes = {Line{finish->a, finish->b}};
        seen.kind = BodyKind::Static;
    } else {
        return;
    }
    seen.shapes = shapes;
    paintBody(seen, view, draw);
}

void begin(const Stage& stage) {
    stage.painter.save();
    stage.painter.setRenderHint(QPainter::Antialiasing);
    stage.painter.setBrush(Qt::NoBrush);
}

} // namespace

void paintLevelOverlays(const Stage& stage, const Level& level, const OverlayFlags& overlays,
                        std::span<const QuadtreeCell> cells) {
    begin(stage);
    for (const QuadtreeCell& cell : cells) {
        if (overlays.quadtree && !cell.box.isEmpty() && stage.sees(cell.box)) {
            paintOccupied(stage, cell);
        }
    }
    if (OverlayFlags others = overlays; others.quadtree = false, others.any()) {
        const DebugView view = debugView(stage, overlays);
        PainterDraw draw(stage);
        for (const Object& object : level.objects) {
            paintObjectOverlays(level, object, view, draw);
        }
    }
    stage.painter.restore();
}

void paintSnapshotOverlays(const Stage& stage, const Snapshot& snapshot, const OverlayFlags& overlays) {
    begin(stage);
    if (overlays.quadtree) {
        paintCells(stage, snapshot.quadtree);
    }
    const DebugView view = debugView(stage, overlays);
    PainterDraw draw(stage);
    for (const BodyPicture& body : snapshot.bodies) {
        paintBody({.kind = body.look->kind,
                   .shapes = body.look->shapes,
                   .pose = body.pose,
                   .velocity = body.velocity,
                   .bounds = body.bounds},
                  view, draw);
    }
    stage.painter.restore();
}

} // namespace spacetow
