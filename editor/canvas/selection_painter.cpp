// The outlines of what is selected.
#include "core/level/groups.h"
#include "core/level/level_index.h"
#include "core/level/outline.h"
#include "editor/canvas/scene_painter.h"
#include "editor/canvas/seen_points.h"
#include "editor/canvas/wall_painter.h"

#include <algorithm>
#include <optional>

namespace spacetow {

namespace {

void strokeOutline(const Stage& stage, const Outline& outline) {
    for (const OutlinePath& path : outline.paths) {
        paintPolyline(stage, simplified(path.points, finestDetail(stage)), path.closed);
    }
    for (const Circle& circle : outline.discs) {
        const double radius = stage.pixels(circle.radius);
        stage.painter.drawEllipse(stage.at(circle.center), radius, radius);
    }
}

void paintDots(const Stage& stage, const Outline& outline) {
    constexpr double apart = 7; // px; closer dots would run together
    constexpr double size = 2.6;
    stage.painter.setPen(stroke(stage.theme.background, 1));
    stage.painter.setBrush(stage.theme.selection);
    const QRectF view(-size, -size, stage.view.size.x() + 2 * size, stage.view.size.y() + 2 * size);
    for (const OutlinePath& path : outline.paths) {
        QPointF last(-1e9, -1e9);
        for (const Vec2& point : path.points) {
            const QPointF at = stage.at(point);
            if ((at - last).manhattanLength() < apart) {
                continue;
            }
            last = at; // whether it can be seen or not, so that views that overlap show the same dots
            if (view.contains(at)) {
                stage.painter.drawRect(QRectF(at.x() - size, at.y() - size, 2 * size, 2 * size));
            }
        }
    }
    stage.painter.setBrush(Qt::NoBrush);
}

/// A padlock on the highest point of what is locked; no further out than pens reach, see Stage::sees.
void paintLock(const Stage& stage, const Outline& outline) {
    std::optional<Vec2> top;
    for (const OutlinePath& path : outline.paths) {
        for (const Vec2& point : path.points) {
            top = !top || point.y() > top->y() ? point : *top;
        }
    }
    for (const Circle& disc : outline.discs) {
        const Vec2 point = disc.center + Vec2(0, disc.radius);
        top = !top || point.y() > top->y() ? point : *top;
    }
    if (!top) {
        return;
    }
    const QPointF at = stage.at(*top) + QPointF(-4, -6);
    QPainter& painter = stage.painter;
    painter.setPen(stroke(stage.theme.background, 4));
    painter.drawRect(QRectF(at.x(), at.y() + 4, 9, 7));
    painter.setPen(stroke(stage.theme.selection, 1.6));
    painter.drawArc(QRectF(at.x() + 1.5, at.y(), 6, 8), 0, 180 * 16);
    painter.setBrush(stage.theme.selection);
    painter.drawRect(QRectF(at.x(), at.y() + 4, 9, 7));
    painter.setBrush(Qt::NoBrush);
}

} // namespace

void paintSelection(const Stage& stage, const Level& level, const Selection& selection) {
    if (selection.empty()) {
        return;
    }
    const Outlines outlines(level);
    const std::vector<Key> keys = withMembers(level, selection.keys());
    constexpr int few = 300; // more than these are seen without a glow, which takes most of the time
    const bool glows = std::ssize(keys) <= few;
    QPainter& painter = stage.painter;
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    const LevelIndex& index = levelIndex(level);
    const GroupTree tree(level);
    for (const int place : level.objects.indicesOf(keys)) {
        if (!stage.sees(index.boundsOf(place))) {
            continue;
        }
        const Object& object = level.objects[place];
        const Outline outline = outlines.of(object);
        const bool isLocked = tree.isLocked(object);
        if (glows && !isLocked) { // it would fill the gaps of the dashes
            QColor glow = stage.theme.selection;
            glow.setAlpha(90);
            painter.setPen(stroke(glow, 7));
            strokeOutline(stage, outline);
        }
        painter.setPen(stroke(stage.theme.selection, 2, isLocked ? Qt::DashLine : Qt::SolidLine));
        strokeOutline(stage, outline);
        if (isLocked) {
            paintLock(stage, outline);
        } else if (std::holds_alternative<BodyObject>(object.data)) {
            paintDots(stage, outline);
        }
    }
    painter.restore();
}

bool isLongToHover(const Level& level, Key hovered, const Aabb& view) {
    constexpr int few = 250; // segments; 2 to 4 ms
    if (hovered == 0) {
        return false;
    }
    const LevelIndex& index = levelIndex(level);
    int segments = 0;
    for (const int place : level.objects.indicesOf(withMembers(level, std::span(&hovered, 1)))) {
        segments += segments <= few && index.boundsOf(place).overlaps(view) ? index.segmentsNear(place, view) : 0;
    }
    return segments > few;
}

void paintHovered(const Stage& stage, const Level& level, Key hovered) {
    const Outlines outlines(level);
    QPainter& painter = stage.painter;
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    for (const Key key : withMembers(level, std::span(&hovered, 1))) {
        const Object* const object = level.objects.find(key);
        if (object == nullptr) {
            continue;
        }
        const Outline outline = outlines.of(*object);
        QColor glow = stage.theme.hover; // apart from a wall of a like colour
        glow.setAlpha(90);
        painter.setPen(stroke(glow, 8));
        strokeOutline(stage, outline);
        painter.setPen(stroke(stage.theme.hover, 2));
        strokeOutline(stage, outline);
    }
    painter.restore();
}

} // namespace spacetow
