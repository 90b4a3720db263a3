#include "editor/canvas/overlay_painter.h"

#include "core/game/ship.h"
#include "core/geometry/bounds.h"
#include "core/geometry/polygon.h"
#include "core/geometry/static_quadtree.h"
#include "core/level/build.h"
#include "core/level/edits.h"
#include "editor/canvas/wall_painter.h"

#include <array>

namespace spacetow {

namespace {

constexpr double arrowHead = 6; // px

/// What the overlays need to know of a body; the references outlive it.
struct Subject {
    const std::vector<Shape>& shapes;
    Transform pose;
    Vec2 velocity;
    Aabb bounds;
};

void arrow(const Stage& stage, const Vec2& from, const Vec2& to) {
    const QPointF a = stage.at(from);
    const QPointF b = stage.at(to);
    const QLineF line(a, b);
    stage.painter.drawLine(line);
    if (line.length() > 2 * arrowHead) {
        const QPointF along = (b - a) / line.length() * arrowHead;
        const QPointF across(-along.y() * 0.5, along.x() * 0.5);
        stage.painter.drawLine(b, b - along + across);
        stage.painter.drawLine(b, b - along - across);
    }
}

void paintBox(const Stage& stage, const Aabb& box) {
    if (!box.isEmpty() && stage.sees(box)) {
        stage.painter.drawRect(
            QRectF(stage.at(Vec2(box.min.x(), box.max.y())), stage.at(Vec2(box.max.x(), box.min.y()))));
    }
}

/// From the middle of a wall a metre to the free side; a line has two of them.
void paintNormal(const Stage& stage, const Vec2& a, const Vec2& b, bool both) {
    const Vec2 along = b - a;
    const double length = along.norm();
    const Vec2 middle = 0.5 * (a + b);
    if (length <= 0 || !stage.sees(Aabb{middle, middle}.grown(1))) {
        return;
    }
    const Vec2 free = leftOf(along / length);
    arrow(stage, middle, middle + free);
    if (both) {
        arrow(stage, middle, middle - free);
    }
}

void paintNormals(const Stage& stage, const Subject& subject) {
    for (const Shape& shape : subject.shapes) {
        if (const auto* edge = std::get_if<Edge>(&shape)) {
            paintNormal(stage, subject.pose.toWorld(edge->a), subject.pose.toWorld(edge->b), false);
        } else if (const auto* line = std::get_if<Line>(&shape)) {
            paintNormal(stage, subject.pose.toWorld(line->a), subject.pose.toWorld(line->b), true);
        }
    }
}

void paintIncircles(const Stage& stage, const Subject& subject) {
    for (const Shape& shape : subject.shapes) {
        if (const auto* polygon = std::get_if<Polygon>(&shape); polygon != nullptr && polygon->vertices.size() > 2) {
            const Vec2 center = centroid(polygon->vertices);
            const double radius = stage.pixels(incircleRadius(polygon->vertices, center));
            stage.painter.drawEllipse(stage.at(subject.pose.toWorld(center)), radius, radius);
        }
    }
}

void paintSubject(const Stage& stage, const Subject& subject, const OverlayFlags& overlays) {
    const Vec2& at = subject.pose.position;
    if (overlays.aabb) {
        stage.painter.setPen(stroke(stage.theme.overlayBox, 1));
        paintBox(stage, subject.bounds);
    }
    if (overlays.normals) {
        stage.painter.setPen(stroke(stage.theme.overlayNormal, 1.3));
        paintNormals(stage, subject);
    }
    if (overlays.incircle) {
        stage.painter.setPen(stroke(stage.theme.overlayIncircle, 1.3));
        paintIncircles(stage, subject);
    }
    if (overlays.orientation) {
        stage.painter.setPen(stroke(stage.theme.overlayOrientation, 1.5));
        stage.painter.drawLine(stage.at(at), stage.at(at + subject.pose.rotation.up()));
    }
    if (overlays.velocity && subject.velocity.squaredNorm() > 0) {
        stage.painter.setPen(stroke(stage.theme.overlayVelocity, 1.8));
        arrow(stage, at, at + subject.velocity);
    }
}

void paintCells(const Stage& stage, const std::vector<Aabb>& cells) {
    stage.painter.setPen(stroke(stage.theme.overlayCell, 1));
    for (const Aabb& cell : cells) {
        paintBox(stage, cell);
    }
}

/// The boxes that the broad phase keeps for static shapes.
std::vector<Aabb> staticBoxes(const Level& level) {
    std::vector<Aabb> boxes;
    for (const Object& object : level.objects) {
        const auto* body = std::get_if<BodyObject>(&object.data);
        if (body == nullptr || body->kind != BodyKind::Static) {
            continue;
        }
        const Transform pose{body->position, Rot::fromAngle(body->angle)};
        for (const Shape& shape : physicsShapes(*body)) {
            boxes.push_back(boundsOf(shape, pose));
        }
    }
    return boxes;
}

void paintObjectOverlays(const Stage& stage, const Level& level, const Object& object, const OverlayFlags& overlays) {
    const Aabb bounds = boundsOf(level, object);
    if (const auto* body = std::get_if<BodyObject>(&object.data)) {
        const std::vector<Shape> shapes = physicsShapes(*body);
        paintSubject(stage, {shapes, {body->position, Rot::fromAngle(body->angle)}, body->velocity, bounds}, overlays);
    } else if (const auto* ship = std::get_if<ShipObject>(&object.data)) {
        const std::vector<Shape> shapes{shipHull()};
        paintSubject(stage, {shapes, {ship->position, Rot::fromAngle(ship->angle)}, Vec2(0, 0), bounds}, overlays);
    } else if (const auto* payload = std::get_if<PayloadObject>(&object.data)) {
        const std::vector<Shape> shapes{Circle{Vec2(0, 0), payload->radius}};
        paintSubject(stage, {shapes, {payload->position, Rot{}}, Vec2(0, 0), bounds}, overlays);
    } else if (const auto* finish = std::get_if<FinishObject>(&object.data)) {
        const std::vector<Shape> shapes{Line{finish->a, finish->b}};
        OverlayFlags only = overlays;
        only.orientation = false;
        paintSubject(stage, {shapes, {}, Vec2(0, 0), bounds}, only);
    }
}

void begin(const Stage& stage) {
    stage.painter.save();
    stage.painter.setRenderHint(QPainter::Antialiasing);
    stage.painter.setBrush(Qt::NoBrush);
}

} // namespace

void paintLevelOverlays(const Stage& stage, const Level& level, const OverlayFlags& overlays) {
    begin(stage);
    if (overlays.quadtree) {
        paintCells(stage, StaticQuadtree(staticBoxes(level)).cells());
    }
    if (OverlayFlags others = overlays; others.quadtree = false, others.any()) {
        for (const Object& object : level.objects) {
            paintObjectOverlays(stage, level, object, overlays);
        }
    }
    stage.painter.restore();
}

void paintSnapshotOverlays(const Stage& stage, const Snapshot& snapshot, const OverlayFlags& overlays) {
    begin(stage);
    if (overlays.quadtree) {
        paintCells(stage, snapshot.quadtree);
    }
    for (const BodyPicture& body : snapshot.bodies) {
        paintSubject(stage, {body.look->shapes, body.pose, body.velocity, body.bounds}, overlays);
    }
    stage.painter.restore();
}

} // namespace spacetow
