#include "core/level/edits.h"

#include "core/base/random.h"
#include "core/level/key_index.h"
#include "core/math/rot.h"

#include <algorithm>
#include <map>
#include <numbers>
#include <set>

namespace spacetow {

namespace {

std::vector<Key> sorted(std::span<const Key> keys) {
    std::vector<Key> result(keys.begin(), keys.end());
    std::ranges::sort(result);
    return result;
}

/// `change(data)` is applied to a copy of the data of each object named by `keys`.
template <class Change>
Level changed(Level level, std::span<const Key> keys, Change change) {
    const std::vector<Key> wanted = sorted(keys);
    for (int i = 0; i < level.objects.size(); ++i) {
        if (std::ranges::binary_search(wanted, level.objects[i].key)) {
            Object object = level.objects[i];
            change(object.data);
            level.objects.replace(i, std::move(object));
        }
    }
    return level;
}

void move(ObjectData& data, const Vec2& delta) {
    if (auto* body = std::get_if<BodyObject>(&data)) {
        body->position += delta;
    } else if (auto* ship = std::get_if<ShipObject>(&data)) {
        ship->position += delta;
    } else if (auto* payload = std::get_if<PayloadObject>(&data)) {
        payload->position += delta;
    } else if (auto* finish = std::get_if<FinishObject>(&data)) {
        finish->a += delta;
        finish->b += delta;
    }
}

void reverse(LevelShape& shape) {
    const auto turnRound = [](std::vector<Vec2>& vertices, bool closed) {
        // A closed chain keeps its first vertex, so that turning it twice is no change.
        std::reverse(vertices.begin() + (closed && !vertices.empty() ? 1 : 0), vertices.end());
    };
    if (auto* edges = std::get_if<EdgeChain>(&shape)) {
        turnRound(edges->vertices, edges->closed);
    } else if (auto* lines = std::get_if<LineChain>(&shape)) {
        turnRound(lines->vertices, lines->closed);
    }
}

/// −1 unless the data is one of the kinds of which a level has one.
int singleKind(const ObjectData& data) {
    const bool single = std::holds_alternative<ShipObject>(data) || std::holds_alternative<PayloadObject>(data) ||
                        std::holds_alternative<FinishObject>(data);
    return single ? static_cast<int>(data.index()) : -1;
}

int indexOfKind(const Level& level, int kind) {
    for (int i = 0; i < level.objects.size(); ++i) {
        if (static_cast<int>(level.objects[i].data.index()) == kind) {
            return i;
        }
    }
    return -1;
}

/// Gives out keys that a level does not have, for many objects at once.
class KeySource {
  public:
    KeySource(const Level& level, std::uint64_t seed) : m_random(seed) {
        for (const Object& object : level.objects) {
            m_taken.insert(object.key);
        }
    }
    Key next() {
        Key key = m_random.next();
        while (key == 0 || !m_taken.insert(key).second) {
            key = m_random.next();
        }
        return key;
    }

  private:
    Random m_random;
    std::set<Key> m_taken;
};

} // namespace

Level added(Level level, Object object) {
    EXPECTS(object.key != 0);
    const int kind = singleKind(object.data);
    const int present = kind < 0 ? -1 : indexOfKind(level, kind);
    if (present >= 0) {
        Object replacement = level.objects[present];
        replacement.data = std::move(object.data);
        level.objects.replace(present, std::move(replacement));
    } else {
        EXPECTS(level.objects.find(object.key) == nullptr);
        level.objects.append(std::move(object));
    }
    return level;
}

Level removed(Level level, std::span<const Key> keys) {
    const std::vector<Key> gone = sorted(keys);
    const auto isGone = [&gone](Key key) { return std::ranges::binary_search(gone, key); };
    level.objects.eraseIf([&isGone](const Object& object) {
        const auto* connector = std::get_if<ConnectorObject>(&object.data);
        return isGone(object.key) || (connector != nullptr && (isGone(connector->a) || isGone(connector->b)));
    });
    return level;
}

Level moved(Level level, std::span<const Key> keys, const Vec2& delta) {
    return changed(std::move(level), keys, [&delta](ObjectData& data) { move(data, delta); });
}

Level rotated(Level level, std::span<const Key> keys, const Vec2& pivot, double radians) {
    const Rot turn = Rot::fromAngle(radians);
    const auto turned = [&](const Vec2& point) -> Vec2 { return pivot + turn * (point - pivot); };
    const auto wrapped = [radians](double angle) { return std::remainder(angle + radians, 2 * std::numbers::pi); };
    return changed(std::move(level), keys, [&](ObjectData& data) {
        if (auto* body = std::get_if<BodyObject>(&data)) {
            body->position = turned(body->position);
            body->angle = wrapped(body->angle);
        } else if (auto* ship = std::get_if<ShipObject>(&data)) {
            ship->position = turned(ship->position);
            ship->angle = wrapped(ship->angle);
        } else if (auto* payload = std::get_if<PayloadObject>(&data)) {
            payload->position = turned(payload->position);
        } else if (auto* finish = std::get_if<FinishObject>(&data)) {
            finish->a = turned(finish->a);
            finish->b = turned(finish->b);
        }
    });
}

Level reversed(Level level, std::span<const Key> keys) {
    return changed(std::move(level), keys, [](ObjectData& data) {
        if (auto* body = std::get_if<BodyObject>(&data)) {
            std::ranges::for_each(body->shapes, reverse);
        }
    });
}

Level duplicated(Level level, std::span<const Key> keys, const CopyPlace& place, std::vector<Key>& copies) {
    const KeyIndex index(level.objects);
    std::vector<Object> originals;
    for (const Key key : keys) {
        const Object* object = index.find(key);
        if (object != nullptr && singleKind(object->data) < 0) {
            originals.push_back(*object);
        }
    }
    return pasted(std::move(level), originals, place, copies);
}

Level pasted(Level level, const std::vector<Object>& objects, const CopyPlace& place, std::vector<Key>& copies) {
    KeySource source(level, place.seed);
    std::map<Key, Key> copyOf;
    for (const Object& object : objects) {
        if (std::holds_alternative<BodyObject>(object.data)) {
            copyOf.emplace(object.key, source.next());
        }
    }
    copies.clear();
    for (const Object& object : objects) {
        Object copy = object;
        if (auto* connector = std::get_if<ConnectorObject>(&copy.data)) {
            const auto a = copyOf.find(connector->a);
            const auto b = copyOf.find(connector->b);
            if (a == copyOf.end() || b == copyOf.end()) {
                continue;
            }
            connector->a = a->second;
            connector->b = b->second;
        }
        const int kind = singleKind(copy.data);
        if (kind >= 0 && indexOfKind(level, kind) >= 0) {
            continue;
        }
        const auto planned = copyOf.find(object.key);
        copy.key = planned != copyOf.end() ? planned->second : source.next();
        move(copy.data, place.delta);
        copies.push_back(copy.key);
        level.objects.append(std::move(copy));
    }
    return level;
}

Level withObject(Level level, Object object) {
    const int index = level.objects.indexOf(object.key);
    EXPECTS(index >= 0);
    level.objects.replace(index, std::move(object));
    return level;
}

Level renamed(Level level, Key key, std::string name) {
    const int index = level.objects.indexOf(key);
    if (index >= 0) {
        Object object = level.objects[index];
        object.name = std::move(name);
        level.objects.replace(index, std::move(object));
    }
    return level;
}

Level withTag(Level level, int index, TagInfo info) {
    EXPECTS(index >= 0 && index < TagTable::size);
    level.tags.set(index, std::move(info));
    return level;
}

} // namespace spacetow
