#include "editor/editing/connector_ends.h"

#include "core/geometry/intersect.h"
#include "core/geometry/polygon.h"
#include "core/level/edits.h"
#include "core/level/groups.h"
#include "core/level/level_index.h"
#include "editor/editing/pick.h"

#include <algorithm>
#include <array>
#include <limits>

namespace spacetow {

namespace {

constexpr double bodyPixels = 6;    // how near a body is taken to be under the pointer
constexpr double anchorPixels = 10; // how far a node or a middle reaches

const BodyObject& bodyOf(const Level& level, Key key) {
    return std::get<BodyObject>(level.objects.find(key)->data);
}

bool isBody(const Level& level, Key key) {
    const Object* object = level.objects.find(key);
    return object != nullptr && std::holds_alternative<BodyObject>(object->data);
}

/// The point of the body nearest to `p`: itself where it lies in a polygon or a circle.
Vec2 nearestOn(const Level& level, Key key, const Vec2& p, double reach) {
    const BodyObject& body = bodyOf(level, key);
    const Transform pose{body.position, Rot::fromAngle(body.angle)};
    const Vec2 local = pose.toLocal(p);
    Vec2 nearest = p;
    double least = std::numeric_limits<double>::infinity();
    const auto offer = [&](const Vec2& at) {
        if ((at - p).norm() < least) {
            least = (at - p).norm();
            nearest = at;
        }
    };
    for (const LevelShape& shape : body.shapes) {
        const auto* polygon = std::get_if<Polygon>(&shape);
        const auto* circle = std::get_if<Circle>(&shape);
        const bool inside = (polygon != nullptr && contains(polygon->vertices, local)) ||
                            (circle != nullptr && (local - circle->center).norm() <= circle->radius);
        if (inside) {
            return p;
        }
        if (circle != nullptr) {
            offer(pose.toWorld(circle->center + (local - circle->center).normalized() * circle->radius));
        }
    }
    levelIndex(level).visitSegmentsOf(
        level.objects.indexOf(key), Aabb{p, p}.grown(reach),
        [&](const SegmentRef&, const Vec2& a, const Vec2& b) { offer(closestOnSegment(a, b, p)); });
    return nearest;
}

/// The nearest end of a connector that is there, within reach; of this body, or of any with 0.
std::optional<ConnectorEnd> anchorNear(const Level& level, Key wanted, const Vec2& p, double reach) {
    std::optional<ConnectorEnd> nearest;
    double least = reach;
    const auto offer = [&](Key key, const Vec2& anchor) {
        if ((wanted != 0 && key != wanted) || !isBody(level, key)) {
            return;
        }
        const BodyObject& body = bodyOf(level, key);
        const Vec2 at = Transform{body.position, Rot::fromAngle(body.angle)}.toWorld(anchor);
        if ((at - p).norm() <= least) {
            least = (at - p).norm();
            nearest = ConnectorEnd{key, tidied(at), SnapKind::Anchor};
        }
    };
    levelIndex(level).visitObjects(Aabb{p, p}.grown(reach), [&](int object) {
        if (const auto* connector = std::get_if<ConnectorObject>(&level.objects[object].data)) {
            offer(connector->a, connector->anchorA);
            offer(connector->b, connector->anchorB);
        }
    });
    return nearest;
}

/// The nearest node, anchor, middle of a circle, position or middle of the body within reach.
std::optional<ConnectorEnd> markedPoint(const Level& level, Key key, const Vec2& p, double reach) {
    const BodyObject& body = bodyOf(level, key);
    const Transform pose{body.position, Rot::fromAngle(body.angle)};
    const int index = level.objects.indexOf(key);
    std::optional<ConnectorEnd> nearest;
    double least = reach;
    const auto offer = [&](const Vec2& at, SnapKind kind) {
        if ((at - p).norm() <= least) {
            least = (at - p).norm();
            nearest = ConnectorEnd{key, tidied(at), kind};
        }
    };
    levelIndex(level).visitVerticesOf(index, Aabb{p, p}.grown(reach),
                                      [&](const VertexRef&, const Vec2& at) { offer(at, SnapKind::Vertex); });
    for (const LevelShape& shape : body.shapes) {
        if (const auto* circle = std::get_if<Circle>(&shape)) {
            offer(pose.toWorld(circle->center), SnapKind::Center);
        }
    }
    if (const std::optional<ConnectorEnd> anchor = anchorNear(level, key, p, reach)) {
        offer(anchor->at, SnapKind::Anchor);
    }
    if (body.kind != BodyKind::Static) {
        offer(body.position, SnapKind::Center);
        offer(levelIndex(level).boundsOf(index).center(), SnapKind::Center);
    }
    return nearest;
}

/// The anchor of a connector that stands off its body, as long as both can be picked.
std::optional<ConnectorEnd> looseAnchor(const ToolContext& context, const Pointer& pointer) {
    const Level& level = *context.edit.level;
    const auto end = anchorNear(level, 0, pointer.world, bodyPixels * pointer.pixel);
    if (!end) {
        return {};
    }
    const GroupTree tree(level);
    const Object& body = *level.objects.find(end->body);
    return tree.isVisible(body) && !tree.isLocked(body) ? end : std::nullopt;
}

} // namespace

std::optional<ConnectorEnd> connectorEndAt(const ToolContext& context, const Pointer& pointer) {
    const Level& level = *context.edit.level;
    const std::vector<Key> under = picked(level, pointer.world, bodyPixels * pointer.pixel);
    const auto body = std::ranges::find_if(under, [&](Key key) { return isBody(level, key); });
    if (body == under.end()) {
        return looseAnchor(context, pointer);
    }
    const double reach = anchorPixels * pointer.pixel;
    if (snaps(context.snap, pointer.modifiers)) {
        if (const std::optional<ConnectorEnd> marked = markedPoint(level, *body, pointer.world, reach)) {
            return marked;
        }
        const Vec2 onGrid = snapped(context.snap, pointer);
        if ((nearestOn(level, *body, onGrid, reach) - onGrid).norm() <= 1e-9) {
            return ConnectorEnd{*body, onGrid, SnapKind::Grid};
        }
    }
    const Vec2 nearest = nearestOn(level, *body, pointer.world, reach);
    return ConnectorEnd{*body, tidied(nearest), nearest == pointer.world ? SnapKind::None : SnapKind::Edge};
}

std::optional<SnapAnswer> snapAnswerOf(const std::optional<ConnectorEnd>& end) {
    return end ? std::optional(SnapAnswer{.point = end->at, .kind = end->kind, .mark = end->at, .key = end->body})
               : std::nullopt;
}

bool isOnOtherThing(const ToolContext& context, const Pointer& pointer) {
    const Level& level = *context.edit.level;
    const std::vector<Key> under = picked(level, pointer.world, bodyPixels * pointer.pixel);
    return std::ranges::any_of(under, [&](Key key) {
        const ObjectData& data = level.objects.find(key)->data;
        return !std::holds_alternative<BodyObject>(data) && !std::holds_alternative<ConnectorObject>(data);
    });
}

ConnectorFault faultBetween(const Level& level, Key a, Key b) {
    if (a == b) {
        return ConnectorFault::SameBody;
    }
    const bool moves = std::ranges::any_of(
        std::array{a, b}, [&](Key key) { return isBody(level, key) && bodyOf(level, key).kind == BodyKind::Dynamic; });
    return moves ? ConnectorFault::None : ConnectorFault::NothingMoves;
}

Edit withConnector(const ToolContext& context, const ConnectorEnd& a, const ConnectorEnd& b) {
    const Level& level = *context.edit.level;
    const auto local = [&](const ConnectorEnd& end) -> Vec2 {
        const BodyObject& body = bodyOf(level, end.body);
        return tidied(Transform{body.position, Rot::fromAngle(body.angle)}.toLocal(end.at));
    };
    ConnectorObject connector;
    connector.a = a.body;
    connector.b = b.body;
    connector.anchorA = local(a);
    connector.anchorB = local(b);
    Object object;
    object.key = freshKey(level, context.seed);
    object.data = std::move(connector);
    const Key key = object.key;
    return {std::make_shared<const Level>(added(level, std::move(object))), Selection({key})};
}

} // namespace spacetow
