#include "editor/editing/node_pick.h"

#include "core/geometry/intersect.h"
#include "core/level/groups.h"
#include "core/level/level_index.h"
#include "core/level/node_edits.h"

#include <algorithm>

namespace spacetow {

std::vector<Key> keysInEdit(const Edit& edit) {
    if (edit.selection.empty()) {
        return {};
    }
    const GroupTree tree(*edit.level);
    std::vector<Key> keys = withMembers(*edit.level, edit.selection.keys());
    std::erase_if(keys, [&](Key key) {
        const Object* object = edit.level->objects.find(key);
        return object == nullptr || !hasNodes(object->data) || !tree.isVisible(*object) || tree.isLocked(*object);
    });
    return keys;
}

bool hasNodes(const ObjectData& data) {
    if (std::holds_alternative<FinishObject>(data)) {
        return true;
    }
    const auto* body = std::get_if<BodyObject>(&data);
    return body != nullptr &&
           std::ranges::any_of(body->shapes, [](const LevelShape& shape) { return verticesOf(shape) != nullptr; });
}

std::optional<Hit> nodeHit(const Level& level, const PickQuery& query) {
    const LevelIndex& index = levelIndex(level);
    const Aabb box = Aabb{query.point, query.point}.grown(query.tolerance);
    std::optional<Hit> nearest;
    const auto offer = [&](const Hit& hit) {
        if (hit.distance <= query.tolerance && (!nearest || hit.distance < nearest->distance)) {
            nearest = hit;
        }
    };
    std::vector<int> places;
    for (const Key key : query.nodesOf) {
        const int object = level.objects.indexOf(key);
        if (object >= 0 && index.boundsOf(object).overlaps(box)) {
            places.push_back(object);
        }
    }
    for (const int object : places) {
        index.visitVerticesOf(object, box, [&](const VertexRef& ref, const Vec2& at) {
            offer({HitKind::Node, level.objects[object].key, ref.shape, ref.vertex, tidied(at),
                   (at - query.point).norm()});
        });
    }
    if (nearest) {
        return nearest;
    }
    for (const int object : places) {
        index.visitSegmentsOf(object, box, [&](const SegmentRef& ref, const Vec2& a, const Vec2& b) {
            const Vec2 at = closestOnSegment(a, b, query.point);
            offer({HitKind::Segment, level.objects[object].key, ref.shape, ref.segment, at, (at - query.point).norm()});
        });
    }
    return nearest;
}

std::vector<NodeRef> nodesIn(const Level& level, std::span<const Key> keys, const Aabb& box) {
    std::vector<NodeRef> nodes;
    for (const Key key : keys) {
        const int object = level.objects.indexOf(key);
        if (object >= 0) {
            levelIndex(level).visitVerticesOf(object, box, [&](const VertexRef& ref, const Vec2&) {
                nodes.push_back({key, ref.shape, ref.vertex});
            });
        }
    }
    std::ranges::sort(nodes);
    return nodes;
}

std::vector<NodeRef> endsOf(const Level& level, const Hit& segment) {
    const NodeRef from = nodeOf(segment);
    NodeRef to = from;
    ++to.vertex;
    if (!nodePosition(level, to)) {
        to.vertex = 0;
    }
    return {std::min(from, to), std::max(from, to)};
}

std::optional<Vec2> placeOn(const Level& level, const Hit& segment, const Vec2& snapped) {
    const std::vector<NodeRef> ends = endsOf(level, segment);
    const std::optional<Vec2> a = nodePosition(level, ends[0]);
    const std::optional<Vec2> b = nodePosition(level, ends[1]);
    if (!a || !b || !std::holds_alternative<BodyObject>(level.objects.find(segment.key)->data)) {
        return {};
    }
    for (const Vec2& wish : {snapped, segment.at}) {
        const Vec2 at = tidied(closestOnSegment(*a, *b, wish));
        if (at != *a && at != *b) {
            return at;
        }
    }
    return {};
}

std::vector<NodeRef> withCompany(const Level& level, const std::vector<NodeRef>& nodes) {
    std::vector<Vec2> places;
    for (const NodeRef& node : nodes) {
        if (const std::optional<Vec2> at = nodePosition(level, node)) {
            places.push_back(*at);
        }
    }
    std::vector<NodeRef> all = nodesAt(level, places);
    all.insert(all.end(), nodes.begin(), nodes.end());
    std::ranges::sort(all);
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
}

Aabb boundsOfNodes(const Level& level, std::span<const NodeRef> nodes) {
    Aabb box;
    for (const NodeRef& node : nodes) {
        if (const std::optional<Vec2> at = nodePosition(level, node)) {
            box.include(*at);
        }
    }
    return box;
}

} // namespace spacetow
