// What the menu at the pointer holds, by what lies there.
#include "editor/window/context_menu.h"

#include "editor/panels/names.h"
#include "tests/support/test_main.h"
#include "tests/support/window.h"

#include <QContextMenuEvent>
#include <QMenu>
#include <QSignalSpy>

#include <algorithm>

using namespace spacetow;
using spacetow::test::TestWindow;

namespace {

constexpr Key yardShip = 1, yardWall = 2, yardBox = 3, yardBall = 4;

Object yardObject(Key key, ObjectData data) {
    return {key, "", std::move(data), {}};
}

/// A wall below, and a ball on a box on the left.
Level menuYard() {
    Level level;
    level.objects.append(yardObject(yardShip, ShipObject{{2, 2}, 0}));
    level.objects.append(yardObject(yardWall, BodyObject{.shapes = {EdgeChain{{{-3, -2}, {3, -2}}, false, noBack}}}));
    level.objects.append(yardObject(yardBox, BodyObject{.shapes = {Polygon{{{-3, -1}, {-1, -1}, {-1, 1}, {-3, 1}}}}}));
    level.objects.append(yardObject(yardBall, BodyObject{.shapes = {Circle{{-2, 0}, 0.5}}}));
    return level;
}

/// Without mnemonics and keys; a line for a rule.
QStringList textsOf(const QMenu& menu) {
    QStringList texts;
    for (const QAction* action : menu.actions()) {
        texts << (action->isSeparator() ? QStringLiteral("-")
                                        : withoutMnemonic(action->text()).section(QLatin1Char('\t'), 0, 0));
    }
    return texts;
}

struct MenuWindow : TestWindow {
    MenuWindow() { document().reset(menuYard()); }

    /// Of the menu that a right click would open there.
    QStringList entriesAt(double x, double y) {
        canvas().disconnect(window.get()); // the menu itself would wait for an answer
        QTest::mouseMove(&canvas(), at(x, y));
        QTest::mouseClick(&canvas(), Qt::RightButton, {}, at(x, y));
        menu.clear();
        fillMenuAtPointer(*window, menu);
        return textsOf(menu);
    }
    QAction* entry(const QString& text) {
        const QList<QAction*> actions = menu.actions();
        const qsizetype i = textsOf(menu).indexOf(text);
        return i < 0 ? nullptr : actions[i];
    }
    std::vector<Key> selected() { return document().selection().keys(); }

    QMenu menu;
};

} // namespace

class ContextMenuTest : public QObject {
    Q_OBJECT

  private slots:
    void onAnObjectStandsWhatCanBeDoneWithIt() {
        MenuWindow test;
        const QStringList ofShip = test.entriesAt(2, 2);
        QCOMPARE(test.selected(), std::vector<Key>{yardShip});
        QCOMPARE(ofShip,
                 (QStringList{"Cut", "Copy", "Paste", "Delete", "-", "Rename…", "-", "Group", "Order", "Transform", "-",
                              "Hide", "Isolate", "Lock", "-", "Frame Selection", "Play from Pointer"}));
        const QStringList ofWall = test.entriesAt(0, -2);
        QCOMPARE(test.selected(), std::vector<Key>{yardWall});
        for (const char* text : {"Duplicate", "Edit Nodes", "Insert Node Here", "Reverse Direction"}) {
            QVERIFY2(ofWall.contains(text), text);
        }
        QVERIFY(!ofWall.contains("Align") && !ofWall.contains("Ungroup"));
        test.trigger(Act::SelectAll);
        QVERIFY(test.entriesAt(2, 2).contains("Align"));
        QCOMPARE(test.selected().size(), std::size_t{4}); // what is selected already stays so
    }

    void everyEntryShowsItsKey() {
        MenuWindow test;
        test.entriesAt(0, -2);
        for (const QAction* action : test.menu.actions()) {
            QVERIFY2(action->isSeparator() || action->menu() != nullptr || !action->shortcut().isEmpty() ||
                         action->text().contains(QLatin1Char('\t')),
                     qPrintable(action->text()));
        }
    }

    void onTheGroundStandsWhatConcernsAllOfIt() {
        MenuWindow test;
        test.document().select(Selection({yardBox}));
        QCOMPARE(test.entriesAt(0, 3), (QStringList{"Paste", "Paste in Place", "-", "Select All", "-", "Fit Level",
                                                    "Level Properties…", "-", "Play from Pointer"}));
        QCOMPARE(test.selected(), std::vector<Key>{yardBox});
        test.trigger(Act::Hide);
        QVERIFY(test.entriesAt(0, 3).contains("Show All"));
    }

    void whatLiesBelowCanBeSelected() {
        MenuWindow test;
        QCOMPARE(test.entriesAt(-2, 0.2).front(), QString("Select Under Pointer"));
        QCOMPARE(test.selected(), std::vector<Key>{yardBall});
        const QList<QAction*> pile = test.menu.actions().front()->menu()->actions();
        QCOMPARE(pile.size(), 2);
        QVERIFY(pile[0]->isChecked() && !pile[1]->isChecked());
        pile[1]->trigger();
        QCOMPARE(test.selected(), std::vector<Key>{yardBox});
        test.entriesAt(-2, 0.2); // what is selected there stays so
        QCOMPARE(test.selected(), std::vector<Key>{yardBox});
    }

    void aNodeIsInsertedWhereThePointerIs() {
        MenuWindow test;
        test.window->toolbox().snap.grid = true;
        test.entriesAt(1.02, -2);
        test.entry("Insert Node Here")->trigger();
        const auto& chain =
            std::get<EdgeChain>(std::get<BodyObject>(test.level().objects.find(yardWall)->data).shapes.front());
        QCOMPARE(chain.vertices.size(), std::size_t{3});
        QCOMPARE(chain.vertices[1], Vec2(1, -2));
        QCOMPARE(test.window->toolbox().current(), ToolId::Nodes);
        QCOMPARE(test.document().selection().nodes(), (std::vector<NodeRef>{{yardWall, 0, 1}}));
        test.trigger(Act::Undo);
        QVERIFY(test.level() == menuYard());
    }

    void withoutAnEdgeAtThePointerNoNodeIsInserted() {
        MenuWindow test;
        test.entriesAt(0, -2);
        QTest::mouseMove(&test.canvas(), test.at(0, 3));
        test.trigger(Act::InsertNode);
        QVERIFY(test.level() == menuYard());
        QVERIFY(!test.window->statusLine().currentMessage().isEmpty());
    }

    void editNodesTakesTheNodeTool() {
        MenuWindow test;
        test.entriesAt(0, -2);
        test.entry("Edit Nodes")->trigger();
        QCOMPARE(test.window->toolbox().current(), ToolId::Nodes);
        QCOMPARE(test.selected(), std::vector<Key>{yardWall});
        QVERIFY(!test.entriesAt(2, 2).contains("Edit Nodes"));
    }

    void onANodeStandsWhatCanBeDoneWithNodes() {
        MenuWindow test;
        test.document().select(Selection({yardBox}));
        test.trigger(ToolId::Nodes);
        const QStringList ofNode = test.entriesAt(-1, 1);
        QCOMPARE(test.document().selection().nodes(), (std::vector<NodeRef>{{yardBox, 0, 2}}));
        QVERIFY(ofNode.contains("Delete") && ofNode.contains("Break at Nodes"));
        QVERIFY(!ofNode.contains("Insert Node Here") && !ofNode.contains("Group") && !ofNode.contains("Paste"));
        const QStringList ofEdge = test.entriesAt(-3, 0);
        QCOMPARE(ofEdge.front(), QString("Insert Node Here"));
        QVERIFY(ofEdge.contains("Delete Segments") && ofEdge.contains("Make Straight in 15° Steps"));
    }

    void theMenuKeyOpensItAtTheSelection() {
        MenuWindow test;
        test.canvas().disconnect(test.window.get());
        QSignalSpy wanted(&test.canvas(), &Canvas::menuKeyPressed);
        QContextMenuEvent event(QContextMenuEvent::Keyboard, QPoint(5, 5), test.canvas().mapToGlobal(QPoint(5, 5)));
        QApplication::sendEvent(&test.canvas(), &event);
        QCOMPARE(wanted.count(), 1);
        test.document().select(Selection({yardBox}));
        const QPoint place = test.window->placeOfSelection();
        QCOMPARE(test.canvas().mapFromGlobal(place), test.at(-2, 0));
        QCOMPARE(test.canvas().pointerPosition(),
                 test.canvas().view().toWorld(Vec2(test.at(-2, 0).x(), test.at(-2, 0).y())));
        fillMenuOfSelection(*test.window, test.menu);
        QVERIFY(textsOf(test.menu).contains("Duplicate") && !textsOf(test.menu).contains("Select Under Pointer"));
    }

    void whileASimulationRunsTheMenuKeyFindsWhatFallsWhereItIs() {
        TestWindow test;
        Level level;
        level.gravity = {0, -10};
        level.objects.append(
            yardObject(yardBall, BodyObject{.kind = BodyKind::Dynamic, .shapes = {Circle{{0, 0}, 0.5}}}));
        test.document().reset(level);
        test.document().select(Selection({yardBall}));
        test.trigger(Act::Simulate);
        const QPoint start = test.at(0, 0);
        QTRY_VERIFY(test.canvas().mapFromGlobal(test.window->placeOfSelection()).y() > start.y() + 20);
    }

    void theMenuOfTheOutlinerIsAboutItsRows() {
        MenuWindow test;
        test.document().select(Selection({yardBox}));
        fillMenuOfOutliner(*test.window, test.menu);
        const QStringList texts = textsOf(test.menu);
        for (const char* text : {"Rename…", "New Layer", "Hide", "Lock", "Order", "Delete"}) {
            QVERIFY2(texts.contains(text), text);
        }
        QVERIFY(!texts.contains("Play from Pointer") && !texts.contains("Ungroup"));
    }
};

SPACETOW_TEST(ContextMenuTest)
#include "context_menu_test.moc"
