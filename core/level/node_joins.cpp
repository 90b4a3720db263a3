// Joining nodes: chains become one, or closed.
#include "core/level/node_edits.h"

#include <algorithm>

namespace spacetow {

namespace {

struct Place {
    int object = 0; // in the level
    NodeRef node;
    const BodyObject* body = nullptr;
    const LevelShape* shape = nullptr;

    const std::vector<Vec2>& vertices() const { return *verticesOf(*shape); }
    Transform pose() const { return {body->position, Rot::fromAngle(body->angle)}; }
    bool isFirst() const { return node.vertex == 0; }
    bool isEnd() const {
        return !isClosed(*shape) && (isFirst() || node.vertex + 1 == static_cast<int>(vertices().size()));
    }
};

std::optional<Place> placeOf(const Level& level, const NodeRef& node) {
    const int index = level.objects.indexOf(node.key);
    if (index < 0 || !hasNode(level.objects[index].data, node.shape, node.vertex)) {
        return {};
    }
    const auto* body = std::get_if<BodyObject>(&level.objects[index].data);
    if (body == nullptr) {
        return {};
    }
    return Place{index, node, body, &body->shapes[static_cast<std::size_t>(node.shape)]};
}

/// What the shape of the first of the two becomes, with its new node. That of the second, if another, goes.
struct Join {
    Place first, second;
    ShapePiece piece;
};

/// Two nodes of one shape, the first with the smaller number.
std::optional<ShapePiece> joinedWithin(const Place& a, const Place& b, JoinWay way) {
    std::vector<Vec2> vertices = a.vertices();
    const int count = static_cast<int>(vertices.size());
    const int from = a.node.vertex;
    const int to = b.node.vertex;
    const bool wraps = from == 0 && to == count - 1;
    const bool neighbours = to == from + 1 || (wraps && isClosed(*a.shape));
    const Vec2 start = vertices[static_cast<std::size_t>(from)];
    const Vec2 end = vertices[static_cast<std::size_t>(to)];
    const bool closes = wraps && !isClosed(*a.shape) && count > 2;
    if (!closes && (!neighbours || way != JoinWay::Weld)) {
        return {};
    }
    ShapePiece piece{*a.shape, {from}};
    if (way == JoinWay::Segment && start != end) {
        piece.nodes.push_back(to);
    } else {
        vertices[static_cast<std::size_t>(from)] = tidied(Vec2(0.5 * (start + end)));
        vertices.erase(vertices.begin() + to);
    }
    const bool closed = closes || isClosed(*a.shape);
    if (closed && vertices.size() < 3) {
        return {};
    }
    piece.shape = withVertices(*a.shape, std::move(vertices), closed);
    return isWhole(piece.shape) ? std::optional(std::move(piece)) : std::nullopt;
}

/// Ends of two chains of a kind. The first keeps its direction.
std::optional<ShapePiece> joinedTogether(const Place& a, const Place& b, JoinWay way) {
    if (!a.isEnd() || !b.isEnd() || a.shape->index() != b.shape->index()) {
        return {};
    }
    std::vector<Vec2> other;
    for (const Vec2& vertex : b.vertices()) {
        other.push_back(a.body == b.body ? vertex : tidied(a.pose().toLocal(tidied(b.pose().toWorld(vertex)))));
    }
    const bool before = a.isFirst(); // the other chain comes to stand before this one
    if (b.isFirst() == before) {
        std::ranges::reverse(other);
    }
    std::vector<Vec2> vertices = before ? other : a.vertices();
    std::vector<Vec2> rest = before ? a.vertices() : std::move(other);
    const int joint = static_cast<int>(vertices.size()) - 1;
    ShapePiece piece{*a.shape, {joint}};
    if (way == JoinWay::Weld || vertices.back() == rest.front()) {
        vertices.back() = tidied(Vec2(0.5 * (vertices.back() + rest.front())));
        rest.erase(rest.begin());
    } else {
        piece.nodes.push_back(joint + 1);
    }
    vertices.insert(vertices.end(), rest.begin(), rest.end());
    piece.shape = withVertices(*a.shape, std::move(vertices), false);
    return isWhole(piece.shape) ? std::optional(std::move(piece)) : std::nullopt;
}

std::optional<Join> joinOf(const Level& level, std::span<const NodeRef> nodes, JoinWay way) {
    if (nodes.size() != 2) {
        return {};
    }
    std::optional<Place> a = placeOf(level, nodes[0]);
    std::optional<Place> b = placeOf(level, nodes[1]);
    if (!a || !b) {
        return {};
    }
    if (b->object < a->object) {
        std::swap(a, b);
    }
    auto piece = a->shape == b->shape ? joinedWithin(*a, *b, way) : joinedTogether(*a, *b, way);
    if (!piece) {
        return {};
    }
    return Join{*a, *b, std::move(*piece)};
}

} // namespace

bool canJoin(const Level& level, std::span<const NodeRef> nodes, JoinWay way) {
    return joinOf(level, nodes, way).has_value();
}

NodeEdit joined(Level level, std::span<const NodeRef> nodes, JoinWay way) {
    const std::optional<Join> join = joinOf(level, nodes, way);
    if (!join) {
        return {std::move(level), {nodes.begin(), nodes.end()}};
    }
    const NodeRef kept = join->first.node;
    const ShapePiece piece = join->piece;
    return reshaped(std::move(level), nodes, [&](const BodyObject&, const NodeRef& node, std::span<const NodeRef>) {
        const bool keeps = node.key == kept.key && node.shape == kept.shape;
        return std::optional(keeps ? std::vector{piece} : std::vector<ShapePiece>());
    });
}

} // namespace spacetow
