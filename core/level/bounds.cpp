#include "core/level/bounds.h"

#include "core/level/key_index.h"
#include "core/math/transform.h"

namespace spacetow {

namespace {

void include(Aabb& box, const LevelShape& shape, const Transform& pose) {
    if (const auto* circle = std::get_if<Circle>(&shape)) {
        const Vec2 center = pose.toWorld(circle->center);
        const Vec2 reach(circle->radius, circle->radius);
        box.include(Aabb{center - reach, center + reach});
        return;
    }
    const auto includeVertices = [&](const std::vector<Vec2>& vertices) {
        for (const Vec2& vertex : vertices) {
            box.include(pose.toWorld(vertex));
        }
    };
    if (const auto* edges = std::get_if<EdgeChain>(&shape)) {
        includeVertices(edges->vertices);
    } else if (const auto* lines = std::get_if<LineChain>(&shape)) {
        includeVertices(lines->vertices);
    } else {
        includeVertices(std::get<Polygon>(shape).vertices);
    }
}

Aabb boundsOfConnector(const ConnectorObject& connector, const Object* a, const Object* b) {
    Aabb box;
    const auto* bodyA = a == nullptr ? nullptr : std::get_if<BodyObject>(&a->data);
    const auto* bodyB = b == nullptr ? nullptr : std::get_if<BodyObject>(&b->data);
    if (bodyA != nullptr && bodyB != nullptr) {
        box.include(Transform{bodyA->position, Rot::fromAngle(bodyA->angle)}.toWorld(connector.anchorA));
        box.include(Transform{bodyB->position, Rot::fromAngle(bodyB->angle)}.toWorld(connector.anchorB));
    }
    return box;
}

/// `find(key)` gives the object or null.
template <class Find>
Aabb boundsWith(const Object& object, const Find& find) {
    Aabb box;
    if (const auto* body = std::get_if<BodyObject>(&object.data)) {
        const Transform pose{body->position, Rot::fromAngle(body->angle)};
        for (const LevelShape& shape : body->shapes) {
            include(box, shape, pose);
        }
    } else if (const auto* ship = std::get_if<ShipObject>(&object.data)) {
        const Transform pose{ship->position, Rot::fromAngle(ship->angle)};
        for (const Vec2& corner : shipOutline()) {
            box.include(pose.toWorld(corner));
        }
    } else if (const auto* payload = std::get_if<PayloadObject>(&object.data)) {
        include(box, Circle{payload->position, payload->radius}, {});
    } else if (const auto* finish = std::get_if<FinishObject>(&object.data)) {
        box.include(finish->a);
        box.include(finish->b);
    } else {
        const auto& connector = std::get<ConnectorObject>(object.data);
        box = boundsOfConnector(connector, find(connector.a), find(connector.b));
    }
    return box;
}

} // namespace

Aabb boundsOf(const Level& level, const Object& object) {
    return boundsWith(object, [&level](Key key) { return level.objects.find(key); });
}

Aabb boundsOf(const Level& level) {
    const KeyIndex index(level.objects);
    Aabb box;
    for (const Object& object : level.objects) {
        box.include(boundsWith(object, [&index](Key key) { return index.find(key); }));
    }
    return box;
}

} // namespace spacetow
