#include "editor/editing/clipboard.h"

#include "core/level/bounds.h"
#include "core/level/edits.h"
#include "core/level/file.h"
#include "editor/editing/verbs.h"

#include <algorithm>
#include <utility>

namespace spacetow {

std::string copied(const Edit& edit) {
    return edit.selection.empty() ? std::string() : objectsText(*edit.level, edit.selection.keys());
}

std::optional<FinishedEdit> cut(const ToolContext& context) {
    std::optional<FinishedEdit> finished = removeSelected(context);
    if (finished) {
        finished->label.code = "cut";
    }
    return finished;
}

std::optional<FinishedEdit> pasted(const ToolContext& context, std::string_view text, const std::optional<Vec2>& at) {
    std::vector<Problem> problems;
    AdoptedObjects adopted = withTagsAdopted(*context.edit.level, parseObjects(text, problems));
    std::vector<Key> copies;
    const Key entered = context.edit.selection.entered();
    Level level = pasted(std::move(adopted.level), adopted.objects, {{0, 0}, context.seed, entered}, copies);
    if (copies.empty()) {
        return {};
    }
    const bool stays = std::ranges::all_of(copies, [&](Key key) { return level.objects.find(key)->parent == entered; });
    const Selection selection = Selection(std::move(copies)).entering(stays ? entered : 0);
    const Aabb box = boundsOf(level, selection.keys());
    if (at && !box.isEmpty()) {
        Vec2 delta = *at - box.center();
        if (context.snap.grid && context.snap.step > 0) {
            delta = onGrid(context.snap, delta);
        }
        level = moved(std::move(level), selection.keys(), delta);
    }
    FinishedEdit finished{{"paste", selection.size()}, {std::make_shared<const Level>(std::move(level)), selection}};
    finished.notes = std::move(adopted.notes);
    return finished;
}

} // namespace spacetow
