#include "core/level/bounds.h"

#include "core/level/groups.h"
#include "core/level/key_index.h"
#include "core/level/object_geometry.h"

#include <algorithm>
#include <array>

namespace spacetow {

namespace {

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
    const auto* connector = std::get_if<ConnectorObject>(&object.data);
    return connector == nullptr ? ownBounds(object.data)
                                : boundsOfConnector(*connector, find(connector->a), find(connector->b));
}

} // namespace

Aabb boundsOf(const Level& level, const Object& object) {
    if (std::holds_alternative<GroupObject>(object.data)) {
        return boundsOf(level, std::array{object.key});
    }
    return boundsWith(object, [&level](Key key) { return level.objects.find(key); });
}

Aabb boundsOf(const Level& level, std::span<const Key> keys) {
    const std::vector<Key> wanted = withMembers(level, keys);
    const KeyIndex index(level.objects);
    Aabb box;
    for (const Object& object : level.objects) {
        if (std::ranges::binary_search(wanted, object.key)) {
            box.include(boundsWith(object, [&index](Key key) { return index.find(key); }));
        }
    }
    return box;
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
