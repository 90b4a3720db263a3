// The level as a whole.
#include "editor/window/main_window.h"

namespace spacetow {

namespace {

constexpr ActionRow levelMenuRows[] = {
    {.id = Act::NextProblem,
     .menu = MenuId::Level,
     .text = QT_TRANSLATE_NOOP("Actions", "&Next Problem"),
     .icon = "warning",
     .keys = "F4",
     .tip = QT_TRANSLATE_NOOP("Actions", "Go to the next problem of the level"),
     .run = [](MainWindow& window) { window.problems().go(1); }},
    {.id = Act::PreviousProblem,
     .menu = MenuId::Level,
     .text = QT_TRANSLATE_NOOP("Actions", "&Previous Problem"),
     .keys = "Shift+F4",
     .tip = QT_TRANSLATE_NOOP("Actions", "Go to the problem before"),
     .run = [](MainWindow& window) { window.problems().go(-1); }},
};

} // namespace

std::span<const ActionRow> levelActions() {
    return levelMenuRows;
}

} // namespace spacetow
