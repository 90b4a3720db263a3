#include "editor/canvas/node_painter.h"

#include "core/level/level_index.h"

#include <QPainter>
#include <QPixmap>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace spacetow {

namespace {

constexpr double size = 4;          // px, half the side of a square
constexpr double apart = 7;         // px; closer nodes would run together
constexpr double longEnough = 34;   // px, of a segment that shows its direction
constexpr double headLength = 9;    // px
constexpr double headHalfWidth = 4; // px

enum class NodeMark : std::uint8_t { Inner, End, First };

const LevelShape* shapeOf(const Object& object, int shape) {
    const auto* body = std::get_if<BodyObject>(&object.data);
    return body != nullptr ? &body->shapes[static_cast<std::size_t>(shape)] : nullptr;
}

NodeMark markOf(const Object& object, const VertexRef& ref) {
    const LevelShape* shape = shapeOf(object, ref.shape);
    if (shape != nullptr && isClosed(*shape)) {
        return ref.vertex == 0 ? NodeMark::First : NodeMark::Inner;
    }
    const int last = shape != nullptr ? static_cast<int>(verticesOf(*shape)->size()) - 1 : 1;
    return ref.vertex == 0 ? NodeMark::First : ref.vertex == last ? NodeMark::End : NodeMark::Inner;
}

void paintMark(QPainter& painter, const QPointF& at, NodeMark mark, double half) {
    switch (mark) {
    case NodeMark::Inner:
        painter.drawRect(QRectF(at.x() - half, at.y() - half, 2 * half, 2 * half));
        break;
    case NodeMark::End:
        painter.drawEllipse(at, half + 0.5, half + 0.5);
        break;
    case NodeMark::First: {
        const double reach = half + 2;
        painter.drawPolygon(QPolygonF{at + QPointF(0, -reach), at + QPointF(reach, 0), at + QPointF(0, reach),
                                      at + QPointF(-reach, 0)});
        break;
    }
    }
}

void paintDirection(QPainter& painter, const QPointF& a, const QPointF& b) {
    const QPointF way = b - a;
    const double length = std::hypot(way.x(), way.y());
    if (length < longEnough) {
        return;
    }
    const QPointF along = way / length;
    const QPointF across(-along.y(), along.x());
    const QPointF tip = 0.5 * (a + b) + 0.5 * headLength * along;
    const QPointF back = tip - headLength * along;
    painter.drawPolyline(QPolygonF{back + headHalfWidth * across, tip, back - headHalfWidth * across});
}

void paintDirections(const Stage& stage, const Level& level, int object, const Aabb& view) {
    const Object& of = level.objects[object];
    stage.painter.setPen(stroke(stage.theme.selection, 1.6));
    levelIndex(level).visitSegmentsOf(object, view, [&](const SegmentRef& ref, const Vec2& a, const Vec2& b) {
        const LevelShape* shape = shapeOf(of, ref.shape);
        if (shape != nullptr && std::holds_alternative<EdgeChain>(*shape)) {
            paintDirection(stage.painter, stage.at(a), stage.at(b));
        }
    });
}

/// A square, a disc or a diamond, as it is painted at many nodes. Painting it anew each time would take ten times as
/// long.
class NodeStamp {
  public:
    NodeStamp(const Stage& stage, NodeMark mark, bool chosen) : m_ratio(stage.painter.device()->devicePixelRatioF()) {
        const int side = static_cast<int>(std::ceil(2 * reach * m_ratio));
        m_picture = QPixmap(side, side);
        m_picture.setDevicePixelRatio(m_ratio);
        m_picture.fill(Qt::transparent);
        QPainter painter(&m_picture);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(stroke(chosen ? stage.theme.background : stage.theme.selection, 1.4));
        painter.setBrush(chosen ? stage.theme.draft : stage.theme.background);
        paintMark(painter, QPointF(reach, reach), mark, chosen ? size + 1 : size);
    }

    /// On whole pixels, where its sides are sharp.
    void paint(QPainter& painter, const QPointF& at) const {
        const auto whole = [this](double place) { return std::round((place - reach) * m_ratio) / m_ratio; };
        painter.drawPixmap(QPointF(whole(at.x()), whole(at.y())), m_picture);
    }

  private:
    static constexpr double reach = 10; // px
    double m_ratio;                     // device pixels a logical one
    QPixmap m_picture;
};

/// Made when they are first needed.
class NodeStamps {
  public:
    explicit NodeStamps(const Stage& stage) : m_stage(stage) {}

    void paint(const QPointF& at, NodeMark mark, bool chosen) {
        std::optional<NodeStamp>& stamp = m_stamps[2 * static_cast<std::size_t>(mark) + (chosen ? 1 : 0)];
        if (!stamp) {
            stamp.emplace(m_stage, mark, chosen);
        }
        stamp->paint(m_stage.painter, at);
    }

  private:
    const Stage& m_stage;
    std::array<std::optional<NodeStamp>, 6> m_stamps; // by mark, each not chosen and chosen
};

void paintNodesOf(const Stage& stage, const Level& level, const Selection& selection, int object, const Aabb& view) {
    const Object& of = level.objects[object];
    NodeStamps stamps(stage);
    QPointF last(-1e9, -1e9);
    levelIndex(level).visitVerticesOf(object, view, [&](const VertexRef& ref, const Vec2& at) {
        const bool chosen = selection.contains(NodeRef{of.key, ref.shape, ref.vertex});
        const QPointF place = stage.at(at);
        if (!chosen && (place - last).manhattanLength() < apart) {
            return;
        }
        last = place;
        stamps.paint(place, markOf(of, ref), chosen);
    });
}

void paintHot(const Stage& stage, const Level& level, const OverlayNodes& nodes) {
    std::vector<Vec2> places;
    for (const NodeRef& node : nodes.hot) {
        if (const std::optional<Vec2> at = nodePosition(level, node)) {
            places.push_back(*at);
        }
    }
    stage.painter.setBrush(Qt::NoBrush);
    stage.painter.setPen(stroke(stage.theme.snap, 2));
    if (nodes.hotSegment && places.size() == 2) {
        stage.painter.drawLine(stage.at(places[0]), stage.at(places[1]));
        return;
    }
    for (const Vec2& place : places) {
        stage.painter.drawEllipse(stage.at(place), size + 4, size + 4);
    }
}

} // namespace

void paintNodes(const Stage& stage, const Level& level, const Selection& selection, const OverlayNodes& nodes) {
    const Aabb view = stage.view.visible().grown(2 * size * stage.view.pixel());
    const LevelIndex& index = levelIndex(level);
    stage.painter.save();
    stage.painter.setRenderHint(QPainter::Antialiasing);
    for (const Key key : nodes.keys) {
        const int object = level.objects.indexOf(key);
        if (object >= 0 && index.boundsOf(object).overlaps(view)) {
            stage.painter.setBrush(Qt::NoBrush);
            paintDirections(stage, level, object, view);
            paintNodesOf(stage, level, selection, object, view);
        }
    }
    paintHot(stage, level, nodes);
    stage.painter.restore();
}

} // namespace spacetow
