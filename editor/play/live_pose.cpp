#include "editor/play/live_pose.h"

#include "core/geometry/bounds.h"
#include "core/level/groups.h"
#include "core/level/object_geometry.h"

#include <algorithm>
#include <optional>
#include <unordered_map>

namespace spacetow {
namespace {

using Poses = std::unordered_map<Key, Transform>;

/// Of those that objects have become.
Poses posesOf(const BodyPictures& bodies) {
    Poses poses;
    for (const BodyPicture& body : bodies) {
        if (body.look->key != 0 && body.look->role != BodyRole::Debris) {
            poses.emplace(body.look->key, body.pose);
        }
    }
    return poses;
}

void place(ObjectData& data, const Transform& pose) {
    if (auto* body = std::get_if<BodyObject>(&data)) {
        body->position = pose.position;
        body->angle = pose.rotation.angle();
    } else if (auto* ship = std::get_if<ShipObject>(&data)) {
        ship->position = pose.position;
        ship->angle = pose.rotation.angle();
    } else if (auto* payload = std::get_if<PayloadObject>(&data)) {
        payload->position = pose.position;
    }
}

bool isBodyThatMoves(const ObjectData& data) {
    const auto* body = std::get_if<BodyObject>(&data);
    return (body != nullptr && body->kind != BodyKind::Static) || std::holds_alternative<ShipObject>(data) ||
           std::holds_alternative<PayloadObject>(data);
}

bool isNear(const BodyPicture& body, const Aabb& box) {
    return std::ranges::any_of(body.look->shapes,
                               [&](const Shape& shape) { return boundsOf(shape, body.pose).overlaps(box); });
}

std::vector<Key> withEnds(const Level& level, std::vector<Key> keys) {
    const std::size_t before = keys.size();
    for (std::size_t i = 0; i < before; ++i) {
        const Object* const object = level.objects.find(keys[i]);
        const auto* connector = object != nullptr ? std::get_if<ConnectorObject>(&object->data) : nullptr;
        if (connector != nullptr) {
            keys.insert(keys.end(), {connector->a, connector->b});
        }
    }
    return keys;
}

} // namespace

Level posed(const Level& level, const Snapshot& snapshot) {
    const Poses poses = posesOf(snapshot.moving);
    std::optional<Poses> standing; // of bodies that have been made to move since
    const auto poseOf = [&](Key key) -> std::optional<Transform> {
        if (const auto moving = poses.find(key); moving != poses.end()) {
            return moving->second;
        }
        if (!standing) {
            standing = posesOf(*snapshot.statics);
        }
        const auto found = standing->find(key);
        return found != standing->end() ? std::optional(found->second) : std::nullopt;
    };
    Level now = level;
    std::vector<Key> gone;
    for (int i = 0; i < level.objects.size(); ++i) {
        if (!isBodyThatMoves(level.objects[i].data)) {
            continue;
        }
        Object object = level.objects[i];
        if (const std::optional<Transform> pose = poseOf(object.key)) {
            place(object.data, *pose);
            now.objects.replace(i, std::move(object));
        } else {
            gone.push_back(object.key);
        }
    }
    if (!gone.empty()) {
        std::ranges::sort(gone);
        now.objects.eraseIf([&](const Object& object) { return std::ranges::binary_search(gone, object.key); });
    }
    return now;
}

Level posed(const ShownLevel& levels, const Snapshot& snapshot, std::span<const Key> keys) {
    const Level& level = levels.shown;
    std::vector<Key> all = withMembers(level, keys);
    all.insert(all.end(), keys.begin(), keys.end());
    Level few;
    for (const int index : level.objects.indicesOf(withEnds(level, std::move(all)))) {
        few.objects.append(level.objects[index]);
    }
    Level now = posed(few, snapshot);
    for (int i = 0; i < now.objects.size() && &levels.shown != &levels.current; ++i) {
        Object object = now.objects[i];
        const Object* const before = levels.current.objects.find(object.key);
        const std::optional<Vec2> from = before != nullptr ? placeOf(before->data) : std::nullopt;
        const std::optional<Vec2> to = placeOf(level.objects.find(object.key)->data);
        if (from && to && isBodyThatMoves(object.data)) {
            move(object.data, *to - *from);
            now.objects.replace(i, std::move(object));
        }
    }
    return now;
}

Level standing(const Level& level) {
    Level still = level;
    still.objects.eraseIf([](const Object& object) {
        return isBodyThatMoves(object.data) || std::holds_alternative<ConnectorObject>(object.data);
    });
    return still;
}

// NOLINTNEXTLINE(bugprone-easily-swappable-parameters): all of the level, and a part of it
Level posedNear(const Level& level, const Level& standing, const Snapshot& snapshot, const Aabb& box) {
    std::vector<Key> keys;
    for (const BodyPicture& body : snapshot.moving) {
        if (body.look->key != 0 && body.look->role != BodyRole::Debris && isNear(body, box)) {
            keys.push_back(body.look->key);
        }
    }
    for (const Object& object : level.objects) {
        if (std::holds_alternative<ConnectorObject>(object.data)) {
            keys.push_back(object.key);
        }
    }
    std::ranges::sort(keys);
    Level now = standing;
    const Level moving = posed(ShownLevel{level, level}, snapshot, keys);
    for (const Object& object : moving.objects) {
        if (now.objects.find(object.key) == nullptr) {
            now.objects.append(object);
        }
    }
    return now;
}

} // namespace spacetow
