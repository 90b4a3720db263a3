#include "editor/editing/pick.h"

#include "core/base/overloaded.h"
#include "core/geometry/intersect.h"
#include "core/geometry/polygon.h"
#include "core/level/groups.h"
#include "core/level/level_index.h"

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

Aabb around(const Vec2& point, double reach) {
    return Aabb{point, point}.grown(reach);
}

bool mayBePicked(const GroupTree& tree, const Object& object) {
    return tree.isVisible(object) && !tree.isLocked(object);
}

/// Whether the point is inside a polygon that the object fills, or `meets(disc)` holds for a disc of it, in the world.
template <class Meets>
bool fills(const Object& object, const Vec2& point, Meets meets) {
    const std::optional<Transform> pose = poseOf(object);
    const auto inDisc = [&](const Circle& disc) { return meets(Circle{pose->toWorld(disc.center), disc.radius}); };
    const auto inOutline = [&](std::vector<Vec2> outline) {
        for (Vec2& vertex : outline) {
            vertex = pose->toWorld(vertex);
        }
        return contains(outline, point);
    };
    const auto inShape = [&](const LevelShape& shape) {
        return std::visit(Overloaded{[](const EdgeChain&) { return false; }, [](const LineChain&) { return false; },
                                     [&](const Polygon& polygon) { return inOutline(polygon.vertices); },
                                     [&](const Circle& circle) { return inDisc(circle); }},
                          shape);
    };
    return std::visit(Overloaded{[&](const BodyObject& body) { return std::ranges::any_of(body.shapes, inShape); },
                                 [&](const ShipObject&) {
                                     const auto hull = shipOutline();
                                     return inOutline({hull.begin(), hull.end()});
                                 },
                                 [&](const PayloadObject& payload) {
                                     return inDisc({{0, 0}, payload.radius});
                                 },
                                 [](const FinishObject&) { return false; },
                                 [](const ConnectorObject&) { return false; },
                                 [](const GroupObject&) { return false; }},
                      object.data);
}

bool isNear(const LevelIndex& index, int place, const Vec2& point, double tolerance) {
    bool near = false;
    index.visitSegmentsOf(place, around(point, tolerance), [&](const SegmentRef&, const Vec2& a, const Vec2& b) {
        near = near || (closestOnSegment(a, b, point) - point).norm() <= tolerance;
    });
    return near || fills(index.objects()[place], point,
                         [&](const Circle& disc) { return (disc.center - point).norm() - disc.radius <= tolerance; });
}

bool touchesBox(const LevelIndex& index, int place, const Aabb& box) {
    bool touches = false;
    index.visitSegmentsOf(place, box, [&](const SegmentRef&, const Vec2&, const Vec2&) { touches = true; });
    // With no side in the box, either all of the box lies inside an outline or nothing of it.
    return touches || fills(index.objects()[place], box.center(), [&](const Circle& disc) {
               const Vec2 nearest = disc.center.cwiseMax(box.min).cwiseMin(box.max);
               return (nearest - disc.center).norm() <= disc.radius;
           });
}

} // namespace

std::vector<Key> picked(const Level& level, const Vec2& point, double tolerance) {
    using Candidate = std::tuple<int, double, int, Key>; // rank, size, minus the place in the level
    std::vector<Candidate> candidates;
    const LevelIndex& index = levelIndex(level);
    const GroupTree tree(level);
    index.visitObjects(around(point, tolerance), [&](int place) {
        const Object& object = level.objects[place];
        if (mayBePicked(tree, object) && isNear(index, place, point, tolerance)) {
            candidates.emplace_back(rankOf(object), index.boundsOf(place).size().norm(), -place, object.key);
        }
    });
    std::sort(candidates.begin(), candidates.end());
    std::vector<Key> keys;
    keys.reserve(candidates.size());
    for (const Candidate& candidate : candidates) {
        keys.push_back(std::get<Key>(candidate));
    }
    return keys;
}

bool isLockedAt(const Level& level, const Vec2& point, double tolerance) {
    const LevelIndex& index = levelIndex(level);
    const GroupTree tree(level);
    bool found = false;
    index.visitObjects(around(point, tolerance), [&](int place) {
        const Object& object = level.objects[place];
        found = found || (tree.isLocked(object) && tree.isVisible(object) && isNear(index, place, point, tolerance));
    });
    return found;
}

std::vector<Key> pickedIn(const Level& level, const Aabb& box, bool wholly) {
    std::vector<Key> keys;
    const LevelIndex& index = levelIndex(level);
    const GroupTree tree(level);
    index.visitObjects(box, [&](int place) {
        const Object& object = level.objects[place];
        const bool inside = box.contains(index.boundsOf(place));
        if ((inside || (!wholly && touchesBox(index, place, box))) && mayBePicked(tree, object)) {
            keys.push_back(object.key);
        }
    });
    return keys;
}

} // namespace spacetow
