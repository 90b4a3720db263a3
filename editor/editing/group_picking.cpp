#include "editor/editing/group_picking.h"

#include "core/level/groups.h"
#include "editor/editing/pick.h"

#include <algorithm>

namespace spacetow {

namespace {

/// The group that the object is in, unless it is a layer, which nobody enters; else 0.
Key groupAround(const GroupTree& tree, const Object& object) {
    const Object* parent = tree.parentOf(object);
    return parent == nullptr || std::get<GroupObject>(parent->data).layer ? 0 : parent->key;
}

GroupPick pickOf(const Edit& edit, const GroupTree& tree, const Object& object) {
    const Key entered = edit.selection.entered();
    for (const Object* each = &object; each != nullptr; each = tree.parentOf(*each)) {
        if (edit.selection.contains(each->key)) {
            return {each->key, entered, object.key};
        }
    }
    for (Key group = entered;;) {
        if (const Object* member = tree.memberOf(group, object)) {
            return {member->key, group, object.key};
        }
        const Object* left = group == 0 ? nullptr : edit.level->objects.find(group);
        group = left == nullptr ? 0 : groupAround(tree, *left);
    }
}

template <class T, class KeyOf>
void keepFirst(std::vector<T>& values, KeyOf keyOf) {
    std::vector<Key> seen;
    std::erase_if(values, [&](const T& value) {
        const Key key = keyOf(value);
        const auto place = std::ranges::lower_bound(seen, key);
        if (place != seen.end() && *place == key) {
            return true;
        }
        seen.insert(place, key);
        return false;
    });
}

} // namespace

std::vector<GroupPick> pickedMembers(const Edit& edit, const Pointer& pointer) {
    const std::vector<Key> objects = picked(*edit.level, pointer.world, grabPixels * pointer.pixel);
    if (objects.empty()) {
        return {};
    }
    const GroupTree tree(*edit.level);
    std::vector<GroupPick> picks;
    for (const Key key : objects) {
        picks.push_back(pickOf(edit, tree, *edit.level->objects.find(key)));
    }
    keepFirst(picks, [](const GroupPick& pick) { return pick.key; });
    std::stable_partition(picks.begin(), picks.end(),
                          [&](const GroupPick& pick) { return pick.entered == edit.selection.entered(); });
    return picks;
}

std::vector<Key> membersOf(const Edit& edit, const std::vector<Key>& objects) {
    const GroupTree tree(*edit.level);
    const Key entered = edit.selection.entered();
    if (!tree.hasGroups()) {
        return objects;
    }
    std::vector<Key> members;
    for (const Key key : objects) {
        if (const Object* member = tree.memberOf(entered, *edit.level->objects.find(key))) {
            members.push_back(member->key);
        }
    }
    std::ranges::sort(members);
    members.erase(std::unique(members.begin(), members.end()), members.end());
    return members;
}

Selection directly(const Edit& edit, Key object) {
    return Selection({object}).entering(groupAround(GroupTree(*edit.level), *edit.level->objects.find(object)));
}

std::optional<Selection> entering(const Edit& edit, Key group, Key object) {
    const Object* found = edit.level->objects.find(group);
    const Object* inside = edit.level->objects.find(object);
    if (found == nullptr || inside == nullptr || !std::holds_alternative<GroupObject>(found->data)) {
        return {};
    }
    const Object* member = GroupTree(*edit.level).memberOf(group, *inside);
    return member == nullptr ? std::nullopt : std::optional(Selection({member->key}).entering(group));
}

std::optional<Selection> leaving(const Edit& edit) {
    const Object* group = edit.level->objects.find(edit.selection.entered());
    if (edit.selection.entered() == 0 || group == nullptr) {
        return {};
    }
    return Selection({group->key}).entering(groupAround(GroupTree(*edit.level), *group));
}

} // namespace spacetow
