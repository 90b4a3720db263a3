// Polygons out of polygons.
#include "core/level/combine.h"
#include "editor/window/main_window.h"
#include "editor/window/messages.h"

namespace spacetow {

namespace {

template <PolygonBoolean how>
void combine(MainWindow& window) {
    const ToolContext context = window.toolbox().context();
    const Selection& selection = context.edit.selection;
    Result<CombinedBodies> result = combinedBodies(*context.edit.level, selection.keys(), how);
    if (!result) {
        window.messageBar().say(MessageBar::Tone::Warning, sentence(result.error()));
        return;
    }
    constexpr LabelCode code = how == PolygonBoolean::Union        ? LabelCode("union")
                               : how == PolygonBoolean::Difference ? LabelCode("difference")
                                                                   : "intersection";
    CombinedBodies combined = std::move(result).value();
    window.toolbox().finish(FinishedEdit{{code, selection.size()},
                                         {std::make_shared<const Level>(std::move(combined.level)),
                                          Selection({combined.key}).entering(selection.entered())}});
}

constexpr ActionRow combineRows[] = {
    {.id = Act::Unite,
     .menu = MenuId::Path,
     .text = QT_TRANSLATE_NOOP("Actions", "&Union"),
     .icon = "union",
     .keys = "Ctrl+Alt+U",
     .tip = QT_TRANSLATE_NOOP("Actions", "Make one body of the selected polygons"),
     .flags = NeedsSelection | SeparatorBefore,
     .run = combine<PolygonBoolean::Union>},
    {.id = Act::Subtract,
     .menu = MenuId::Path,
     .text = QT_TRANSLATE_NOOP("Actions", "&Difference"),
     .icon = "difference",
     .keys = "Ctrl+Alt+M",
     .tip = QT_TRANSLATE_NOOP("Actions", "Cut the upper polygons out of the lowest one"),
     .flags = NeedsSelection,
     .run = combine<PolygonBoolean::Difference>},
    {.id = Act::Intersect,
     .menu = MenuId::Path,
     .text = QT_TRANSLATE_NOOP("Actions", "&Intersection"),
     .icon = "intersection",
     .keys = "Ctrl+Alt+I",
     .tip = QT_TRANSLATE_NOOP("Actions", "Keep what the selected polygons have in common"),
     .flags = NeedsSelection,
     .run = combine<PolygonBoolean::Intersection>},
};

} // namespace

std::span<const ActionRow> combineActions() {
    return combineRows;
}

} // namespace spacetow
