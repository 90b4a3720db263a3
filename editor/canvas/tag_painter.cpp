#include "editor/canvas/tag_painter.h"

#include "core/level/groups.h"
#include "core/level/level_index.h"
#include "core/level/nodes.h"
#include "core/level/object_geometry.h"
#include "core/level/outline.h"
#include "editor/canvas/tag_text.h"
#include "editor/editing/collisions.h"

#include <algorithm>
#include <optional>

namespace spacetow {

namespace {

constexpr double smallest = 14; // px; what is smaller carries no label
constexpr int mostLabels = 400;
constexpr int dotSide = 8; // px
constexpr int padding = 4;

/// The first corner that can be seen of an outline so long that it has a tree.
std::optional<Vec2> cornerInView(const Level& level, int place, const Aabb& visible) {
    const auto& body = std::get<BodyObject>(level.objects[place].data);
    std::optional<Vec2> first;
    if (const std::vector<Vec2>* points = verticesOf(body.shapes[0]); points != nullptr && !points->empty()) {
        first = poseOf(level.objects[place])->toWorld(points->front());
    }
    if (first && visible.contains(*first)) {
        return first;
    }
    first.reset();
    levelIndex(level).visitVerticesOf(place, visible,
                                      [&](const VertexRef&, const Vec2& at) { first = first ? first : at; });
    return first;
}

/// Inside of what is filled, else a corner that can be seen: the middle of a cave is nowhere near its walls.
std::optional<Vec2> labelPlace(const Level& level, int place, const Aabb& visible) {
    const Object& object = level.objects[place];
    if (std::holds_alternative<BodyObject>(object.data) && levelIndex(level).treeOf(place, 0) != nullptr) {
        return cornerInView(level, place, visible);
    }
    const Outline outline = Outlines{Level()}.of(object); // connectors, which need the ends, have no tags
    if (!outline.discs.empty()) {
        return outline.discs.front().center;
    }
    for (const OutlinePath& path : outline.paths) {
        if (path.filled) {
            const PointSum points = pointsOf({{path}, {}});
            const Vec2 middle = points.sum / std::max(1, points.count);
            if (visible.contains(middle)) {
                return middle;
            }
        }
        const auto seen = std::ranges::find_if(path.points, [&](const Vec2& at) { return visible.contains(at); });
        if (seen != path.points.end()) {
            return *seen;
        }
    }
    return {};
}

void paintLabel(const Stage& stage, const TagTable& table, TagMask tags, const QPointF& at) {
    QPainter& painter = stage.painter;
    const QFontMetrics metrics = painter.fontMetrics();
    int wide = padding;
    for (int tag = 0; tag < TagTable::size; ++tag) {
        wide += tags.contains(tag) ? dotSide + 2 * padding + metrics.horizontalAdvance(tagText(table, tag)) : 0;
    }
    const QRectF plate(at.x() - wide / 2.0, at.y() - metrics.height() / 2.0 - 1, wide, metrics.height() + 2);
    painter.setPen(Qt::NoPen);
    painter.setBrush(stage.theme.halo);
    painter.drawRoundedRect(plate, padding, padding);
    double x = plate.left() + padding;
    for (int tag = 0; tag < TagTable::size; ++tag) {
        if (!tags.contains(tag)) {
            continue;
        }
        const QString name = tagText(table, tag);
        painter.setPen(Qt::NoPen);
        painter.setBrush(QColor::fromRgb(table[tag].color));
        painter.drawEllipse(QRectF(x, plate.center().y() - dotSide / 2.0, dotSide, dotSide));
        x += dotSide + padding;
        painter.setPen(stage.theme.text);
        const int advance = metrics.horizontalAdvance(name);
        painter.drawText(QRectF(x, plate.top(), advance + padding, plate.height()), Qt::AlignLeft | Qt::AlignVCenter,
                         name);
        x += advance + padding;
    }
}

} // namespace

void paintTags(const Stage& stage, const Level& level) {
    const GroupTree groups(level);
    const Aabb visible = stage.view.visible();
    QPainter& painter = stage.painter;
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    int labels = 0;
    const LevelIndex& index = levelIndex(level);
    index.visitObjects(visible, [&](int place) {
        // What is far off is many, and is passed over by its size alone.
        if (labels == mostLabels || stage.pixels(index.boundsOf(place).size().maxCoeff()) < smallest) {
            return;
        }
        const Object& object = level.objects[place];
        const std::optional<Filter> filter = groups.isVisible(object) ? filterOf(object) : std::nullopt;
        if (!filter || filter->tags.bits == 0) {
            return;
        }
        if (const std::optional<Vec2> at = labelPlace(level, place, visible)) {
            paintLabel(stage, level.tags, filter->tags, stage.at(*at));
            ++labels;
        }
    });
    painter.restore();
}

} // namespace spacetow
