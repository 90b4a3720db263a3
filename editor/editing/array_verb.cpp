#include "editor/editing/array_verb.h"

#include <utility>

namespace spacetow {

std::optional<FinishedEdit> arraySelected(const ToolContext& context, const ArraySpec& spec) {
    const Level& before = *context.edit.level;
    const Selection& selection = context.edit.selection;
    const std::int64_t size = arraySize(before, selection.keys(), spec);
    if (size <= 0 || size > maxArrayObjects) {
        return {};
    }
    std::vector<Key> keys;
    Level level = arrayed(before, selection.keys(), {spec, context.seed}, keys);
    const Label label{"array", static_cast<int>(keys.size())};
    keys.insert(keys.end(), selection.keys().begin(), selection.keys().end());
    return FinishedEdit{
        label,
        {std::make_shared<const Level>(std::move(level)), Selection(std::move(keys)).entering(selection.entered())}};
}

} // namespace spacetow
