#include "editor/window/actions.h"

#include "editor/window/menus.h"
#include "editor/window/messages_table.h"
#include "tests/support/test_main.h"
#include "tests/support/window.h"

#include <QMenu>
#include <QMenuBar>
#include <QToolBar>

#include <algorithm>
#include <set>

using namespace spacetow;
using spacetow::test::TestWindow;

namespace {

const ActionRow& rowOf(ActionId id) {
    return *std::ranges::find(actionRows(), id, &ActionRow::id);
}

/// How often the action stands in menus of the menu bar.
int timesInMenus(const MainWindow& window, const QAction* wanted) {
    int times = 0;
    for (const QMenu* menu : window.menuBar()->findChildren<QMenu*>()) {
        times += static_cast<int>(menu->actions().count(wanted));
    }
    return times;
}

} // namespace

class ActionsTest : public QObject {
    Q_OBJECT

  private slots:
    void everyActionHasOneRow() {
        std::set<ActionId> ids;
        for (const ActionRow& row : actionRows()) {
            QVERIFY2(ids.insert(row.id).second, row.text);
        }
        for (const ToolRow& tool : toolRows()) {
            QVERIFY(ids.contains(tool.id));
        }
        // The last one of the enumeration.
        QCOMPARE(ids.size(), toolRows().size() + static_cast<std::size_t>(Act::About) + 1);
    }

    void everyRowSaysWhatItDoes() {
        for (const ActionRow& row : actionRows()) {
            const bool tool = std::holds_alternative<ToolId>(row.id);
            QCOMPARE(row.toggle != nullptr, row.isOn != nullptr);
            QCOMPARE(int(row.run != nullptr) + int(row.toggle != nullptr) + int(tool), 1);
        }
    }

    void theRowOfAToolHasItsIconAndItsHints() {
        for (const ToolRow& tool : toolRows()) {
            const ActionRow& row = rowOf(tool.id);
            QVERIFY2(*row.icon != '\0' && row.hints != nullptr, row.text);
            // Each of them belongs to some tool's class, and the tool's first is among them.
            const std::span<const HintText> texts = row.hints();
            const auto first =
                std::ranges::find_if(texts, [&tool](const HintText& text) { return tool.hints.front() == text.code; });
            QVERIFY2(first != texts.end(), row.text);
        }
    }

    void everyActionStandsOnceInTheMenus() {
        TestWindow test;
        for (const ActionRow& row : actionRows()) {
            QVERIFY2(timesInMenus(*test.window, &test.window->actions()[row.id]) == 1, row.text);
        }
    }

    void aMenuWithoutEntriesIsNotShown() {
        TestWindow test;
        for (const QMenu* menu : test.window->menuBar()->findChildren<QMenu*>()) {
            QVERIFY2(menu->isEmpty() != menu->menuAction()->isVisible(), qPrintable(menu->title()));
        }
    }

    void everyToolIsTakenByItsActionAndShownAsTaken() {
        TestWindow test;
        for (const ToolRow& tool : toolRows()) {
            test.trigger(tool.id);
            QCOMPARE(test.window->toolbox().current(), tool.id);
            for (const ToolRow& other : toolRows()) {
                QCOMPARE(test.window->actions()[other.id].isChecked(), other.id == tool.id);
            }
            const auto* bar = test.window->findChild<QToolBar*>("tools");
            QVERIFY(bar->actions().contains(&test.window->actions()[tool.id]));
        }
        test.window->toolbox().choose(ToolId::Edge);
        QVERIFY(test.window->actions()[ToolId::Edge].isChecked());
    }

    void oneKeyPlacesShipPayloadAndFinish() {
        TestWindow test;
        for (const ToolId tool : {ToolId::Ship, ToolId::Payload, ToolId::Finish, ToolId::Ship}) {
            test.trigger(Act::PlaceNext);
            QVERIFY(test.window->actions()[tool].isChecked());
        }
    }

    void aSwitchShowsAndSetsTheSameThing() {
        TestWindow test;
        for (const ActionRow& row : actionRows()) {
            if (row.toggle == nullptr || (row.flags & OnlyPlaying) != 0) {
                continue;
            }
            const bool before = row.isOn(*test.window);
            QCOMPARE(test.window->actions()[row.id].isChecked(), before);
            test.trigger(row.id);
            QVERIFY2(row.isOn(*test.window) != before, row.text);
            QCOMPARE(test.window->actions()[row.id].isChecked(), !before);
            test.trigger(row.id);
            QVERIFY2(row.isOn(*test.window) == before, row.text);
        }
    }

    void allOverlaysGoOffTogether() {
        TestWindow test;
        test.trigger(Act::OverlayAabb);
        test.trigger(Act::OverlayNormals);
        test.trigger(Act::OverlaysOff);
        QVERIFY(!test.window->overlays().any());
        QVERIFY(!test.window->actions()[Act::OverlayAabb].isChecked());
    }

    void whatNeedsASelectionRestsWithoutOne() {
        TestWindow test;
        test.drawWalls();
        test.trigger(Act::SelectAll);
        test.trigger(Act::Group); // what is possible with one kind alone is possible with a group that holds it
        for (const bool selected : {true, false}) {
            test.trigger(selected ? Act::SelectAll : Act::SelectNone);
            for (const ActionRow& row : actionRows()) {
                if ((row.flags & NeedsSelection) != 0) {
                    QVERIFY2(test.window->actions()[row.id].isEnabled() == selected, row.text);
                }
            }
        }
        QVERIFY((rowOf(Act::Delete).flags & NeedsSelection) != 0);
    }

    void theMenuOfFilesEndsWithQuit() {
        TestWindow test;
        QCOMPARE(test.window->menu(MenuId::File).actions().back(), &test.window->actions()[Act::Quit]);
    }

    void theBarHasPlayBeforeTheOverlays() {
        TestWindow test;
        const QList<QAction*> bar = test.window->findChild<QToolBar*>("main")->actions();
        QVERIFY(bar.indexOf(&test.window->actions()[Act::Step]) <
                bar.indexOf(&test.window->actions()[Act::OverlayAabb]));
    }

    void undoNamesWhatItTakesBack() {
        TestWindow test;
        QAction& undo = test.window->actions()[Act::Undo];
        const QString plain = undo.text();
        QVERIFY(!undo.isEnabled());
        test.drawWalls();
        QVERIFY(undo.isEnabled());
        QVERIFY(undo.text().startsWith(plain) && undo.text() != plain);
        test.trigger(Act::Undo);
        QCOMPARE(undo.text(), plain);
        QVERIFY(test.window->actions()[Act::Redo].isEnabled());
    }
};

SPACETOW_TEST(ActionsTest)
#include "actions_test.moc"
