#include "core/level/chain_ends.h"

#include "core/level/edits.h"
#include "core/level/nodes.h"

#include <algorithm>

namespace spacetow {

namespace {

const LevelShape* chainAt(const Level& level, const ChainEnd& end) {
    const Object* object = level.objects.find(end.key);
    const auto* body = object != nullptr ? std::get_if<BodyObject>(&object->data) : nullptr;
    if (body == nullptr || end.shape < 0 || end.shape >= static_cast<int>(body->shapes.size())) {
        return nullptr;
    }
    const LevelShape& shape = body->shapes[static_cast<std::size_t>(end.shape)];
    const std::vector<Vec2>* vertices = verticesOf(shape);
    return vertices == nullptr || vertices->size() < 2 || isClosed(shape) ? nullptr : &shape;
}

void closeChain(LevelShape& shape) {
    if (auto* edges = std::get_if<EdgeChain>(&shape)) {
        edges->closed = true;
    } else if (auto* lines = std::get_if<LineChain>(&shape)) {
        lines->closed = true;
    }
}

} // namespace

std::optional<OpenChain> openChain(const Level& level, const ChainEnd& end) {
    const LevelShape* chain = chainAt(level, end);
    if (chain == nullptr) {
        return {};
    }
    const int count = static_cast<int>(verticesOf(*chain)->size());
    const int last = count - 1;
    const std::optional<Vec2> at = nodePosition(level, {end.key, end.shape, end.first ? 0 : last});
    const std::optional<Vec2> other = nodePosition(level, {end.key, end.shape, end.first ? last : 0});
    const auto* walls = std::get_if<EdgeChain>(chain);
    return OpenChain{tidied(*at), tidied(*other), count, walls != nullptr ? walls->depth : 0};
}

Level extended(Level level, const ChainEnd& end, std::span<const Vec2> points, bool closes) {
    if (chainAt(level, end) == nullptr) {
        return level;
    }
    Object object = *level.objects.find(end.key);
    auto& body = std::get<BodyObject>(object.data);
    const Transform pose{body.position, Rot::fromAngle(body.angle)};
    LevelShape& shape = body.shapes[static_cast<std::size_t>(end.shape)];
    std::vector<Vec2> added;
    for (const Vec2& point : points) {
        added.push_back(tidied(pose.toLocal(point)));
    }
    std::vector<Vec2>& vertices = *verticesOf(shape);
    if (end.first) {
        std::ranges::reverse(added);
        vertices.insert(vertices.begin(), added.begin(), added.end());
    } else {
        vertices.insert(vertices.end(), added.begin(), added.end());
    }
    if (closes && vertices.size() > 2) {
        closeChain(shape);
    }
    return withObject(std::move(level), std::move(object));
}

} // namespace spacetow
