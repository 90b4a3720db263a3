#include "editor/editing/guide_verbs.h"

#include "core/level/guides.h"

namespace spacetow {

namespace {

Edit editWith(const Edit& edit, Level level) {
    return {std::make_shared<const Level>(std::move(level)), edit.selection};
}

} // namespace

FinishedEdit addGuide(const ToolContext& context, const Vec2& point) {
    Guide guide;
    guide.point = context.snap.grid ? onGrid(context.snap, point) : point;
    return {{"add-guide"}, editWith(context.edit, guideAdded(*context.edit.level, guide))};
}

std::optional<FinishedEdit> changeGuide(const Edit& edit, std::size_t index, const Guide& guide) {
    const std::vector<Guide>& guides = edit.level->guides;
    if (index >= guides.size() || guides[index] == guide) {
        return {};
    }
    return FinishedEdit{
        {"change-guide"}, editWith(edit, guideReplaced(*edit.level, index, guide)), "guide " + std::to_string(index)};
}

std::optional<FinishedEdit> deleteGuide(const Edit& edit, std::size_t index) {
    if (index >= edit.level->guides.size()) {
        return {};
    }
    return FinishedEdit{{"delete-guide"}, editWith(edit, guideRemoved(*edit.level, index))};
}

std::optional<FinishedEdit> clearGuides(const ToolContext& context) {
    if (context.edit.level->guides.empty()) {
        return {};
    }
    return FinishedEdit{{"clear-guides"}, editWith(context.edit, guidesCleared(*context.edit.level))};
}

} // namespace spacetow
