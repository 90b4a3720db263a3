#include "editor/canvas/difference_painter.h"

#include "core/level/level_index.h"
#include "core/level/outline.h"
#include "editor/canvas/palette.h"

#include <QPainterPath>

#include <algorithm>

namespace spacetow {

namespace {

QColor colorOf(const Theme& theme, ObjectChange change) {
    const MarkColors marks = markColors(theme.shade);
    switch (change) {
    case ObjectChange::Added:
        return marks.good;
    case ObjectChange::Removed:
        return marks.error;
    case ObjectChange::Moved:
    case ObjectChange::Retagged:
    case ObjectChange::Reordered:
    case ObjectChange::Changed:
        break;
    }
    return marks.warning;
}

QChar signOf(ObjectChange change) {
    return change == ObjectChange::Added ? u'+' : change == ObjectChange::Removed ? u'−' : u'~';
}

void strokeOutline(const Stage& stage, const Outline& outline, const QPen& pen) {
    for (const OutlinePath& path : outline.paths) {
        QPainterPath line;
        line.addPolygon(stage.at(path.points));
        if (path.closed) {
            line.closeSubpath();
        }
        stage.painter.strokePath(line, pen);
    }
    stage.painter.setPen(pen);
    for (const Circle& disc : outline.discs) {
        const double radius = stage.pixels(disc.radius);
        stage.painter.drawEllipse(stage.at(disc.center), radius, radius);
    }
}

void paintSign(const Stage& stage, const Outline& outline, const QColor& color, QChar sign) {
    const Aabb box = boundsOf(outline);
    if (box.isEmpty()) {
        return;
    }
    constexpr double radius = 8; // px
    const QPointF at = stage.at(Vec2(box.min.x(), box.max.y()));
    stage.painter.setPen(Qt::NoPen);
    stage.painter.setBrush(color);
    stage.painter.drawEllipse(at, radius, radius);
    stage.painter.setBrush(Qt::NoBrush);
    stage.painter.setPen(stage.theme.background);
    stage.painter.drawText(QRectF(at.x() - radius, at.y() - radius, 2 * radius, 2 * radius), Qt::AlignCenter, sign);
}

/// From the middle of where it was to that of where it is.
void paintWay(const Stage& stage, const Outline& from, const Outline& to, const QColor& color) {
    const PointSum old = pointsOf(from);
    const PointSum now = pointsOf(to);
    if (old.count == 0 || now.count == 0) {
        return;
    }
    const QLineF way(stage.at(old.sum / old.count), stage.at(now.sum / now.count));
    constexpr double head = 9; // px
    if (way.length() < 2 * head) {
        return;
    }
    stage.painter.setPen(stroke(color, 1.6));
    stage.painter.drawLine(way);
    QLineF wing(way.p2(), way.p1());
    wing.setLength(head);
    for (const double turn : {25.0, -25.0}) {
        QLineF side = wing;
        side.setAngle(wing.angle() + turn);
        stage.painter.drawLine(side);
    }
}

} // namespace

ShownDifference::ShownDifference(std::shared_ptr<const Level> before, const LevelDifference& difference)
    : m_before(std::move(before)) {
    for (const ObjectDifference& object : difference.objects) {
        m_changes.emplace_back(object.key, object.change);
    }
    std::ranges::sort(m_changes);
}

const ObjectChange* ShownDifference::changeOf(Key key) const {
    const auto found = std::ranges::lower_bound(m_changes, key, {}, [](const auto& each) { return each.first; });
    return found != m_changes.end() && found->first == key ? &found->second : nullptr;
}

void paintDifference(const Stage& stage, const Level& after, const ShownDifference& difference) {
    if (difference.empty()) {
        return;
    }
    QPainter& painter = stage.painter;
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    const Level& before = difference.before();
    const Outlines oldOutlines(before);
    const Outlines outlines(after);
    levelIndex(before).visitObjects(stage.view.visible(), [&](int place) {
        const Object& object = before.objects[place];
        const ObjectChange* change = difference.changeOf(object.key);
        if (change == nullptr || *change == ObjectChange::Retagged || *change == ObjectChange::Reordered) {
            return;
        }
        const Outline outline = oldOutlines.of(object);
        strokeOutline(stage, outline, stroke(colorOf(stage.theme, *change), 1.6, Qt::DashLine));
        if (*change == ObjectChange::Removed) {
            paintSign(stage, outline, colorOf(stage.theme, *change), signOf(*change));
        }
    });
    levelIndex(after).visitObjects(stage.view.visible(), [&](int place) {
        const Object& object = after.objects[place];
        const ObjectChange* change = difference.changeOf(object.key);
        if (change == nullptr || *change == ObjectChange::Removed) {
            return;
        }
        const QColor color = colorOf(stage.theme, *change);
        QColor glow = color;
        glow.setAlpha(90);
        const Outline outline = outlines.of(object);
        strokeOutline(stage, outline, stroke(glow, 7));
        strokeOutline(stage, outline, stroke(color, 1.6));
        const Object* old = before.objects.find(object.key);
        if (old != nullptr && *change == ObjectChange::Moved) {
            paintWay(stage, oldOutlines.of(*old), outline, color);
        }
        paintSign(stage, outline, color, signOf(*change));
    });
    painter.restore();
}

} // namespace spacetow
