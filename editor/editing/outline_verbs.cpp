#include "editor/editing/outline_verbs.h"

#include "core/level/arrange.h"
#include "core/level/edits.h"

#include <algorithm>
#include <utility>

namespace spacetow {

namespace {

std::optional<FinishedEdit> outlined(const Edit& edit, Label label, Level level) {
    if (level == *edit.level) {
        return {};
    }
    return FinishedEdit{std::move(label), {std::make_shared<const Level>(std::move(level)), edit.selection}};
}

/// The group that the object is in, unless it is a layer, which nobody enters; else 0.
Key enterable(const GroupTree& tree, const Object& object) {
    const Object* parent = tree.parentOf(object);
    return parent == nullptr || std::get<GroupObject>(parent->data).layer ? 0 : parent->key;
}

/// Those that may be moved, groups as a whole.
std::vector<Key> movable(const Level& level, std::span<const Key> keys) {
    std::vector<Key> wanted(keys.begin(), keys.end());
    std::ranges::sort(wanted);
    const std::vector<Key> unlocked = unlockedKeys(level, wanted);
    std::vector<Key> result;
    std::ranges::set_intersection(wanted, unlocked, std::back_inserter(result));
    return result;
}

Selection onlyVisible(const Level& level, const Selection& selection) {
    const GroupTree tree(level);
    std::vector<Key> hidden = selection.keys();
    std::erase_if(hidden, [&](Key key) {
        const Object* object = level.objects.find(key);
        return object == nullptr || tree.isVisible(*object);
    });
    if (hidden.empty()) {
        return selection;
    }
    std::vector<Key> kept;
    std::ranges::set_difference(selection.keys(), hidden, std::back_inserter(kept));
    return Selection(std::move(kept)).entering(selection.entered());
}

} // namespace

Selection selectionOf(const Level& level, std::vector<Key> keys) {
    const GroupTree tree(level);
    std::optional<Key> entered;
    for (const Key key : keys) {
        const Object* object = level.objects.find(key);
        const Key group = object == nullptr ? 0 : enterable(tree, *object);
        entered = !entered || *entered == group ? group : 0;
    }
    return Selection(std::move(keys)).entering(entered.value_or(0));
}

bool mayRegroup(const Level& level, std::span<const Key> keys, Key parent) {
    const Object* group = parent == 0 ? nullptr : level.objects.find(parent);
    if (parent == 0 || group == nullptr) {
        return parent == 0;
    }
    const GroupTree tree(level);
    const auto fits = [&](Key key) {
        const Object* object = level.objects.find(key);
        const auto* moved = object == nullptr ? nullptr : std::get_if<GroupObject>(&object->data);
        return object != nullptr && (moved == nullptr || !moved->layer) && key != parent && !tree.isWithin(*group, key);
    };
    return std::holds_alternative<GroupObject>(group->data) && !tree.isLocked(*group) &&
           std::ranges::any_of(keys, fits);
}

std::optional<FinishedEdit> regroup(const Edit& edit, std::span<const Key> keys, const ObjectPlace& place) {
    if (!mayRegroup(*edit.level, keys, place.parent)) {
        return {};
    }
    const std::vector<Key> moved = movable(*edit.level, keys);
    const bool stay =
        std::ranges::all_of(moved, [&](Key key) { return edit.level->objects.find(key)->parent == place.parent; });
    const Label label{stay ? LabelCode("order") : "regroup", static_cast<int>(moved.size())};
    std::optional<FinishedEdit> finished = outlined(edit, label, regrouped(*edit.level, moved, place));
    if (finished) {
        finished->edit.selection = selectionOf(*finished->edit.level, moved);
    }
    return finished;
}

std::optional<FinishedEdit> renameObject(const Edit& edit, Key key, std::string name) {
    return outlined(edit, {"rename", 1}, renamed(*edit.level, key, std::move(name)));
}

std::optional<FinishedEdit> colorGroup(const Edit& edit, Key key, std::optional<std::uint32_t> color) {
    const Object* found = edit.level->objects.find(key);
    if (found == nullptr || !std::holds_alternative<GroupObject>(found->data)) {
        return {};
    }
    Object object = *found;
    std::get<GroupObject>(object.data).color = color;
    return outlined(edit, {"change", 1}, withObject(*edit.level, std::move(object)));
}

std::optional<FinishedEdit> showObjects(const Edit& edit, std::span<const Key> keys, bool visible) {
    std::optional<FinishedEdit> finished =
        outlined(edit, {visible ? LabelCode("show") : "hide", static_cast<int>(keys.size())},
                 withVisible(*edit.level, keys, visible));
    if (finished && !visible) {
        finished->edit.selection = onlyVisible(*finished->edit.level, edit.selection);
    }
    return finished;
}

std::optional<FinishedEdit> lockObjects(const Edit& edit, std::span<const Key> keys, bool locked) {
    return outlined(edit, {locked ? LabelCode("lock") : "unlock", static_cast<int>(keys.size())},
                    withLocked(*edit.level, keys, locked));
}

} // namespace spacetow
