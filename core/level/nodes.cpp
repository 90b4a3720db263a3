#include "core/level/nodes.h"

#include "core/base/overloaded.h"
#include "core/level/object_geometry.h"

#include <algorithm>

namespace spacetow {

namespace {

template <class Shape>
auto* verticesIn(Shape& shape) {
    using Vertices = std::conditional_t<std::is_const_v<Shape>, const std::vector<Vec2>, std::vector<Vec2>>;
    return std::visit(
        [](auto& of) -> Vertices* {
            if constexpr (requires { of.vertices; }) {
                return &of.vertices;
            } else {
                return nullptr;
            }
        },
        shape);
}

} // namespace

std::vector<Vec2>* verticesOf(LevelShape& shape) {
    return verticesIn(shape);
}

const std::vector<Vec2>* verticesOf(const LevelShape& shape) {
    return verticesIn(shape);
}

bool isClosed(const LevelShape& shape) {
    return std::visit(Overloaded{[](const EdgeChain& chain) { return chain.closed; },
                                 [](const LineChain& chain) { return chain.closed; },
                                 [](const Polygon&) { return true; }, [](const Circle&) { return false; }},
                      shape);
}

namespace {

void mapNode(BodyObject& body, const NodeRef& node, const Affine& map) {
    if (node.shape < 0 || node.shape >= std::ssize(body.shapes)) {
        return;
    }
    std::vector<Vec2>* vertices = verticesOf(body.shapes[static_cast<std::size_t>(node.shape)]);
    if (vertices == nullptr || node.vertex < 0 || node.vertex >= std::ssize(*vertices)) {
        return;
    }
    const Transform pose{body.position, Rot::fromAngle(body.angle)};
    Vec2& vertex = (*vertices)[static_cast<std::size_t>(node.vertex)];
    vertex = tidied(pose.toLocal(tidied(map(pose.toWorld(vertex)))));
}

void mapNode(FinishObject& finish, const NodeRef& node, const Affine& map) {
    if (node.shape == 0 && (node.vertex == 0 || node.vertex == 1)) {
        Vec2& end = node.vertex == 0 ? finish.a : finish.b;
        end = tidied(map(end));
    }
}

} // namespace

std::vector<NodePath> nodePaths(const ObjectData& data) {
    std::vector<NodePath> paths;
    if (const auto* finish = std::get_if<FinishObject>(&data)) {
        paths.push_back({0, {finish->a, finish->b}, false});
    }
    const auto* body = std::get_if<BodyObject>(&data);
    if (body == nullptr) {
        return paths;
    }
    const Transform pose{body->position, Rot::fromAngle(body->angle)};
    for (std::size_t i = 0; i < body->shapes.size(); ++i) {
        if (const std::vector<Vec2>* vertices = verticesOf(body->shapes[i])) {
            NodePath path{static_cast<int>(i), *vertices, isClosed(body->shapes[i])};
            for (Vec2& point : path.points) {
                point = tidied(pose.toWorld(point));
            }
            paths.push_back(std::move(path));
        }
    }
    return paths;
}

bool hasNode(const ObjectData& data, int shape, int vertex) {
    if (std::holds_alternative<FinishObject>(data)) {
        return shape == 0 && (vertex == 0 || vertex == 1);
    }
    const auto* body = std::get_if<BodyObject>(&data);
    if (body == nullptr || shape < 0 || shape >= std::ssize(body->shapes) || vertex < 0) {
        return false;
    }
    const std::vector<Vec2>* vertices = verticesOf(body->shapes[static_cast<std::size_t>(shape)]);
    return vertices != nullptr && vertex < std::ssize(*vertices);
}

std::optional<Vec2> nodePosition(const Level& level, const NodeRef& node) {
    const Object* object = level.objects.find(node.key);
    if (object == nullptr || !hasNode(object->data, node.shape, node.vertex)) {
        return {};
    }
    if (const auto* finish = std::get_if<FinishObject>(&object->data)) {
        return node.vertex == 0 ? finish->a : finish->b;
    }
    const auto& body = std::get<BodyObject>(object->data);
    const Transform pose{body.position, Rot::fromAngle(body.angle)};
    const std::vector<Vec2>* vertices = verticesOf(body.shapes[static_cast<std::size_t>(node.shape)]);
    return tidied(pose.toWorld((*vertices)[static_cast<std::size_t>(node.vertex)]));
}

std::vector<NodeRef> allNodes(const Level& level, std::span<const Key> keys) {
    std::vector<NodeRef> nodes;
    for (const int place : level.objects.indicesOf(keys)) {
        const Object& object = level.objects[place];
        for (const NodePath& path : nodePaths(object.data)) {
            for (std::size_t i = 0; i < path.points.size(); ++i) {
                nodes.push_back({object.key, path.shape, static_cast<int>(i)});
            }
        }
    }
    std::ranges::sort(nodes);
    return nodes;
}

Level withMappedNodes(Level level, std::span<const NodeRef> nodes, const Affine& map) {
    EXPECTS(std::ranges::is_sorted(nodes));
    for (std::size_t first = 0; first < nodes.size();) {
        const Key key = nodes[first].key;
        const auto next = std::ranges::upper_bound(nodes.subspan(first), key, {}, &NodeRef::key);
        const auto end = static_cast<std::size_t>(next - nodes.begin());
        const auto own = nodes.subspan(first, end - first);
        first = end;
        const int place = level.objects.indexOf(key);
        if (place < 0) {
            continue;
        }
        Object object = level.objects[place];
        for (const NodeRef& node : own) {
            if (auto* body = std::get_if<BodyObject>(&object.data)) {
                mapNode(*body, node, map);
            } else if (auto* finish = std::get_if<FinishObject>(&object.data)) {
                mapNode(*finish, node, map);
            }
        }
        level.objects.replace(place, std::move(object));
    }
    return level;
}

} // namespace spacetow
