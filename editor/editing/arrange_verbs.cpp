#include "editor/editing/arrange_verbs.h"

#include "core/level/edits.h"
#include "core/level/groups.h"

#include <algorithm>
#include <set>
#include <utility>

namespace spacetow {

namespace {

/// Nothing when the level stays as it is.
std::optional<FinishedEdit> finished(const ToolContext& context, LabelCode code, Level level) {
    const Selection& selection = context.edit.selection;
    if (level == *context.edit.level) {
        return {};
    }
    return FinishedEdit{{code, selection.size()}, {std::make_shared<const Level>(std::move(level)), selection}};
}

std::optional<FinishedEdit> finishedWithout(const ToolContext& context, LabelCode code, Level level) {
    std::optional<FinishedEdit> edit = finished(context, code, std::move(level));
    if (edit) {
        edit->edit.selection = Selection().entering(context.edit.selection.entered());
    }
    return edit;
}

std::vector<Key> allKeys(const Level& level) {
    std::vector<Key> keys;
    for (const Object& object : level.objects) {
        keys.push_back(object.key);
    }
    return keys;
}

/// Everything of one kind is equal in this.
std::pair<std::size_t, int> kindOf(const ObjectData& data) {
    const auto* body = std::get_if<BodyObject>(&data);
    return {data.index(), body == nullptr ? 0 : static_cast<int>(body->kind)};
}

/// What clicks could select and `isWanted(object)`, in the group that was entered.
template <class IsWanted>
Selection selectableWith(const Edit& edit, IsWanted isWanted) {
    const Key entered = edit.selection.entered();
    std::vector<Key> keys = selectableKeys(*edit.level, entered);
    std::erase_if(keys, [&](Key key) { return !isWanted(*edit.level->objects.find(key)); });
    return Selection(std::move(keys)).entering(entered);
}

/// The layers in the order in which they are drawn.
std::vector<Key> layersOf(const Level& level) {
    std::vector<Key> layers;
    for (const Object& object : level.objects) {
        const auto* group = std::get_if<GroupObject>(&object.data);
        if (group != nullptr && group->layer && object.parent == 0) {
            layers.push_back(object.key);
        }
    }
    return layers;
}

/// The layer that the first selected object is in, or 0.
Key layerOfSelection(const Edit& edit) {
    const GroupTree tree(*edit.level);
    const Object* object = edit.level->objects.find(edit.selection.keys().front());
    Key layer = 0;
    for (object = object == nullptr ? nullptr : tree.parentOf(*object); object != nullptr;
         object = tree.parentOf(*object)) {
        layer = std::get<GroupObject>(object->data).layer ? object->key : layer;
    }
    return layer;
}

} // namespace

std::optional<FinishedEdit> alignSelected(const ToolContext& context, AlignTo side) {
    return finished(context, "align", aligned(*context.edit.level, context.edit.selection.keys(), side));
}

std::optional<FinishedEdit> distributeSelected(const ToolContext& context, Spread what, bool across) {
    return finished(context, "distribute",
                    distributed(*context.edit.level, context.edit.selection.keys(), {what, across}));
}

std::optional<FinishedEdit> orderSelected(const ToolContext& context, OrderTo where) {
    return finished(context, "order", reordered(*context.edit.level, context.edit.selection.keys(), where));
}

std::optional<FinishedEdit> groupSelected(const ToolContext& context) {
    if (context.edit.selection.empty()) {
        return {};
    }
    const Key key = freshKey(*context.edit.level, context.seed);
    Level level = grouped(*context.edit.level, context.edit.selection.keys(), {key, "", GroupObject{}, {}});
    std::optional<FinishedEdit> edit = finished(context, "group", std::move(level));
    if (edit) {
        edit->edit.selection = Selection({key}).entering(context.edit.selection.entered());
    }
    return edit;
}

std::optional<FinishedEdit> ungroupSelected(const ToolContext& context) {
    const Selection& selection = context.edit.selection;
    std::vector<Key> left; // selected afterwards
    for (const Key key : selection.keys()) {
        const Object* object = context.edit.level->objects.find(key);
        if (object != nullptr && !std::holds_alternative<GroupObject>(object->data)) {
            left.push_back(key);
        }
    }
    for (const Object& object : context.edit.level->objects) {
        if (object.parent != 0 && selection.contains(object.parent)) {
            left.push_back(object.key);
        }
    }
    std::optional<FinishedEdit> edit = finished(context, "ungroup", ungrouped(*context.edit.level, selection.keys()));
    if (edit) {
        edit->edit.selection = Selection(std::move(left)).entering(selection.entered()).within(*edit->edit.level);
    }
    return edit;
}

std::optional<FinishedEdit> newLayer(const ToolContext& context) {
    const Selection& selection = context.edit.selection;
    Object layer{freshKey(*context.edit.level, context.seed), "", GroupObject{true, {}}, {}};
    Level level = selection.empty() ? added(*context.edit.level, std::move(layer))
                                    : grouped(*context.edit.level, selection.keys(), std::move(layer));
    std::optional<FinishedEdit> edit = finished(context, "new-layer", std::move(level));
    if (edit) {
        edit->edit.selection = selection.entering(0).within(*edit->edit.level);
    }
    return edit;
}

std::optional<FinishedEdit> selectedToLayer(const ToolContext& context, int step) {
    if (context.edit.selection.empty()) {
        return {};
    }
    std::vector<Key> layers = layersOf(*context.edit.level);
    layers.insert(layers.begin(), 0);
    const auto now = std::ranges::find(layers, layerOfSelection(context.edit));
    const auto to = now - layers.begin() + step;
    if (to < 0 || to >= std::ssize(layers)) {
        return {};
    }
    const std::vector<Key> movable = unlockedKeys(*context.edit.level, context.edit.selection.keys());
    std::vector<Key> keys; // a group stays whole or where it is
    std::ranges::set_intersection(context.edit.selection.keys(), movable, std::back_inserter(keys));
    // Out of all layers they come to lie below these.
    const ObjectPlace place{layers[static_cast<std::size_t>(to)], to == 0 ? layers[1] : 0};
    std::optional<FinishedEdit> edit = finished(context, "to-layer", regrouped(*context.edit.level, keys, place));
    if (edit) {
        edit->edit.selection = context.edit.selection.entering(0);
    }
    return edit;
}

std::optional<FinishedEdit> hideSelected(const ToolContext& context) {
    return finishedWithout(context, "hide", withVisible(*context.edit.level, context.edit.selection.keys(), false));
}

std::optional<FinishedEdit> lockSelected(const ToolContext& context) {
    return finishedWithout(context, "lock", withLocked(*context.edit.level, context.edit.selection.keys(), true));
}

std::optional<FinishedEdit> isolateSelected(const ToolContext& context) {
    if (context.edit.selection.empty()) {
        return {};
    }
    return finished(context, "isolate", isolated(*context.edit.level, context.edit.selection.keys()));
}

std::optional<FinishedEdit> showAll(const ToolContext& context) {
    return finished(context, "show-all", withVisible(*context.edit.level, allKeys(*context.edit.level), true));
}

std::optional<FinishedEdit> unlockAll(const ToolContext& context) {
    return finished(context, "unlock-all", withLocked(*context.edit.level, allKeys(*context.edit.level), false));
}

std::optional<FinishedEdit> duplicateInPlace(const ToolContext& context) {
    std::vector<Key> copies;
    Level level = duplicated(*context.edit.level, context.edit.selection.keys(), {{0, 0}, context.seed}, copies);
    if (copies.empty()) {
        return {};
    }
    Selection selection = Selection(std::move(copies)).entering(context.edit.selection.entered());
    const Label label{"duplicate", selection.size()};
    return FinishedEdit{
        label, {std::make_shared<const Level>(std::move(level)), std::move(selection)}, {}, Repeatable{Affine(), true}};
}

std::optional<FinishedEdit> repeatLast(const ToolContext& context) {
    if (!context.last || context.edit.selection.empty()) {
        return {};
    }
    Level level = *context.edit.level;
    Selection selection = context.edit.selection;
    if (context.last->copies) {
        std::vector<Key> copies;
        level = duplicated(std::move(level), selection.keys(), {{0, 0}, context.seed}, copies);
        selection = Selection(std::move(copies)).entering(selection.entered());
    }
    if (selection.empty()) {
        return {};
    }
    const std::vector<Key> keys = unlockedKeys(level, selection.keys());
    level = transformed(std::move(level), keys, context.last->map);
    const Label label{"repeat", selection.size()};
    return FinishedEdit{label, {std::make_shared<const Level>(std::move(level)), selection}, {}, context.last};
}

Selection sameKind(const Edit& edit) {
    std::set<std::pair<std::size_t, int>> kinds;
    for (const Key key : edit.selection.keys()) {
        if (const Object* object = edit.level->objects.find(key)) {
            kinds.insert(kindOf(object->data));
        }
    }
    return selectableWith(edit, [&kinds](const Object& object) { return kinds.contains(kindOf(object.data)); });
}

Selection sameTags(const Edit& edit) {
    std::vector<Filter> filters;
    for (const Key key : edit.selection.keys()) {
        const Object* object = edit.level->objects.find(key);
        const auto* body = object == nullptr ? nullptr : std::get_if<BodyObject>(&object->data);
        if (body != nullptr && std::ranges::find(filters, body->filter) == filters.end()) {
            filters.push_back(body->filter);
        }
    }
    return selectableWith(edit, [&filters](const Object& object) {
        const auto* body = std::get_if<BodyObject>(&object.data);
        return body != nullptr && std::ranges::find(filters, body->filter) != filters.end();
    });
}

} // namespace spacetow
