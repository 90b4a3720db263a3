#include "core/level/level_delta.h"

#include <algorithm>

namespace spacetow {
namespace {

std::vector<Key> keysOf(const ObjectList& objects) {
    std::vector<Key> keys;
    keys.reserve(static_cast<std::size_t>(objects.size()));
    for (const Object& object : objects) {
        keys.push_back(object.key);
    }
    return keys;
}

ObjectList merged(ObjectList objects, const LevelDelta& delta) {
    std::vector<Key> removed = delta.removed;
    std::ranges::sort(removed);
    objects.eraseIf([&removed](const Object& object) { return std::ranges::binary_search(removed, object.key); });
    for (const Object& object : delta.changed.objects) {
        const int index = objects.indexOf(object.key);
        if (index >= 0) {
            objects.replace(index, object);
        } else {
            objects.append(object);
        }
    }
    return objects;
}

void putInOrder(ObjectList& objects, const std::vector<Key>& order) {
    std::vector<int> places;
    std::vector<bool> placed(static_cast<std::size_t>(objects.size()));
    const auto place = [&](int index) {
        if (index >= 0 && !placed[static_cast<std::size_t>(index)]) {
            placed[static_cast<std::size_t>(index)] = true;
            places.push_back(index);
        }
    };
    for (const Key key : order) {
        place(objects.indexOf(key));
    }
    for (int index = 0; index < objects.size(); ++index) {
        place(index);
    }
    objects.rearrange(places);
}

} // namespace

LevelDelta deltaBetween(const Level& before, const Level& after) {
    LevelDelta delta;
    delta.changed = after;
    delta.changed.objects = ObjectList();
    after.objects.visitDifferences(before.objects, [&](int index) {
        if (index < before.objects.size() && after.objects.find(before.objects[index].key) == nullptr) {
            delta.removed.push_back(before.objects[index].key);
        }
        if (index < after.objects.size()) {
            const Object& object = after.objects[index];
            const Object* was = before.objects.find(object.key);
            if (was != &object && (was == nullptr || !(*was == object))) {
                delta.changed.objects.append(object);
            }
        }
    });
    const ObjectList all = merged(before.objects, delta);
    bool same = true;
    after.objects.visitDifferences(all, [&](int index) {
        same = same && index < all.size() && index < after.objects.size() && all[index].key == after.objects[index].key;
    });
    if (!same) {
        delta.order = keysOf(after.objects);
    }
    return delta;
}

Level withDelta(const Level& before, const LevelDelta& delta) {
    Level after = delta.changed;
    after.objects = merged(before.objects, delta);
    if (!delta.order.empty()) {
        putInOrder(after.objects, delta.order);
    }
    return after;
}

} // namespace spacetow
