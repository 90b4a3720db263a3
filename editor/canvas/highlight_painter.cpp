#include "editor/canvas/highlight_painter.h"

#include "core/level/groups.h"
#include "core/level/level_index.h"
#include "core/level/nodes.h"
#include "core/level/object_geometry.h"
#include "core/level/outline.h"
#include "editor/canvas/seen_points.h"
#include "editor/canvas/wall_painter.h"

#include <QPainterPath>

#include <algorithm>
#include <array>

namespace spacetow {

namespace {

struct HighlightLook {
    QColor fill;
    std::array<QPen, 2> pens; // no dashes, which would begin elsewhere in each view

    explicit HighlightLook(const Theme& theme) : fill(theme.collision) {
        fill.setAlpha(50);
        QColor glow = theme.collision; // walls are dark themselves
        glow.setAlpha(90);
        pens = {stroke(glow, 9), stroke(theme.collision, 2.5)};
    }
};

void strokeWith(const Stage& stage, const HighlightLook& look, const QPainterPath& path) {
    for (const QPen& pen : look.pens) {
        stage.painter.strokePath(path, pen);
    }
}

QPainterPath pathThrough(const Stage& stage, std::span<const Vec2> points, bool closed) {
    QPainterPath path;
    path.addPolygon(stage.at(points));
    if (closed) {
        path.closeSubpath();
    }
    return path;
}

/// An outline with so many vertices that it has a tree.
void highlightLong(const Stage& stage, const HighlightLook& look, const SeenOutline& outline) {
    constexpr double room = 8; // px, for pens
    const SeenArea area{stage.view.visible().grown(room * stage.view.pixel()), finestDetail(stage)};
    strokeWith(stage, look, pathThrough(stage, seenPoints(outline, area), outline.closed));
}

void highlightShort(const Stage& stage, const HighlightLook& look, const Outline& outline) {
    for (const OutlinePath& path : outline.paths) {
        const QPainterPath line = pathThrough(stage, path.points, path.closed);
        stage.painter.fillPath(line, path.filled ? QBrush(look.fill) : QBrush(Qt::NoBrush));
        strokeWith(stage, look, line);
    }
    for (const Circle& circle : outline.discs) {
        const double radius = stage.pixels(circle.radius);
        QPainterPath line;
        line.addEllipse(stage.at(circle.center), radius, radius);
        stage.painter.fillPath(line, look.fill);
        strokeWith(stage, look, line);
    }
}

bool hasLongOutline(const LevelIndex& index, const Object& object, int place) {
    return std::holds_alternative<BodyObject>(object.data) && index.treeOf(place, 0) != nullptr;
}

} // namespace

void paintHighlight(const Stage& stage, const Level& level, std::span<const Key> keys) {
    if (keys.empty()) {
        return;
    }
    const Outlines outlines{Level()}; // connectors, which need the ends, never collide
    const GroupTree groups(level);
    const LevelIndex& index = levelIndex(level);
    const HighlightLook look(stage.theme);
    const SavedPainter saved(stage.painter);
    index.visitObjects(stage.view.visible(), [&](int place) {
        const Object& object = level.objects[place];
        if (!std::ranges::binary_search(keys, object.key) || !groups.isVisible(object)) {
            return;
        }
        if (!hasLongOutline(index, object, place)) {
            highlightShort(stage, look, outlines.of(object));
            return;
        }
        const auto& body = std::get<BodyObject>(object.data);
        const Transform pose = *poseOf(object);
        for (std::size_t i = 0; i < body.shapes.size(); ++i) {
            if (const std::vector<Vec2>* points = verticesOf(body.shapes[i])) {
                const SegmentTree* tree = index.treeOf(place, static_cast<int>(i));
                highlightLong(stage, look, {*points, isClosed(body.shapes[i]), pose, tree});
            } else {
                const auto& circle = std::get<Circle>(body.shapes[i]);
                highlightShort(stage, look, {{}, {Circle{pose.toWorld(circle.center), circle.radius}}});
            }
        }
    });
}

} // namespace spacetow
