#include "core/level/node_edits.h"

#include "core/geometry/polygon.h"
#include "core/level/fields.h"
#include "core/level/groups.h"
#include "core/level/level_index.h"
#include "core/level/object_geometry.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace spacetow {

namespace {

using Pieces = std::optional<std::vector<ShapePiece>>;

Transform poseOfBody(const BodyObject& body) {
    return {body.position, Rot::fromAngle(body.angle)};
}

const LevelShape& shapeOf(const BodyObject& body, const NodeRef& node) {
    return body.shapes[static_cast<std::size_t>(node.shape)];
}

std::vector<bool> flags(std::size_t count, std::span<const NodeRef> nodes) {
    std::vector<bool> chosen(count, false);
    for (const NodeRef& node : nodes) {
        chosen[static_cast<std::size_t>(node.vertex)] = true;
    }
    return chosen;
}

/// For each segment whether both of its ends are chosen.
std::vector<bool> chosenSegments(const LevelShape& shape, std::span<const NodeRef> nodes) {
    const std::size_t count = verticesOf(shape)->size();
    const std::vector<bool> chosen = flags(count, nodes);
    std::vector<bool> segments(isClosed(shape) || count == 0 ? count : count - 1);
    for (std::size_t i = 0; i < segments.size(); ++i) {
        segments[i] = chosen[i] && chosen[(i + 1) % count];
    }
    return segments;
}

bool fits(const LevelShape& shape, std::size_t vertices) {
    return !std::holds_alternative<Polygon>(shape) || vertices <= static_cast<std::size_t>(limits::polygonVertices);
}

/// A piece of a chain between places where chosen segments begin or end.
struct Stretch {
    std::vector<int> run;
    bool chosen = false;
};

std::vector<Stretch> stretches(const LevelShape& shape, const std::vector<bool>& segments) {
    const std::size_t count = verticesOf(shape)->size();
    std::vector<bool> split(count, false);
    for (std::size_t i = 0; i < segments.size(); ++i) {
        const bool hasBefore = i > 0 || isClosed(shape);
        split[i] = hasBefore && segments[i] != segments[(i + segments.size() - 1) % segments.size()];
    }
    std::vector<Stretch> result;
    for (std::vector<int>& run : splitRuns(static_cast<int>(count), isClosed(shape), split)) {
        const bool chosen = segments[static_cast<std::size_t>(run.front())];
        result.push_back({std::move(run), chosen});
    }
    return result;
}

std::vector<int> upTo(std::size_t count) {
    std::vector<int> indices(count);
    for (std::size_t i = 0; i < count; ++i) {
        indices[i] = static_cast<int>(i);
    }
    return indices;
}

bool all(const std::vector<bool>& of, bool value) {
    return std::ranges::all_of(of, [value](bool flag) { return flag == value; });
}

Vec2 directionIn15Degrees(const Vec2& vector) {
    constexpr double step = std::numbers::pi / 12;
    const double angle = step * std::round(std::atan2(vector.y(), vector.x()) / step);
    return Affine::rotation({0, 0}, angle).linear({1, 0});
}

/// Points of the world; segment i leads from point i to the next.
void straighten(std::vector<Vec2>& points, const std::vector<bool>& segments) {
    const std::size_t count = points.size();
    const bool closed = segments.size() == count;
    // A row of a closed chain may go on beyond its first vertex.
    std::size_t start = 0;
    while (closed && start < count && (segments[(start + count - 1) % count] || !segments[start])) {
        ++start;
    }
    const bool round = closed && all(segments, true);
    const std::vector<Vec2> before = points;
    for (std::size_t i = 0; i < (round ? count - 1 : segments.size()); ++i) {
        const std::size_t from = (start + i) % count;
        const std::size_t to = (from + 1) % count;
        const Vec2 way = before[to] - before[from];
        if (segments[from] && way != Vec2(0, 0)) {
            points[to] = tidied(Vec2(points[from] + way.norm() * directionIn15Degrees(way)));
        }
    }
}

Pieces midpointsOf(const LevelShape& shape, std::span<const NodeRef> nodes) {
    const std::vector<Vec2>& vertices = *verticesOf(shape);
    const std::vector<bool> segments = chosenSegments(shape, nodes);
    const auto added = static_cast<std::size_t>(std::ranges::count(segments, true));
    if (added == 0 || !fits(shape, vertices.size() + added)) {
        return {};
    }
    const std::vector<bool> chosen = flags(vertices.size(), nodes);
    ShapePiece piece{shape};
    std::vector<Vec2> points;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        if (chosen[i]) {
            piece.nodes.push_back(static_cast<int>(points.size()));
        }
        points.push_back(vertices[i]);
        if (i < segments.size() && segments[i]) {
            piece.nodes.push_back(static_cast<int>(points.size()));
            points.push_back(tidied(Vec2(0.5 * (vertices[i] + vertices[(i + 1) % vertices.size()]))));
        }
    }
    *verticesOf(piece.shape) = std::move(points);
    return std::vector{std::move(piece)};
}

/// The finish has one segment, which keeps its first end.
Level withStraightFinish(Level level, std::span<const NodeRef> nodes) {
    for (const NodeRef& node : nodes) {
        const int index = node.vertex == 0 ? level.objects.indexOf(node.key) : -1;
        const NodeRef other{node.key, 0, 1};
        if (index >= 0 && std::holds_alternative<FinishObject>(level.objects[index].data) &&
            std::ranges::binary_search(nodes, other)) {
            Object object = level.objects[index];
            auto& finish = std::get<FinishObject>(object.data);
            std::vector<Vec2> ends{finish.a, finish.b};
            straighten(ends, {true});
            finish.b = ends[1];
            level.objects.replace(index, std::move(object));
        }
    }
    return level;
}

} // namespace

NodeEdit withNode(Level level, const NodeRef& segment, const Vec2& at) {
    return reshaped(
        std::move(level), {&segment, 1},
        [&at](const BodyObject& body, const NodeRef& node, std::span<const NodeRef>) -> Pieces {
            const LevelShape& shape = shapeOf(body, node);
            std::vector<Vec2> vertices = *verticesOf(shape);
            const int after = node.vertex + 1;
            if ((!isClosed(shape) && after >= std::ssize(vertices)) || !fits(shape, vertices.size() + 1)) {
                return {};
            }
            vertices.insert(vertices.begin() + after, tidied(poseOfBody(body).toLocal(at)));
            return std::vector{ShapePiece{withVertices(shape, std::move(vertices), isClosed(shape)), {after}}};
        });
}

NodeEdit withMidpoints(Level level, std::span<const NodeRef> nodes) {
    return reshaped(std::move(level), nodes,
                    [](const BodyObject& body, const NodeRef& first, std::span<const NodeRef> chosen) {
                        return midpointsOf(shapeOf(body, first), chosen);
                    });
}

Level withoutNodes(Level level, std::span<const NodeRef> nodes) {
    const auto change = [](const BodyObject& body, const NodeRef& first, std::span<const NodeRef> chosen) -> Pieces {
        const LevelShape& shape = shapeOf(body, first);
        const std::vector<Vec2>& vertices = *verticesOf(shape);
        const std::vector<bool> goes = flags(vertices.size(), chosen);
        std::vector<Vec2> kept;
        for (std::size_t i = 0; i < vertices.size(); ++i) {
            if (!goes[i]) {
                kept.push_back(vertices[i]);
            }
        }
        // A closed chain of two would be one wall there and back.
        const bool closed = isClosed(shape) && kept.size() >= 3;
        ShapePiece piece{withVertices(shape, std::move(kept), closed)};
        return isWhole(piece.shape) ? std::vector{std::move(piece)} : std::vector<ShapePiece>();
    };
    return reshaped(std::move(level), nodes, change).level;
}

NodeEdit withoutSegments(Level level, std::span<const NodeRef> nodes) {
    const auto change = [](const BodyObject& body, const NodeRef& first, std::span<const NodeRef> chosen) -> Pieces {
        const LevelShape& shape = shapeOf(body, first);
        const std::vector<bool> segments = chosenSegments(shape, chosen);
        if (std::holds_alternative<Polygon>(shape) || all(segments, false)) {
            return {};
        }
        std::vector<ShapePiece> pieces;
        for (const Stretch& stretch : stretches(shape, segments)) {
            ShapePiece piece{chainOf(shape, stretch.run)};
            if (!stretch.chosen && isWhole(piece.shape)) {
                pieces.push_back(std::move(piece));
            }
        }
        return pieces;
    };
    return reshaped(std::move(level), nodes, change);
}

NodeEdit brokenAt(Level level, std::span<const NodeRef> nodes) {
    const auto change = [](const BodyObject& body, const NodeRef& first, std::span<const NodeRef> chosen) -> Pieces {
        const LevelShape& shape = shapeOf(body, first);
        const std::vector<Vec2>& vertices = *verticesOf(shape);
        const std::vector<bool> split = flags(vertices.size(), chosen);
        const auto runs = std::holds_alternative<Polygon>(shape)
                              ? std::vector<std::vector<int>>()
                              : splitRuns(static_cast<int>(vertices.size()), isClosed(shape), split);
        if (runs.empty() || (runs.size() == 1 && !isClosed(shape))) {
            return {};
        }
        std::vector<ShapePiece> pieces;
        for (const std::vector<int>& run : runs) {
            ShapePiece piece{chainOf(shape, run)};
            if (split[static_cast<std::size_t>(run.front())]) {
                piece.nodes.push_back(0);
            }
            if (split[static_cast<std::size_t>(run.back())]) {
                piece.nodes.push_back(static_cast<int>(run.size()) - 1);
            }
            if (isWhole(piece.shape)) {
                pieces.push_back(std::move(piece));
            }
        }
        return pieces;
    };
    return reshaped(std::move(level), nodes, change);
}

NodeEdit reversedPart(Level level, std::span<const NodeRef> nodes) {
    const auto change = [](const BodyObject& body, const NodeRef& first, std::span<const NodeRef> chosen) -> Pieces {
        const LevelShape& shape = shapeOf(body, first);
        const std::vector<bool> segments = chosenSegments(shape, chosen);
        if (std::holds_alternative<Polygon>(shape) || all(segments, false)) {
            return {};
        }
        if (all(segments, true)) {
            ShapePiece piece{shape, upTo(verticesOf(shape)->size())};
            reverse(*verticesOf(piece.shape), isClosed(shape));
            return std::vector{std::move(piece)};
        }
        std::vector<ShapePiece> pieces;
        for (Stretch& stretch : stretches(shape, segments)) {
            if (stretch.chosen) {
                std::ranges::reverse(stretch.run);
            }
            ShapePiece piece{chainOf(shape, stretch.run)};
            if (stretch.chosen) {
                piece.nodes = upTo(stretch.run.size());
            }
            if (isWhole(piece.shape)) {
                pieces.push_back(std::move(piece));
            }
        }
        return pieces;
    };
    return reshaped(std::move(level), nodes, change);
}

NodeEdit straightened(Level level, std::span<const NodeRef> nodes) {
    const auto change = [](const BodyObject& body, const NodeRef& first, std::span<const NodeRef> chosen) -> Pieces {
        const LevelShape& shape = shapeOf(body, first);
        const std::vector<bool> segments = chosenSegments(shape, chosen);
        if (all(segments, false)) {
            return {};
        }
        const Transform pose = poseOfBody(body);
        std::vector<Vec2> points = *verticesOf(shape);
        std::ranges::transform(points, points.begin(), [&](const Vec2& at) { return tidied(pose.toWorld(at)); });
        const std::vector<Vec2> before = points;
        straighten(points, segments);
        ShapePiece piece{shape};
        for (std::size_t i = 0; i < points.size(); ++i) {
            if (points[i] != before[i]) {
                (*verticesOf(piece.shape))[i] = tidied(pose.toLocal(points[i]));
            }
        }
        for (const NodeRef& node : chosen) {
            piece.nodes.push_back(node.vertex);
        }
        return isWhole(piece.shape) ? Pieces(std::vector{std::move(piece)}) : Pieces();
    };
    return reshaped(withStraightFinish(std::move(level), nodes), nodes, change);
}

std::vector<NodeRef> nodesAt(const Level& level, std::span<const Vec2> points) {
    constexpr double near = 1e-9; // of the coordinate, and at least so many metres
    const GroupTree tree(level);
    std::vector<NodeRef> nodes;
    for (const Vec2& point : points) {
        const double room = near * std::max(1.0, point.lpNorm<Eigen::Infinity>());
        levelIndex(level).visitVertices(Aabb{point, point}.grown(room), [&](const VertexRef& ref, const Vec2&) {
            const Object& object = level.objects[ref.object];
            if (tree.isVisible(object) && !tree.isLocked(object)) {
                nodes.push_back({object.key, ref.shape, ref.vertex});
            }
        });
    }
    std::ranges::sort(nodes);
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    return nodes;
}

NodeFault faultAt(const Level& level, std::span<const NodeRef> nodes) {
    NodeFault worst = NodeFault::None;
    for (auto own = nodes.begin(); own != nodes.end();) {
        const auto next = std::find_if(
            own, nodes.end(), [&](const NodeRef& node) { return node.key != own->key || node.shape != own->shape; });
        const Object* object = level.objects.find(own->key);
        const auto* body = object != nullptr ? std::get_if<BodyObject>(&object->data) : nullptr;
        if (body != nullptr && hasNode(object->data, own->shape, own->vertex)) {
            const LevelShape& shape = shapeOf(*body, *own);
            const std::vector<Vec2>& vertices = *verticesOf(shape);
            const std::size_t segments = isClosed(shape) ? vertices.size() : vertices.size() - 1;
            bool together = false;
            for (std::size_t i = 0; i < segments; ++i) {
                together = together || vertices[i] == vertices[(i + 1) % vertices.size()];
            }
            if (together && worst == NodeFault::None) {
                worst = NodeFault::Together;
            } else if (!together && std::holds_alternative<Polygon>(shape) && !isSimple(vertices)) {
                worst = NodeFault::Crosses;
            }
        }
        own = next;
    }
    return worst;
}

} // namespace spacetow
