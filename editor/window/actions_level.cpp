// The level as a whole.
#include "editor/window/main_window.h"
#include "editor/window/messages.h"

#include <QDockWidget>

namespace spacetow {

namespace {

/// With what it says in sight, and not the mark alone.
void goToProblem(MainWindow& window, int by) {
    if (!window.arePanelsHidden()) {
        QDockWidget& dock = window.panels().dock(QStringLiteral("problems"));
        dock.show();
        dock.raise();
    }
    window.problems().go(by);
    const Problem* const problem = window.problems().currentProblem();
    if (window.arePanelsHidden() && problem != nullptr) {
        window.statusLine().showMessage(sentence(*problem), 10000);
    }
}

constexpr ActionRow levelMenuRows[] = {
    {.id = Act::NextProblem,
     .menu = MenuId::Level,
     .text = QT_TRANSLATE_NOOP("Actions", "&Next Problem"),
     .icon = "warning",
     .keys = "F4",
     .tip = QT_TRANSLATE_NOOP("Actions", "Go to the next problem of the level"),
     .run = [](MainWindow& window) { goToProblem(window, 1); }},
    {.id = Act::PreviousProblem,
     .menu = MenuId::Level,
     .text = QT_TRANSLATE_NOOP("Actions", "&Previous Problem"),
     .keys = "Shift+F4",
     .tip = QT_TRANSLATE_NOOP("Actions", "Go to the problem before"),
     .run = [](MainWindow& window) { goToProblem(window, -1); }},
    {.id = Act::FixProblem,
     .menu = MenuId::Level,
     .text = QT_TRANSLATE_NOOP("Actions", "&Fix Problem"),
     .icon = "ok",
     .keys = "F7",
     .tip = QT_TRANSLATE_NOOP("Actions", "Cure the problem that was gone to last, where there is a fix for it"),
     .run = [](MainWindow& window) { window.problems().fixCurrent(); },
     .isPossible = [](const MainWindow& window) { return window.problems().canFixCurrent(); },
     .why = QT_TRANSLATE_NOOP("Actions", "Go to a problem first for which there is a fix.")},
    {.id = Act::FixAllProblems,
     .menu = MenuId::Level,
     .text = QT_TRANSLATE_NOOP("Actions", "Fix All &Safe Problems"),
     .icon = "ok",
     .keys = "Shift+F7",
     .tip = QT_TRANSLATE_NOOP("Actions", "Cure all problems whose fix changes nothing that was meant"),
     .run = [](MainWindow& window) { window.problems().fixAll(); },
     .isPossible = [](const MainWindow& window) { return window.problems().safeFixes() > 0; },
     .why = QT_TRANSLATE_NOOP("Actions", "There is no problem that could be cured without asking.")},
    {.id = Act::HideProblem,
     .menu = MenuId::Level,
     .text = QT_TRANSLATE_NOOP("Actions", "&Hide Problem"),
     .icon = "eye-off",
     .keys = "Ctrl+F7",
     .tip =
         QT_TRANSLATE_NOOP("Actions", "Never show the problem that was gone to last in this level, or show it again"),
     .run = [](MainWindow& window) { window.problems().hideCurrent(); },
     .isPossible = [](const MainWindow& window) { return window.problems().current() >= 0; },
     .why = QT_TRANSLATE_NOOP("Actions", "Go to a problem first.")},
};

} // namespace

std::span<const ActionRow> levelActions() {
    return levelMenuRows;
}

} // namespace spacetow
