#include "core/level/groups.h"

#include "core/level/level_index.h"

#include <algorithm>

namespace spacetow {

namespace {

std::vector<Key> sortedKeys(std::span<const Key> keys) {
    std::vector<Key> result(keys.begin(), keys.end());
    std::ranges::sort(result);
    return result;
}

bool isAmong(const std::vector<Key>& keys, Key key) {
    return std::ranges::binary_search(keys, key);
}

/// `change(object)` is applied to a copy of each object named by `keys`.
template <class Change>
Level changedObjects(Level level, std::span<const Key> keys, Change change) {
    for (const int place : level.objects.indicesOf(keys)) {
        Object object = level.objects[place];
        change(object);
        if (!(object == level.objects[place])) {
            level.objects.replace(place, std::move(object));
        }
    }
    return level;
}

/// Those of the keys that are in no other of them.
std::vector<Key> outermost(const Level& level, std::span<const Key> keys) {
    const GroupTree tree(level);
    const std::vector<Key> wanted = sortedKeys(keys);
    std::vector<Key> result;
    for (const int place : level.objects.indicesOf(wanted)) {
        const Object& object = level.objects[place];
        const Object* parent = tree.parentOf(object);
        while (parent != nullptr && !isAmong(wanted, parent->key)) {
            parent = tree.parentOf(*parent);
        }
        if (parent == nullptr) {
            result.push_back(object.key);
        }
    }
    std::ranges::sort(result);
    return result;
}

/// Those of the outermost keys that may come to be in `parent`, ascending.
std::vector<Key> regroupable(const Level& level, std::span<const Key> keys, Key parent) {
    std::vector<Key> wanted = outermost(level, keys);
    if (parent == 0) {
        return wanted;
    }
    const Object* group = level.objects.find(parent);
    if (group == nullptr || !std::holds_alternative<GroupObject>(group->data)) {
        return {};
    }
    const GroupTree tree(level);
    std::erase_if(wanted, [&](Key key) {
        return key == parent || isLayer(*level.objects.find(key)) || tree.isWithin(*group, key);
    });
    return wanted;
}

/// The number of objects that come before the place in the drawing order.
int placeInOrder(const Level& level, const ObjectPlace& place) {
    const int before = place.before == 0 ? -1 : level.objects.indexOf(place.before);
    if (before >= 0 || place.parent == 0) {
        return before >= 0 ? before : level.objects.size();
    }
    const std::vector<Key> inside = withMembers(level, {&place.parent, 1});
    int last = 0;
    for (int i = 0; i < level.objects.size(); ++i) {
        last = isAmong(inside, level.objects[i].key) ? i + 1 : last;
    }
    return last;
}

} // namespace

bool isLayer(const Object& object) {
    const auto* group = std::get_if<GroupObject>(&object.data);
    return group != nullptr && group->layer;
}

GroupTree::GroupTree(const Level& level) {
    for (const int place : levelIndex(level).groups()) {
        m_groups.emplace_back(level.objects[place].key, &level.objects[place]);
    }
    std::ranges::stable_sort(m_groups, {}, &std::pair<Key, const Object*>::first);
    const auto leadsRound = [this](const std::pair<Key, const Object*>& entry) {
        const Object* group = entry.second;
        for (std::size_t steps = 0; steps <= m_groups.size(); ++steps) {
            group = group->parent == 0 ? nullptr : groupOf(group->parent);
            if (group == nullptr) {
                return false;
            }
        }
        return true;
    };
    std::vector<std::pair<Key, const Object*>> sound;
    std::ranges::copy_if(m_groups, std::back_inserter(sound), [&](const auto& entry) { return !leadsRound(entry); });
    m_groups = std::move(sound);
}

const Object* GroupTree::groupOf(Key key) const {
    const auto found = std::ranges::lower_bound(m_groups, key, {}, &std::pair<Key, const Object*>::first);
    return found != m_groups.end() && found->first == key ? found->second : nullptr;
}

const Object* GroupTree::parentOf(const Object& object) const {
    if (object.parent == 0 || m_groups.empty()) {
        return nullptr;
    }
    // A group that leads round is not listed, so it counts as being at the top.
    if (std::holds_alternative<GroupObject>(object.data) && groupOf(object.key) != &object) {
        return nullptr;
    }
    return groupOf(object.parent);
}

bool GroupTree::isWithin(const Object& object, Key group) const {
    for (const Object* parent = parentOf(object); parent != nullptr; parent = parentOf(*parent)) {
        if (parent->key == group) {
            return true;
        }
    }
    return false;
}

const Object* GroupTree::memberOf(Key entered, const Object& object) const {
    const Object* member = &object;
    for (;;) {
        const Object* parent = parentOf(*member);
        if (parent == nullptr) {
            return entered == 0 ? member : nullptr;
        }
        if (parent->key == entered) {
            return member;
        }
        // A layer is no thing to be grabbed: what is in it is reached as if it were at the top.
        if (entered == 0 && std::get<GroupObject>(parent->data).layer) {
            return member;
        }
        member = parent;
    }
}

bool GroupTree::isVisible(const Object& object) const {
    for (const Object* each = &object; each != nullptr; each = parentOf(*each)) {
        if (!each->visible) {
            return false;
        }
    }
    return true;
}

bool GroupTree::isLocked(const Object& object) const {
    for (const Object* each = &object; each != nullptr; each = parentOf(*each)) {
        if (each->locked) {
            return true;
        }
    }
    return false;
}

std::vector<Key> withMembers(const Level& level, std::span<const Key> keys) {
    std::vector<Key> result = sortedKeys(keys);
    const std::vector<int>& groups = levelIndex(level).groups();
    if (std::ranges::none_of(groups, [&](int place) { return isAmong(result, level.objects[place].key); })) {
        return result;
    }
    const GroupTree tree(level);
    const std::vector<Key> wanted = result;
    for (const Object& object : level.objects) {
        for (const Object* parent = tree.parentOf(object); parent != nullptr; parent = tree.parentOf(*parent)) {
            if (isAmong(wanted, parent->key)) {
                result.push_back(object.key);
                break;
            }
        }
    }
    std::ranges::sort(result);
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
}

std::vector<Key> selectableKeys(const Level& level, Key entered) {
    const GroupTree tree(level);
    std::vector<Key> keys;
    for (const Object& object : level.objects) {
        const auto* group = std::get_if<GroupObject>(&object.data);
        if ((group == nullptr || !group->layer) && tree.memberOf(entered, object) == &object &&
            tree.isVisible(object) && !tree.isLocked(object)) {
            keys.push_back(object.key);
        }
    }
    return keys;
}

Level grouped(Level level, std::span<const Key> keys, Object group) {
    EXPECTS(group.key != 0 && level.objects.find(group.key) == nullptr);
    EXPECTS(std::holds_alternative<GroupObject>(group.data));
    std::vector<Key> members = outermost(level, keys);
    std::erase_if(members, [&level](Key key) { return isLayer(*level.objects.find(key)); });
    const std::vector<int> places = level.objects.indicesOf(members);
    if (places.empty()) {
        return level;
    }
    const int first = places.front();
    const Object* parent = GroupTree(level).parentOf(level.objects[first]);
    group.parent = parent == nullptr || std::get<GroupObject>(group.data).layer ? 0 : parent->key;
    const Key key = group.key;
    level = changedObjects(std::move(level), members, [key](Object& object) { object.parent = key; });
    level.objects.insert(first, std::move(group));
    return level;
}

Level ungrouped(Level level, std::span<const Key> keys) {
    const std::vector<Key> wanted = sortedKeys(keys);
    for (int i = 0; i < level.objects.size(); ++i) {
        const Object group = level.objects[i];
        if (!isAmong(wanted, group.key) || !std::holds_alternative<GroupObject>(group.data)) {
            continue;
        }
        for (int j = 0; j < level.objects.size(); ++j) {
            if (level.objects[j].parent == group.key && j != i) {
                Object member = level.objects[j];
                member.parent = group.parent == group.key ? 0 : group.parent;
                level.objects.replace(j, std::move(member));
            }
        }
        level.objects.erase(i--);
    }
    return level;
}

Level regrouped(Level level, std::span<const Key> keys, const ObjectPlace& place) {
    const std::vector<Key> wanted = regroupable(level, keys, place.parent);
    if (wanted.empty()) {
        return level;
    }
    const std::vector<Key> carried = withMembers(level, wanted);
    std::vector<int> order; // of what stays, then of all
    std::vector<int> taken;
    const int end = placeInOrder(level, place);
    std::ptrdiff_t at = 0; // how many of those that stay come before
    for (int i = 0; i < level.objects.size(); ++i) {
        (isAmong(carried, level.objects[i].key) ? taken : order).push_back(i);
        at = i < end ? std::ssize(order) : at;
    }
    order.insert(order.begin() + at, taken.begin(), taken.end());
    level.objects.rearrange(order);
    for (int i = static_cast<int>(at); i < static_cast<int>(at + std::ssize(taken)); ++i) {
        if (isAmong(wanted, level.objects[i].key) && level.objects[i].parent != place.parent) {
            Object object = level.objects[i];
            object.parent = place.parent;
            level.objects.replace(i, std::move(object));
        }
    }
    return level;
}

Level withVisible(Level level, std::span<const Key> keys, bool visible) {
    return changedObjects(std::move(level), keys, [visible](Object& object) { object.visible = visible; });
}

Level withLocked(Level level, std::span<const Key> keys, bool locked) {
    return changedObjects(std::move(level), keys, [locked](Object& object) { object.locked = locked; });
}

} // namespace spacetow
