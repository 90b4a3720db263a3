#include "editor/editing/pick.h"

#include "core/geometry/intersect.h"
#include "core/level/bounds.h"
#include "core/level/groups.h"
#include "core/level/nodes.h"
#include "core/level/outline.h"

#include <algorithm>
#include <tuple>

namespace spacetow {

namespace {

/// Things that move or are aimed for are picked before the walls behind them.
int rankOf(const Object& object) {
    if (std::holds_alternative<ShipObject>(object.data) || std::holds_alternative<PayloadObject>(object.data)) {
        return 0;
    }
    const auto* body = std::get_if<BodyObject>(&object.data);
    return body && body->kind == BodyKind::Static ? 2 : 1;
}

bool isFar(const Object& object, const PickQuery& query) {
    // Empty for connectors, of which only the outline can tell.
    const Aabb rough = ownBounds(object.data);
    return !rough.isEmpty() && !rough.grown(query.tolerance).contains(query.point);
}

void addNodes(std::vector<Hit>& hits, const Object& object, const PickQuery& query) {
    for (const NodePath& path : nodePaths(object.data)) {
        for (std::size_t i = 0; i < path.points.size(); ++i) {
            const double distance = (path.points[i] - query.point).norm();
            if (distance <= query.tolerance) {
                hits.push_back({HitKind::Node, object.key, path.shape, static_cast<int>(i), path.points[i], distance});
            }
        }
        for (int i = 0; i < path.segments(); ++i) {
            const Vec2 at = closestOnSegment(path.points[static_cast<std::size_t>(i)], path.end(i), query.point);
            const double distance = (at - query.point).norm();
            if (distance <= query.tolerance) {
                hits.push_back({HitKind::Segment, object.key, path.shape, i, at, distance});
            }
        }
    }
}

} // namespace

std::vector<Hit> hits(const Level& level, const PickQuery& query) {
    std::vector<Hit> found;
    if (!query.nodesOf.empty()) {
        const GroupTree tree(level);
        for (const Object& object : level.objects) {
            if (std::ranges::binary_search(query.nodesOf, object.key) && !isFar(object, query) &&
                tree.isVisible(object) && !tree.isLocked(object)) {
                addNodes(found, object, query);
            }
        }
        std::ranges::stable_sort(found, [](const Hit& a, const Hit& b) {
            return std::tuple(a.kind, a.distance) < std::tuple(b.kind, b.distance);
        });
    }
    for (const Key key : picked(level, query.point, query.tolerance)) {
        found.push_back({HitKind::Object, key, -1, -1, query.point, 0});
    }
    return found;
}

std::vector<Key> picked(const Level& level, const Vec2& point, double tolerance) {
    using Candidate = std::tuple<int, double, int, Key>; // rank, size, minus the place in the level
    std::vector<Candidate> candidates;
    const Outlines outlines(level);
    const GroupTree tree(level);
    int index = 0;
    for (const Object& object : level.objects) {
        ++index;
        if (isFar(object, {point, tolerance}) || !tree.isVisible(object) || tree.isLocked(object)) {
            continue;
        }
        const Outline outline = outlines.of(object);
        if (distanceTo(outline, point) <= tolerance) {
            candidates.emplace_back(rankOf(object), boundsOf(outline).size().norm(), -index, object.key);
        }
    }
    std::sort(candidates.begin(), candidates.end());
    std::vector<Key> keys;
    keys.reserve(candidates.size());
    for (const Candidate& candidate : candidates) {
        keys.push_back(std::get<Key>(candidate));
    }
    return keys;
}

std::vector<Key> pickedIn(const Level& level, const Aabb& box, bool wholly) {
    std::vector<Key> keys;
    const Outlines outlines(level);
    const GroupTree tree(level);
    for (const Object& object : level.objects) {
        const Aabb rough = ownBounds(object.data);
        if ((!rough.isEmpty() && !rough.overlaps(box)) || !tree.isVisible(object) || tree.isLocked(object)) {
            continue;
        }
        if (!rough.isEmpty() && box.contains(rough)) {
            keys.push_back(object.key);
            continue;
        }
        const Outline outline = outlines.of(object);
        const Aabb exact = boundsOf(outline);
        if (wholly ? !exact.isEmpty() && box.contains(exact) : touches(outline, box)) {
            keys.push_back(object.key);
        }
    }
    return keys;
}

} // namespace spacetow
