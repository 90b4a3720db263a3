#include "core/level/edits.h"

#include "core/base/random.h"
#include "core/level/groups.h"
#include "core/level/level_index.h"
#include "core/level/object_geometry.h"

#include <algorithm>
#include <map>
#include <set>

namespace spacetow {

namespace {

/// `change(data)` or `change(data, key)` is applied to a copy of the data of each object named by `keys`, ascending.
template <class Change>
Level changed(Level level, const std::vector<Key>& keys, Change change) {
    for (const int place : level.objects.indicesOf(keys)) {
        Object object = level.objects[place];
        if constexpr (requires { change(object.data, object.key); }) {
            change(object.data, object.key);
        } else {
            change(object.data);
        }
        level.objects.replace(place, std::move(object));
    }
    return level;
}

/// The anchors of connectors on these bodies go with the bodies' coordinates.
Level withMappedAnchors(Level level, std::vector<std::pair<Key, Affine>> bodies) {
    std::ranges::sort(bodies, {}, &std::pair<Key, Affine>::first);
    const auto mapAnchor = [&bodies](Key body, Vec2& anchor) {
        const auto found = std::ranges::lower_bound(bodies, body, {}, &std::pair<Key, Affine>::first);
        if (found != bodies.end() && found->first == body) {
            anchor = tidied(found->second(anchor));
        }
    };
    const std::vector<int> connectors = levelIndex(level).connectors();
    for (const int place : connectors) {
        Object object = level.objects[place];
        auto& connector = std::get<ConnectorObject>(object.data);
        mapAnchor(connector.a, connector.anchorA);
        mapAnchor(connector.b, connector.anchorB);
        if (!(object == level.objects[place])) {
            level.objects.replace(place, std::move(object));
        }
    }
    return level;
}

/// Groups, but no layers, whose last member is among those that go.
std::vector<Key> emptiedGroups(const Level& level, const std::vector<Key>& gone) {
    const std::vector<int>& groups = levelIndex(level).groups();
    if (groups.empty()) {
        return {};
    }
    std::vector<Key> lost; // have had a member
    std::vector<Key> kept; // still have one
    for (const Object& object : level.objects) {
        if (object.parent != 0) {
            (std::ranges::binary_search(gone, object.key) ? lost : kept).push_back(object.parent);
        }
    }
    std::ranges::sort(lost);
    std::ranges::sort(kept);
    std::vector<Key> emptied;
    for (const int place : groups) {
        const Object& group = level.objects[place];
        if (!std::get<GroupObject>(group.data).layer && std::ranges::binary_search(lost, group.key) &&
            !std::ranges::binary_search(kept, group.key)) {
            emptied.push_back(group.key);
        }
    }
    return emptied;
}

void reverseShape(LevelShape& shape) {
    if (auto* edges = std::get_if<EdgeChain>(&shape)) {
        reverse(edges->vertices, edges->closed);
    } else if (auto* lines = std::get_if<LineChain>(&shape)) {
        reverse(lines->vertices, lines->closed);
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
    KeySource(const Level& level, std::uint64_t seed) : m_objects(level.objects), m_random(seed) {}
    Key next() {
        Key key = m_random.next();
        while (key == 0 || m_objects.find(key) != nullptr || !m_given.insert(key).second) {
            key = m_random.next();
        }
        return key;
    }

  private:
    ObjectList m_objects;
    Random m_random;
    std::set<Key> m_given;
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
    std::vector<Key> gone = withMembers(level, keys);
    const auto isGone = [&gone](Key key) { return std::ranges::binary_search(gone, key); };
    const std::vector<Key> emptied = emptiedGroups(level, gone);
    gone.insert(gone.end(), emptied.begin(), emptied.end());
    std::ranges::sort(gone);
    level.objects.eraseIf([&isGone](const Object& object) {
        const auto* connector = std::get_if<ConnectorObject>(&object.data);
        return isGone(object.key) || (connector != nullptr && (isGone(connector->a) || isGone(connector->b)));
    });
    return level;
}

Level moved(Level level, std::span<const Key> keys, const Vec2& delta) {
    const std::vector<Key> wanted = withMembers(level, keys);
    return changed(std::move(level), wanted, [&delta](ObjectData& data) { move(data, delta); });
}

Level transformed(Level level, std::span<const Key> keys, const Affine& map) {
    EXPECTS(map.determinant() != 0);
    const std::vector<Key> wanted = withMembers(level, keys);
    std::vector<std::pair<Key, Affine>> bodies; // whose own coordinates are mapped, ascending by key
    level = changed(std::move(level), wanted, [&](ObjectData& data, Key key) {
        if (const auto* body = std::get_if<BodyObject>(&data)) {
            const Affine local = localMap(*body, map);
            if (local.x != Vec2(1, 0) || local.y != Vec2(0, 1)) {
                bodies.emplace_back(key, local);
            }
        }
        transform(data, map);
    });
    return bodies.empty() ? level : withMappedAnchors(std::move(level), std::move(bodies));
}

Level rotated(Level level, std::span<const Key> keys, const Vec2& pivot, double radians) {
    return transformed(std::move(level), keys, Affine::rotation(pivot, radians));
}

Level reversed(Level level, std::span<const Key> keys) {
    const std::vector<Key> wanted = withMembers(level, keys);
    return changed(std::move(level), wanted, [](ObjectData& data) {
        if (auto* body = std::get_if<BodyObject>(&data)) {
            for (LevelShape& shape : body->shapes) {
                reverseShape(shape);
            }
        }
    });
}

Level duplicated(Level level, std::span<const Key> keys, const CopyPlace& place, std::vector<Key>& copies) {
    const std::vector<Key> wanted = withMembers(level, keys);
    std::vector<Object> originals;
    for (const int index : level.objects.indicesOf(wanted)) {
        if (singleKind(level.objects[index].data) < 0) {
            originals.push_back(level.objects[index]);
        }
    }
    CopyPlace beside = place;
    beside.keepParents = true;
    return pasted(std::move(level), originals, beside, copies);
}

Level pasted(Level level, const std::vector<Object>& objects, const CopyPlace& place, std::vector<Key>& copies) {
    KeySource source(level, place.seed);
    std::map<Key, Key> copyOf;
    for (const Object& object : objects) {
        if (std::holds_alternative<BodyObject>(object.data) || std::holds_alternative<GroupObject>(object.data)) {
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
        const auto parent = copyOf.find(object.parent);
        if (isLayer(copy)) {
            copy.parent = 0;
            copies.push_back(copy.key);
        } else if (parent != copyOf.end()) {
            copy.parent = parent->second;
        } else {
            copy.parent = place.keepParents ? object.parent : place.parent;
            copies.push_back(copy.key);
        }
        move(copy.data, place.delta);
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
