#include "editor/window/panels.h"

#include "editor/window/finder_rows.h"
#include "editor/window/key_bindings.h"
#include "editor/window/messages.h"
#include "tests/support/test_main.h"
#include "tests/support/window.h"

#include <QDockWidget>
#include <QMenu>
#include <QMenuBar>
#include <QStyleOptionTab>
#include <QTabBar>
#include <QToolBar>

#include <algorithm>

using namespace spacetow;
using spacetow::test::TestWindow;

namespace {

QDockWidget& dockOf(TestWindow& test, const char* name) {
    return test.window->panels().dock(QLatin1String(name));
}

struct Placed {
    bool visible, floating;
    Qt::DockWidgetArea area;
    QRect place;

    bool operator==(const Placed&) const = default;
};

std::map<QString, Placed> placesOf(TestWindow& test) {
    QApplication::processEvents();
    std::map<QString, Placed> places;
    for (const PanelRow& row : panelRows()) {
        const QDockWidget& one = dockOf(test, row.name);
        places[row.name] = {one.isVisible(), one.isFloating(),
                            test.window->dockWidgetArea(&const_cast<QDockWidget&>(one)),
                            one.isVisible() ? one.geometry() : QRect()};
    }
    return places;
}

bool anyShown(TestWindow& test) {
    for (const PanelRow& row : panelRows()) {
        if (dockOf(test, row.name).isVisible()) {
            return true;
        }
    }
    return false;
}

} // namespace

class PanelsTest : public QObject {
    Q_OBJECT

  private slots:
    void theMenuListsEveryPanelOnce() {
        TestWindow test;
        for (const PanelRow& row : panelRows()) {
            int times = 0;
            for (const QMenu* menu : test.window->menuBar()->findChildren<QMenu*>()) {
                times += static_cast<int>(menu->actions().count(dockOf(test, row.name).toggleViewAction()));
            }
            QVERIFY2(times == 1, row.name);
            QVERIFY2(!dockOf(test, row.name).windowTitle().isEmpty(), row.name);
            QVERIFY2(dockOf(test, row.name).isVisible() == row.shownAtFirst, row.name);
        }
    }

    void everyPanelHasAKeyOfItsOwn() {
        TestWindow test;
        for (const PanelRow& row : panelRows()) {
            const QKeySequence key = dockOf(test, row.name).toggleViewAction()->shortcut();
            QVERIFY2(!key.isEmpty(), row.name);
            const KeyOwner* owner = KeyBindings().ownerOf(key);
            QVERIFY2(owner != nullptr && owner->code == codeOf(row), row.name);
        }
    }

    void ofPanelsInOnePlaceTheFirstIsInFront() {
        TestWindow test;
        QApplication::processEvents();
        for (const PanelRow& row : panelRows()) {
            QVERIFY2(row.tabOf != nullptr || !row.shownAtFirst || !dockOf(test, row.name).visibleRegion().isEmpty(),
                     row.name);
        }
    }

    void tabOnTheCanvasPutsThePanelsAwayAndBack() {
        TestWindow test;
        const auto before = placesOf(test);
        test.canvas().setFocus();
        test.key(Qt::Key_Tab);
        QVERIFY(!anyShown(test));
        QVERIFY(!test.window->findChild<QToolBar*>("tools")->isVisible());
        QVERIFY(test.window->actions()[Act::HidePanels].isChecked());
        QVERIFY(test.canvas().hasFocus());
        test.key(Qt::Key_Tab);
        QVERIFY(placesOf(test) == before);
        QVERIFY(!test.window->actions()[Act::HidePanels].isChecked());
    }

    void tabInAPanelGoesToTheNextField() {
        TestWindow test;
        QWidget* field = test.window->inspector().form().editor("name");
        field->setFocus();
        QTest::keyClick(field, Qt::Key_Tab);
        QVERIFY(anyShown(test));
        QVERIFY(!field->hasFocus());
        QVERIFY(test.window->focusWidget() != nullptr && test.window->focusWidget() != &test.canvas());
    }

    void theInspectorIsWideWhereThereIsRoom() {
        TestWindow test;
        const QWidget& inspector = *dockOf(test, "inspector").widget();
        for (const int width : {800, 1280}) {
            test.window->resize(width, 800);
            QApplication::processEvents();
            test.window->panels().widenInspector();
            QApplication::processEvents();
            QCOMPARE(inspector.width() >= inspector.sizeHint().width(), width == 1280);
        }
    }

    void severalPanelsInOnePlaceAreNamedInFull() {
        TestWindow test;
        for (const char* name : {"outliner", "problems", "history", "nodes", "minimap"}) {
            dockOf(test, name).show();
        }
        test.window->resize(1280, 800);
        QApplication::processEvents();
        QStringList named;
        for (const QTabBar* bar : test.window->findChildren<QTabBar*>()) {
            for (int i = 0; i < (bar->isVisible() ? bar->count() : 0); ++i) {
                QStyleOptionTab option;
                option.initFrom(bar);
                option.rect = bar->tabRect(i);
                option.shape = bar->shape();
                option.text = bar->tabText(i);
                const int room = bar->style()->subElementRect(QStyle::SE_TabBarTabText, &option, bar).width();
                QVERIFY2(room >= bar->fontMetrics().horizontalAdvance(option.text), qPrintable(option.text));
                named << option.text;
            }
        }
        for (const char* name : {"Outliner", "Problems", "History", "Nodes", "Minimap"}) {
            QVERIFY2(named.contains(QLatin1String(name)), name);
        }
    }

    void playLeavesThePanelsOutOfTheWay() {
        TestWindow test;
        test.window->openExample();
        test.window->addDockWidget(Qt::LeftDockWidgetArea, &dockOf(test, "problems"));
        const auto before = placesOf(test);
        test.trigger(Act::Play);
        QVERIFY(!anyShown(test));
        QVERIFY(test.window->findChild<QToolBar*>("main")->isVisible());
        test.trigger(Act::Stop);
        QVERIFY(placesOf(test) == before);
        QVERIFY(test.window->findChild<QToolBar*>("tools")->isVisible());
    }

    void aPanelCanBeCalledWhereverThereIsALevel() {
        TestWindow test;
        const auto possible = [&test] {
            const QList<QAction*> actions = test.window->panels().actions();
            const FinderRows rows(*test.window);
            const auto count = std::ranges::count_if(actions, &QAction::isEnabled);
            for (int i = 0; i < rows.few(); ++i) {
                if (rows.kind(i) == FindKind::Panel && rows.row(i).isPossible != (count > 0)) {
                    return qsizetype(-1);
                }
            }
            return qsizetype(count);
        };
        const qsizetype all = qsizetype(panelRows().size());
        test.window->showWelcome();
        QCOMPARE(possible(), 0);
        test.window->openExample();
        QCOMPARE(possible(), all);
        test.trigger(Act::Play);
        QVERIFY(!anyShown(test));
        QCOMPARE(possible(), all);
        test.trigger(Act::Stop);
        QCOMPARE(possible(), all);
    }

    void goingToAProblemBringsWhatItSaysIntoSight() {
        TestWindow test;
        test.document().reset(TestWindow::twoBallsAtOneSpot());
        const QDockWidget& problems = dockOf(test, "problems");
        const auto isInFront = [&problems] {
            QApplication::processEvents();
            return problems.isVisible() && !problems.visibleRegion().isEmpty();
        };
        QVERIFY(!isInFront());
        test.trigger(Act::NextProblem);
        QVERIFY(isInFront());
        dockOf(test, "problems").close();
        test.trigger(Act::PreviousProblem);
        QVERIFY(isInFront());
        test.trigger(Act::HidePanels);
        test.trigger(Act::NextProblem);
        QVERIFY(!isInFront());
        const Problem* const problem = test.window->problems().currentProblem();
        QVERIFY(problem != nullptr);
        QCOMPARE(test.window->statusLine().currentMessage(), sentence(*problem));
    }

    void theActionOfAPanelBringsItToTheFront() {
        TestWindow test;
        QDockWidget& history = dockOf(test, "history");
        const auto isInFront = [&history] { return history.isVisible() && !history.visibleRegion().isEmpty(); };
        history.toggleViewAction()->trigger();
        QApplication::processEvents();
        QVERIFY(isInFront());
        dockOf(test, "outliner").raise();
        QApplication::processEvents();
        QVERIFY(!isInFront());
        history.toggleViewAction()->trigger();
        QApplication::processEvents();
        QVERIFY(isInFront());
        history.toggleViewAction()->trigger();
        QVERIFY(!history.isVisible());
    }

    void theKeyOfAPanelLeadsIntoItAndClosesItFromWithin() {
        TestWindow test;
        test.canvas().setFocus();
        QDockWidget& inspector = dockOf(test, "inspector");
        const auto press = [&test] { test.key(Qt::Key_1, Qt::ControlModifier | Qt::AltModifier); };
        const auto isInside = [&inspector] {
            const QWidget* typing = QApplication::focusWidget();
            return inspector.isVisible() && typing != nullptr && inspector.isAncestorOf(typing) &&
                   typing->objectName() == "name"; // its first field
        };
        press();
        QVERIFY(isInside());
        press();
        QVERIFY(!inspector.isVisible() && test.canvas().hasFocus());
        press();
        QVERIFY(isInside());
        test.key(Qt::Key_Escape);
        QVERIFY(test.canvas().hasFocus() && inspector.isVisible());
        inspector.toggleViewAction()->trigger(); // as the menu does
        QVERIFY(!inspector.isVisible());
    }

    void aPanelThatIsCalledHasRoomForWhatItShows() {
        TestWindow test;
        test.window->resize(1280, 900);
        for (const char* name : {"explain", "plots", "profile", "tagMatrix"}) {
            QDockWidget& called = dockOf(test, name);
            called.toggleViewAction()->trigger();
            QApplication::processEvents();
            const auto row = std::ranges::find(panelRows(), std::string_view(name), &PanelRow::name);
            QVERIFY2(called.height() >= row->height - 30, qPrintable(QString::number(called.height())));
            QVERIFY(dockOf(test, "inspector").height() > 200);
            called.toggleViewAction()->trigger();
            test.window->resizeDocks({&dockOf(test, "outliner")}, {150}, Qt::Vertical);
        }
    }

    void aPanelClosedBeforePlayStaysClosed() {
        TestWindow test;
        test.window->openExample();
        dockOf(test, "problems").close();
        test.trigger(Act::Play);
        test.trigger(Act::Stop);
        QVERIFY(!dockOf(test, "problems").isVisible());
        QVERIFY(dockOf(test, "inspector").isVisible());
    }

    void hiddenPanelsStayHiddenThroughAGame() {
        TestWindow test;
        test.window->openExample();
        const auto before = placesOf(test);
        test.trigger(Act::HidePanels);
        test.trigger(Act::Play);
        test.trigger(Act::Stop);
        QVERIFY(!anyShown(test));
        test.trigger(Act::HidePanels);
        QVERIFY(placesOf(test) == before);
    }

    void panelsComeBackAsTheyWereLeft_data() {
        QTest::addColumn<bool>("playing");
        QTest::newRow("closed while editing") << false;
        QTest::newRow("closed while playing") << true;
    }
    void panelsComeBackAsTheyWereLeft() {
        QFETCH(bool, playing);
        TestWindow test;
        test.window->tabifyDockWidget(&dockOf(test, "inspector"), &dockOf(test, "problems"));
        dockOf(test, "problems").raise();
        QApplication::processEvents();
        if (playing) {
            test.trigger(Act::Play);
        }
        QVERIFY(test.window->close());
        test.reopen();
        QVERIFY(test.window->tabifiedDockWidgets(&dockOf(test, "inspector")).contains(&dockOf(test, "problems")));
        dockOf(test, "problems").close();
        QVERIFY(test.window->close());
        test.reopen();
        QVERIFY(!dockOf(test, "problems").isVisible());
        QVERIFY(dockOf(test, "inspector").isVisible());
    }
};

SPACETOW_TEST(PanelsTest)
#include "panels_test.moc"
