#include "editor/panels/outliner_panel.h"

#include "core/level/edits.h"
#include "core/level/groups.h"
#include "tests/support/body_with.h"
#include "tests/support/cpu_time.h"
#include "tests/support/test_main.h"
#include "tests/support/window.h"

#include <QDockWidget>
#include <QDropEvent>
#include <QMenu>
#include <QMimeData>
#include <QScrollBar>
#include <QSignalSpy>

#include <map>

using namespace spacetow;
using namespace spacetow::test;

namespace {

Object inGroup(Object object, Key parent) {
    object.parent = parent;
    return object;
}

/// A group (3) of two walls (4, 5) and 200 balls (100 and following) on top of it.
Level crowd() {
    Level level;
    level.objects.append({3, "walls", GroupObject{}, {}});
    level.objects.append(inGroup(bodyWith(4, EdgeChain{{{0, 0}, {1, 0}}}), 3));
    level.objects.append(inGroup(bodyWith(5, EdgeChain{{{0, 1}, {1, 1}}}), 3));
    for (Key key = 100; key < 300; ++key) {
        level.objects.append(bodyWith(key, Circle{{0, 0}, 1}));
    }
    return level;
}

struct Outlined {
    Outlined() : document(crowd()), toolbox(document, 1), panel(document, toolbox) {
        panel.resize(300, 400);
        panel.show();
    }
    Document document;
    Toolbox toolbox;
    OutlinerPanel panel;

    QModelIndex at(Key key, int column = OutlinerModel::Name) { return panel.model().indexOf(key, column); }
    void click(Key key, int column = OutlinerModel::Name, Qt::KeyboardModifiers modifiers = {}) {
        panel.view().scrollTo(at(key));
        QTest::mouseClick(panel.view().viewport(), Qt::LeftButton, modifiers,
                          panel.view().visualRect(at(key, column)).center());
    }
    void key(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) { QTest::keyClick(&panel.view(), key, modifiers); }
    const Object& object(Key key) { return *document.level().objects.find(key); }
    std::vector<Key> selectedRows() {
        std::vector<Key> keys;
        for (const QModelIndex& index : panel.view().selectionModel()->selectedRows()) {
            keys.push_back(OutlinerModel::keyOf(index));
        }
        std::ranges::sort(keys);
        return keys;
    }
    void become(Level level) {
        document.commit({"change", 1}, {std::make_shared<const Level>(std::move(level)), document.selection()});
    }
};

using RowKeys = std::vector<Key>;

} // namespace

class OutlinerPanelTest : public QObject {
    Q_OBJECT

  private slots:
    void rowsAndObjectsAreSelectedTogether() {
        Outlined test;
        test.click(299);
        QCOMPARE(test.document.selection().keys(), (RowKeys{299}));
        test.click(297, OutlinerModel::Name, Qt::ShiftModifier);
        QCOMPARE(test.document.selection().keys(), (RowKeys{297, 298, 299}));
        test.click(298, OutlinerModel::Name, Qt::ControlModifier);
        QCOMPARE(test.document.selection().keys(), (RowKeys{297, 299}));
        test.document.select(Selection({100, 150}));
        QCOMPARE(test.selectedRows(), (RowKeys{100, 150}));
        test.document.select({});
        QCOMPARE(test.selectedRows(), RowKeys());
        QVERIFY(test.document.history().empty());
    }

    void whatIsSelectedOnTheCanvasComesIntoSight() {
        Outlined test;
        test.document.select(Selection({4}).entering(3));
        QVERIFY(test.panel.view().isExpanded(test.at(3)));
        QVERIFY(test.panel.view().viewport()->rect().contains(test.panel.view().visualRect(test.at(4)).center()));
        QVERIFY(test.at(3).data(Qt::FontRole).value<QFont>().bold());
        test.document.select({});
        QVERIFY(!test.at(3).data(Qt::FontRole).value<QFont>().bold());
    }

    void aMemberThatIsClickedIsReachedByEnteringItsGroup() {
        Outlined test;
        test.panel.view().expand(test.at(3));
        test.click(5);
        QCOMPARE(test.document.selection(), Selection({5}).entering(3));
        test.click(3);
        QCOMPARE(test.document.selection(), Selection({3}));
    }

    void eyeAndLockOfOneOfSeveralSwitchAll() {
        Outlined test;
        test.click(299, OutlinerModel::Eye);
        QVERIFY(!test.object(299).visible && test.object(298).visible);
        QVERIFY(test.document.selection().empty());
        test.document.select(Selection({296, 297}));
        test.click(296, OutlinerModel::Lock);
        QVERIFY(test.object(296).locked && test.object(297).locked && !test.object(299).locked);
        test.click(298, OutlinerModel::Lock); // not among those selected
        QVERIFY(test.object(298).locked && test.object(297).locked);
        QCOMPARE(test.document.selection().keys(), (RowKeys{296, 297}));
        QCOMPARE(test.document.history().size(), std::size_t{3});
        test.document.undo();
        test.document.undo();
        QVERIFY(!test.object(297).locked);
    }

    void theKeyboardHidesAndReorders() {
        Outlined test;
        test.click(298);
        test.key(Qt::Key_Space);
        QVERIFY(!test.object(298).visible);
        test.key(Qt::Key_Space);
        QVERIFY(test.object(298).visible);
        test.key(Qt::Key_Up, Qt::AltModifier);
        QCOMPARE(test.at(298).row(), 0);
        test.key(Qt::Key_Up, Qt::AltModifier); // there is nothing above
        QCOMPARE(test.at(298).row(), 0);
        test.key(Qt::Key_Down, Qt::AltModifier);
        test.key(Qt::Key_Down, Qt::AltModifier);
        QCOMPARE(test.at(298).row(), 2);
        test.key(Qt::Key_End);
        QCOMPARE(test.document.selection().keys(), (RowKeys{3}));
        test.key(Qt::Key_Right);
        QVERIFY(test.panel.view().isExpanded(test.at(3)));
        test.key(Qt::Key_Down, Qt::AltModifier);
        QCOMPARE(test.at(3).row(), 200);
        const QSignalSpy wanted(&test.panel, &OutlinerPanel::viewWanted);
        test.key(Qt::Key_Return);
        QCOMPARE(wanted.count(), 1);
    }

    void anEditLeavesScrollingAndUnfoldedGroups() {
        Outlined test;
        test.panel.view().expand(test.at(3));
        test.panel.view().verticalScrollBar()->setValue(100);
        const QModelIndex top = test.panel.view().indexAt({5, 5});
        test.become(renamed(test.document.level(), 150, "stone"));
        test.become(removed(test.document.level(), RowKeys{101}));
        QVERIFY(test.panel.view().isExpanded(test.at(3)));
        QCOMPARE(test.panel.view().indexAt({5, 5}), top);
        test.become(regrouped(test.document.level(), RowKeys{3}, {0, 0}));
        QVERIFY(test.panel.view().isExpanded(test.at(3)));
        test.panel.view().collapse(test.at(3));
        test.click(250);
        test.become(regrouped(test.document.level(), RowKeys{250}, {3, 0}));
        QVERIFY(test.panel.view().isExpanded(test.at(3))); // what is selected does not vanish in a group
        // So many rows that the view begins anew.
        RowKeys every;
        for (Key key = 100; key < 300; key += 2) {
            every.push_back(key);
        }
        for (Key key = 1000; key < 2000; ++key) {
            every.push_back(key);
        }
        Level level = test.document.level();
        for (Key key = 1000; key < 2000; ++key) {
            level.objects.insert(static_cast<int>(2 * (key - 1000)) % level.objects.size(), bodyWith(key, Circle{}));
        }
        test.become(level);
        test.become(removed(test.document.level(), every));
        QVERIFY(test.panel.view().isExpanded(test.at(3)));
    }

    void theFilterUnfoldsWhatItFindsAndFoldsItUpAgain() {
        Outlined test;
        test.panel.filterField().setText("kind:wall");
        QCOMPARE(test.panel.model().rowCount(), 1);
        QVERIFY(test.panel.view().isExpanded(test.at(3)));
        QVERIFY(!test.at(100).isValid());
        QTest::keyClick(&test.panel.filterField(), Qt::Key_Escape);
        QVERIFY(test.panel.filterField().text().isEmpty());
        QCOMPARE(test.panel.model().rowCount(), 201);
        QVERIFY(!test.panel.view().isExpanded(test.at(3)));
    }

    void allThatIsFoundCanBeSelected() {
        Outlined test;
        test.panel.filterField().setText("kind:wall");
        test.key(Qt::Key_A, Qt::ControlModifier);
        QCOMPARE(test.document.selection().keys(), (RowKeys{4, 5})); // not their group
        test.document.select({});
        QTest::keyClick(&test.panel.filterField(), Qt::Key_Return);
        QCOMPARE(test.document.selection(), Selection({4, 5}).entering(3));
        QCOMPARE(test.selectedRows(), (RowKeys{4, 5}));
        const auto ink = [&test](Key key) { return test.at(key).data(Qt::ForegroundRole).value<QColor>(); };
        QCOMPARE(ink(3), test.panel.palette().color(QPalette::Disabled, QPalette::Text)); // it only leads there
        QCOMPARE(ink(4), test.panel.palette().color(QPalette::Active, QPalette::Text));
    }

    void rowsAreDroppedOnGroupsAndBetweenRows() {
        Outlined test;
        test.panel.view().scrollToBottom();
        const auto drop = [&test](Key key, const QPoint& at) {
            const std::unique_ptr<QMimeData> data(test.panel.model().mimeData({test.at(key)}));
            QWidget* const viewport = test.panel.view().viewport();
            QDragEnterEvent enter(at, Qt::MoveAction, data.get(), Qt::LeftButton, {});
            QApplication::sendEvent(viewport, &enter);
            QDragMoveEvent move(at, Qt::MoveAction, data.get(), Qt::LeftButton, {});
            QApplication::sendEvent(viewport, &move);
            QDropEvent end(at, Qt::MoveAction, data.get(), Qt::LeftButton, {});
            QApplication::sendEvent(viewport, &end);
        };
        const auto rect = [&test](Key key) { return test.panel.view().visualRect(test.at(key)); };
        drop(299, rect(3).center());
        QCOMPARE(test.at(299).parent(), test.at(3));
        QCOMPARE(test.at(299).row(), 0);
        QVERIFY(test.panel.view().isExpanded(test.at(3))); // what was dropped is to be seen
        test.panel.view().scrollToBottom();
        drop(298, {rect(3).center().x(), rect(3).bottom()}); // above the first member
        QCOMPARE(test.at(298).parent(), test.at(3));
        QCOMPARE(test.at(298).row(), 0);
        drop(297, {rect(4).center().x(), rect(4).top()});
        QCOMPARE(test.at(297).row(), test.at(4).row() - 1);
        QCOMPARE(test.at(297).parent(), test.at(3));
        drop(296, {rect(3).center().x(), rect(3).top()});
        QCOMPARE(test.at(296).row(), test.at(3).row() - 1);
        QVERIFY(!test.at(296).parent().isValid());
        drop(295, rect(5).center()); // nothing can be in a wall, so it comes to stand beside it
        QCOMPARE(test.at(295).parent(), test.at(3));
        QCOMPARE(test.document.history().size(), std::size_t{5});
        drop(3, rect(5).center()); // not into itself
        QCOMPARE(test.document.history().size(), std::size_t{5});
    }

    void theFilterCanBeChosenFromAMenu() {
        Outlined test;
        QMenu menu;
        test.panel.fillFilterMenu(menu);
        const auto choose = [&menu](const QString& text) {
            for (QAction* action : menu.findChildren<QAction*>()) {
                if (action->text() == text && action->menu() == nullptr) {
                    action->trigger();
                    return true;
                }
            }
            return false;
        };
        QVERIFY(choose("circle"));
        QCOMPARE(test.panel.model().rowCount(), 200);
        QVERIFY(choose("hidden"));
        QCOMPARE(test.panel.filterField().text(), QString("kind:circle is:hidden"));
        QCOMPARE(test.panel.model().rowCount(), 0);
        QVERIFY(choose("hidden"));
        QVERIFY(choose("circle"));
        QVERIFY(test.panel.filterField().text().isEmpty());
    }

    void outOfSightItWaits() {
        Outlined test;
        test.panel.hide();
        test.become(removed(test.document.level(), RowKeys{299}));
        test.document.select(Selection({298}));
        QCOMPARE(test.panel.model().rowCount(), 201);
        test.panel.show();
        QCOMPARE(test.panel.model().rowCount(), 200);
        QCOMPARE(test.selectedRows(), (RowKeys{298}));
    }

    void aLargeLevelIsFollowedWithoutDelay() {
        Level level;
        level.objects.append({3, "pair", GroupObject{}, {}});
        constexpr int size = 100'000;
        for (Key key = 100; key < 100 + size; ++key) {
            level.objects.append(inGroup(bodyWith(key, Circle{{0, 0}, 1}), key % 50 == 0 ? 3 : 0));
        }
        Outlined test;
        std::map<std::string, double> seconds; // that the processor was busy
        const auto timed = [&seconds](const char* what, const auto& action) {
            const CpuTimer timer;
            action();
            QApplication::processEvents();
            seconds[what] = timer.seconds();
        };
        timed("open", [&] { test.document.reset(level); });
        timed("select one", [&] { test.document.select(Selection({5000})); });
        timed("hide one", [&] { test.become(withVisible(test.document.level(), RowKeys{5001}, false)); });
        timed("add one", [&] { test.become(added(test.document.level(), bodyWith(5, Circle{{0, 0}, 1}))); });
        timed("regroup one", [&] { test.become(regrouped(test.document.level(), RowKeys{5001}, {3, 0})); });
        timed("filter", [&] { test.panel.filterField().setText("is:hidden"); });
        QCOMPARE(test.panel.model().rowCount(), 1);
        timed("filter no more", [&] { test.panel.filterField().clear(); });
        RowKeys all;
        for (Key key = 100; key < 100 + size; ++key) {
            all.push_back(key);
        }
        timed("select all", [&] { test.document.select(Selection(all)); });
        timed("delete all", [&] { test.become(removed(test.document.level(), all)); });
        timed("undo", [&] { test.document.undo(); });
        for (const char* what : {"select one", "hide one", "add one", "regroup one"}) {
            QVERIFY2(seconds[what] < 0.25, what);
        }
        for (const char* what : {"open", "filter", "filter no more", "select all", "delete all", "undo"}) {
            QVERIFY2(seconds[what] < 1.5, what);
        }
    }

    void findAndRenameLeadIntoThePanel() {
        TestWindow test;
        test.document().reset(crowd());
        test.window->panels().dock("outliner").close();
        test.document().select(Selection({4}).entering(3));
        test.trigger(Act::Rename);
        QWidget* editor = test.window->outliner().view().viewport()->findChild<QLineEdit*>();
        QVERIFY(editor != nullptr && editor->isVisible());
        QTest::keyClicks(editor, "floor");
        QTest::keyClick(editor, Qt::Key_Return);
        QApplication::processEvents(); // views enter what was typed a moment later
        QCOMPARE(test.level().objects.find(4)->name, std::string("floor"));
        test.trigger(Act::Find);
        QVERIFY(test.window->outliner().filterField().hasFocus());
        test.key(Qt::Key_Z, Qt::ControlModifier); // nothing is typed here yet
        QVERIFY(test.level().objects.find(4)->name.empty());
        test.key(Qt::Key_Escape);
        QVERIFY(test.canvas().hasFocus());
    }

    void renamingLeavesTheViewAndTheKeyboardWhereTheyWere() {
        TestWindow test;
        test.document().reset(crowd());
        test.document().select(Selection({4}));
        test.canvas().setFocus();
        const Vec2 center = test.canvas().view().center;
        test.key(Qt::Key_F2);
        QTest::keyClicks(QApplication::focusWidget(), "gate");
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
        QApplication::processEvents();
        QCOMPARE(test.level().objects.find(4)->name, std::string("gate"));
        QCOMPARE(test.canvas().view().center, center);
        QVERIFY(test.canvas().hasFocus());
    }

    void aNewLayerIsNamedAtOnce_data() {
        QTest::addColumn<QString>("filter");
        QTest::newRow("of all") << QString();
        QTest::newRow("which the filter does not find") << QStringLiteral("kind:wall");
    }
    void aNewLayerIsNamedAtOnce() {
        QFETCH(QString, filter);
        TestWindow test;
        test.document().reset(crowd());
        test.window->outliner().filterField().setText(filter);
        test.window->panels().dock("outliner").close();
        test.document().select(Selection({100}));
        test.trigger(Act::NewLayer);
        test.key(Qt::Key_H); // which hides what is selected elsewhere
        QWidget* editor = QApplication::focusWidget();
        QVERIFY(test.window->outliner().view().viewport()->isAncestorOf(editor));
        QTest::keyClicks(editor, "ills");
        QTest::keyClick(editor, Qt::Key_Return);
        QApplication::processEvents(); // views enter what was typed a moment later
        const Object& ball = *test.level().objects.find(100);
        QVERIFY(ball.visible);
        QCOMPARE(test.level().objects.find(ball.parent)->name, std::string("hills"));
        QCOMPARE(test.document().selection(), Selection({100}));
    }

    void keysOfTheTreeAreNotThoseOfTheCanvas() {
        TestWindow test;
        test.document().reset(crowd());
        OutlinerView& view = test.window->outliner().view();
        view.setFocus();
        view.setCurrentIndex(test.window->outliner().model().indexOf(150));
        const std::vector<Label> before = test.document().history();
        for (const Qt::Key key : {Qt::Key_Home, Qt::Key_End, Qt::Key_PageUp, Qt::Key_PageDown, Qt::Key_Down}) {
            test.key(key);
        }
        QCOMPARE(test.document().history(), before);
        view.setCurrentIndex(test.window->outliner().model().indexOf(150));
        test.key(Qt::Key_Delete);
        QCOMPARE(test.level().objects.size(), 202);
    }
};

SPACETOW_TEST(OutlinerPanelTest)
#include "outliner_panel_test.moc"
