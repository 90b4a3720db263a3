#include "editor/editing/selected_kinds.h"

#include "core/level/groups.h"
#include "core/level/level_index.h"
#include "editor/editing/node_pick.h"

#include <algorithm>

namespace spacetow {

namespace {

constexpr std::size_t mostLookedAt = 2000;

bool hasDirection(const LevelShape& shape) {
    return std::holds_alternative<EdgeChain>(shape) || std::holds_alternative<LineChain>(shape);
}

void include(SelectedKinds& kinds, const GroupTree& tree, const Object& object) {
    const auto* const body = std::get_if<BodyObject>(&object.data);
    const bool free = !tree.isLocked(object);
    kinds.copyable |= body != nullptr || std::holds_alternative<GroupObject>(object.data);
    kinds.reversible |= free && body != nullptr && std::ranges::any_of(body->shapes, hasDirection);
    kinds.nodes |= free && hasNodes(object.data);
    kinds.unlocked |= free;
}

} // namespace

SelectedKinds selectedKinds(const Edit& edit) {
    const Level& level = *edit.level;
    const Selection& selection = edit.selection;
    SelectedKinds kinds;
    const std::vector<int>& groups = levelIndex(level).groups();
    kinds.groups = std::ranges::any_of(groups, [&](int place) { return selection.contains(level.objects[place].key); });
    const GroupTree tree(level);
    const std::vector<Key> keys = kinds.groups ? withMembers(level, selection.keys()) : selection.keys();
    for (std::size_t i = 0; i < keys.size(); ++i) {
        if (i == mostLookedAt) {
            return {true, true, kinds.groups, true, true};
        }
        if (const Object* const object = level.objects.find(keys[i])) {
            include(kinds, tree, *object);
        }
    }
    return kinds;
}

} // namespace spacetow
