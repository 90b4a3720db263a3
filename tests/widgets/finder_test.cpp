#include "editor/window/finder.h"

#include "core/level/file.h"
#include "tests/support/game_levels.h"
#include "tests/support/test_main.h"
#include "tests/support/window.h"
#include "tests/support/windows.h"

#include <QDockWidget>

#include <algorithm>
#include <set>

using namespace spacetow;
using spacetow::test::TestWindow;

namespace {

QStringList namesFound(const Finder& finder) {
    QStringList names;
    const QAbstractItemModel& model = *finder.findChild<QListView*>()->model();
    for (int row = 0; row < model.rowCount(); ++row) {
        names << model.index(row, 0).data().toString();
    }
    return names;
}

/// Opens the palette by its key and types.
Finder& searchFor(TestWindow& test, const QString& typed) {
    test.trigger(Act::CommandPalette);
    Finder& finder = test.window->finder();
    QTest::keyClicks(&finder.field(), typed);
    finder.model().finish();
    return finder;
}

void pressIn(Finder& finder, Qt::Key key) {
    QTest::keyClick(&finder.field(), key);
}

Level rocks(int count) {
    Level level;
    for (int i = 0; i < count; ++i) {
        Object rock;
        rock.key = static_cast<Key>(i + 1);
        rock.name = "rock " + std::to_string(i);
        rock.data = BodyObject{.shapes = {Circle{{0, 0}, 0.5}}, .position = {3.0 * i, 1}};
        level.objects.append(rock);
    }
    return level;
}

} // namespace

class FinderTest : public QObject {
    Q_OBJECT

  private slots:
    void aFewLettersAndEnterRunAnAction() {
        TestWindow test;
        Finder& finder = searchFor(test, "zom in");
        QCOMPARE(namesFound(finder).front(), QString("Zoom In"));
        const double scale = test.canvas().view().scale;
        pressIn(finder, Qt::Key_Return);
        QVERIFY(test.canvas().view().scale > scale);
        QVERIFY(!finder.isVisible());
        QVERIFY(test.canvas().hasFocus());
    }

    void aWordOfTheMenuComesBeforeScatteredLettersOfNames() {
        TestWindow test;
        const QStringList names = namesFound(searchFor(test, ">over"));
        QVERIFY(names.indexOf("Normals") >= 0 && names.indexOf("Move to Layer Above") >= 0);
        QVERIFY(names.indexOf("Normals") < names.indexOf("Move to Layer Above"));
    }

    void itSaysMenuAndKeyAndWhetherASwitchIsOn() {
        TestWindow test;
        Finder& finder = searchFor(test, ">normals");
        const FinderRow normals = finder.model().found(0);
        QCOMPARE(normals.place, QString("View ▸ Overlays"));
        QCOMPARE(normals.key, QKeySequence("Alt+5").toString(QKeySequence::NativeText));
        QVERIFY(!normals.isOn && normals.isPossible);
        pressIn(finder, Qt::Key_Return);
        QVERIFY(test.window->overlays().normals);
        searchFor(test, ">normals");
        QVERIFY(finder.model().found(0).isOn);
    }

    void escapeLeavesEverythingAsItWas() {
        TestWindow test;
        QWidget* name = test.window->inspector().form().editor("name");
        name->setFocus();
        Finder& finder = searchFor(test, "quit");
        QVERIFY(finder.field().hasFocus());
        pressIn(finder, Qt::Key_Escape);
        QVERIFY(!finder.isVisible() && name->hasFocus());
    }

    void whatIsNotPossibleSaysWhyAndStays() {
        TestWindow test;
        Finder& finder = searchFor(test, ">edit undo");
        const FinderRow undo = finder.model().found(0);
        QVERIFY(!undo.isPossible);
        QCOMPARE(undo.whyNot, QString("There is nothing to undo."));
        pressIn(finder, Qt::Key_Return);
        QVERIFY(finder.isVisible());
        // And the status bar, by the action's tip.
        QVERIFY(test.window->actions()[Act::Undo].statusTip().endsWith(undo.whyNot));
        test.drawWalls();
        QVERIFY(!test.window->actions()[Act::Undo].statusTip().contains(undo.whyNot));
    }

    void everyActionThatRestsSaysWhy() {
        TestWindow test;
        for (const bool playing : {false, true}) {
            if (playing) {
                test.window->openExample();
                test.trigger(Act::Play);
            }
            for (const ActionRow& row : actionRows()) {
                const bool rests = !test.window->actions()[row.id].isEnabled();
                QVERIFY2(test.window->actions().whyNot(row).isEmpty() != rests, row.text);
            }
        }
    }

    void theArrowsGoRoundAndPagesEnd() {
        TestWindow test;
        Finder& finder = searchFor(test, ">");
        const int last = finder.model().rowCount() - 1;
        QVERIFY(last > 50);
        const auto row = [&] { return finder.list().currentIndex().row(); };
        QCOMPARE(row(), 0);
        pressIn(finder, Qt::Key_Down);
        QCOMPARE(row(), 1);
        pressIn(finder, Qt::Key_Up);
        pressIn(finder, Qt::Key_Up);
        QCOMPARE(row(), last);
        pressIn(finder, Qt::Key_PageUp);
        QVERIFY(row() < last - 3 && row() > 0);
        for (int i = 0; i < 30; ++i) {
            pressIn(finder, Qt::Key_PageUp);
        }
        QCOMPARE(row(), 0);
        pressIn(finder, Qt::Key_PageDown);
        QVERIFY(row() > 3);
    }

    void withNothingTypedTheLatestComesFirst() {
        TestWindow test;
        Finder& finder = searchFor(test, ">fit level");
        pressIn(finder, Qt::Key_Return);
        searchFor(test, ">all off");
        pressIn(finder, Qt::Key_Return);
        searchFor(test, QString());
        QCOMPARE(namesFound(finder).mid(0, 2), (QStringList{"All Off", "Fit Level"}));
        pressIn(finder, Qt::Key_Escape);
        test.reopen();
        QCOMPARE(namesFound(searchFor(test, QString())).mid(0, 2), (QStringList{"All Off", "Fit Level"}));
    }

    void itFindsToolsAndPanels() {
        TestWindow test;
        Finder& finder = searchFor(test, "knife");
        pressIn(finder, Qt::Key_Return);
        QCOMPARE(test.window->toolbox().current(), ToolId::Knife);
        searchFor(test, "tag matrix");
        QCOMPARE(finder.model().found(0).kind, FindKind::Panel);
        pressIn(finder, Qt::Key_Return);
        QVERIFY(test.window->panels().dock("tagMatrix").isVisible());
    }

    void itJumpsToObjectsByNameAndKind() {
        TestWindow test;
        test.document().reset(rocks(30));
        Finder& finder = searchFor(test, "@rock 17");
        QCOMPARE(namesFound(finder).front(), QString("rock 17"));
        QCOMPARE(finder.model().found(0).place, QString("Circle"));
        pressIn(finder, Qt::Key_Return);
        QCOMPARE(test.document().selection(), Selection({18}));
        const Vec2 middle =
            test.canvas().view().toWorld(Vec2(test.canvas().width() / 2.0, test.canvas().height() / 2.0));
        QVERIFY((middle - Vec2(51, 1)).norm() < 0.5);
        searchFor(test, "@circle");
        QCOMPARE(finder.model().rowCount(), 30);
    }

    void itJumpsToProblems() {
        TestWindow test;
        Level level = rocks(3);
        BodyObject crossed;
        crossed.shapes = {Polygon{{Vec2(0, 0), Vec2(2, 2), Vec2(2, 0), Vec2(0, 1)}}};
        level.objects.append({9, "crossed", crossed, {}});
        test.document().reset(level);
        test.window->problems().check();
        QVERIFY(!test.window->problems().problems().empty());
        Finder& finder = searchFor(test, "!");
        QCOMPARE(finder.model().rowCount(), static_cast<int>(test.window->problems().problems().size()));
        const auto& problems = test.window->problems().problems();
        const auto about = std::ranges::find(problems, Key{9}, &Problem::object);
        QVERIFY(about != problems.end());
        finder.list().setCurrentIndex(finder.model().index(static_cast<int>(about - problems.begin()), 0));
        pressIn(finder, Qt::Key_Return);
        QCOMPARE(test.document().selection(), Selection({9}));
    }

    void quickOpenFindsRecentNeighbouringAndShippedLevels() {
        TestWindow test;
        Level level;
        for (const char* name : {"deep_cave", "wide_cave"}) {
            level.name = name;
            QVERIFY(!writeLevel(test.file(QLatin1String(name) + ".json").toStdString(), level));
        }
        QVERIFY(!writeLevel(test.file("flight.replay.json").toStdString(), level));
        level.name = "old_cave";
        QVERIFY(!writeLevel(test.file("old_cave.json").toStdString(), level));
        QVERIFY(test.window->open(test.file("old_cave.json")));
        QVERIFY(test.window->open(test.file("deep_cave.json")));
        test.trigger(Act::QuickOpen);
        Finder& finder = test.window->finder();
        const QStringList all = namesFound(finder);
        QCOMPARE(all.front(), QString("old_cave.json")); // that was open before
        QCOMPARE(all.count("old_cave.json"), 1);
        QVERIFY(!all.contains("deep_cave.json")); // is open
        QCOMPARE(all.count("wide_cave.json"), 1);
        QVERIFY(!all.contains("flight.replay.json"));
        QVERIFY(all.contains("01_first_haul") && all.contains("01_workbench"));
        QTest::keyClicks(&finder.field(), "wicav");
        pressIn(finder, Qt::Key_Return);
        QCOMPARE(test.level().name, std::string("wide_cave"));
        test.trigger(Act::QuickOpen);
        QTest::keyClicks(&finder.field(), "first haul");
        pressIn(finder, Qt::Key_Return);
        QVERIFY(test.level().objects.size() > 3);
        QVERIFY(test.window->files().path().isEmpty()); // a copy
    }

    void quickOpenShowsWhatLevelsCallThemselvesAndFindsThemByIt() {
        TestWindow test;
        Level level;
        level.name = "Harbour of bats";
        QVERIFY(!writeLevel(test.file("b7.json").toStdString(), level));
        level.name = "Open";
        QVERIFY(!writeLevel(test.file("a.json").toStdString(), level));
        QVERIFY(test.window->open(test.file("a.json")));
        FinderRows rows(*test.window);
        const std::optional<int> bats = rows.withCode("level:" + test.file("b7.json"));
        const std::optional<int> haul = rows.withCode("level::/levels/01_first_haul.json");
        QVERIFY(bats && rows.row(*bats).name == "b7.json");
        QVERIFY2(rows.row(*bats).place.startsWith("Harbour of bats · "), qPrintable(rows.row(*bats).place));
        QVERIFY(haul && rows.row(*haul).place.startsWith("First Haul"));
        test.trigger(Act::QuickOpen);
        QTest::keyClicks(&test.window->finder().field(), "harbour");
        pressIn(test.window->finder(), Qt::Key_Return);
        QCOMPARE(test.level().name, std::string("Harbour of bats"));
    }

    void whatIsTypedInAPanelIsEnteredBefore() {
        TestWindow test;
        test.drawWalls();
        test.trigger(Act::SelectAll);
        QWidget* name = test.window->inspector().form().editor("name");
        name->setFocus();
        QTest::keyClicks(name, "7");
        searchFor(test, "fit");
        QCOMPARE(test.level().objects[0].name, std::string("7"));
    }

    void itGoesWhenTheKeyboardGoesElsewhere() {
        TestWindow test;
        Finder& finder = searchFor(test, "fit");
        QVERIFY(finder.isVisible());
        test.canvas().setFocus();
        QApplication::processEvents();
        QVERIFY(!finder.isVisible());
    }

    void nothingFoundIsSaid() {
        TestWindow test;
        Finder& finder = searchFor(test, "qxqxqx");
        QCOMPARE(finder.model().rowCount(), 0);
        QVERIFY(finder.findChild<QLabel*>()->text().contains("Nothing is called that."));
        pressIn(finder, Qt::Key_Down);
        pressIn(finder, Qt::Key_Return);
        QVERIFY(finder.isVisible());
    }

    void itFitsIntoASmallWindow() {
        TestWindow test;
        test.window->resize(800, 600);
        Finder& finder = searchFor(test, ">");
        QApplication::processEvents();
        QVERIFY(test.window->rect().contains(finder.geometry()));
        QCOMPARE(spacetow::test::cutOffTexts(finder), QStringList());
    }

    void manyObjectsAreFoundAllTheSame() {
        TestWindow test;
        test.document().reset(rocks(20'000));
        test.trigger(Act::CommandPalette);
        Finder& finder = test.window->finder();
        QTest::keyClicks(&finder.field(), "@19999");
        finder.model().finish();
        QCOMPARE(namesFound(finder), QStringList{"rock 19999"});
        QTest::keyClicks(&finder.field(), "8"); // while it may be searching
        finder.model().finish();
        QVERIFY(namesFound(finder).isEmpty());
    }

    void whatMenusListIsFoundAsWell() {
        TestWindow test;
        SnapSettings snap = test.window->toolbox().snap;
        snap.step = 2;
        test.window->setSnap(snap);
        Finder& finder = searchFor(test, ">grid step 0.5");
        QVERIFY2(namesFound(finder).contains("0.5 m"), qPrintable(namesFound(finder).join(", ")));
        QCOMPARE(namesFound(finder).front(), QString("0.5 m"));
        pressIn(finder, Qt::Key_Return);
        QCOMPARE(test.window->toolbox().snap.step, 0.5);
    }

    void theLanguagesAreFound() {
        spacetow::test::TestApplication test;
        test.start();
        const FinderRows rows(test.window(0));
        QStringList languages;
        for (int i = 0; i < rows.few(); ++i) {
            if (rows.row(i).place == menuPath(MenuId::Language)) {
                languages << rows.row(i).name;
            }
        }
        QVERIFY2(languages.contains("Deutsch") && languages.contains("Like the Desktop"),
                 qPrintable(languages.join(", ")));
    }

    void aGameWaitsWhileThePaletteIsOpenAndGoesOnAfterwards() {
        TestWindow test;
        test.document().reset(spacetow::test::openSpace());
        test.trigger(Act::Play);
        LiveRun& play = test.window->liveRun();
        const auto updates = [&] { return play.runner()->frame()->now->update; };
        QTest::keyPress(&test.canvas(), Qt::Key_Up);
        QTRY_VERIFY(updates() > 2);
        Finder& finder = searchFor(test, "fit");
        QVERIFY(finder.isVisible() && !play.isPaused());
        QVERIFY(!test.canvas().findChild<QWidget*>("pauseMenu")->isVisible());
        QTRY_VERIFY(play.runner()->frame()->paused);
        pressIn(finder, Qt::Key_Escape);
        QVERIFY(test.canvas().isLive() && test.canvas().hasFocus() && !play.isPaused());
        const auto before = updates();
        QTRY_VERIFY(updates() > before + 2);
        // What was paused stays so.
        play.setPaused(true);
        test.trigger(Act::CommandPalette);
        pressIn(finder, Qt::Key_Escape);
        QTRY_VERIFY(play.isPaused() && play.runner()->frame()->paused);
        // And an action of the game does what it says.
        pressIn(searchFor(test, ">pause"), Qt::Key_Return);
        QVERIFY(!play.isPaused());
    }

    void everyActionIsRememberedByACodeOfItsOwn() {
        std::set<QString> codes;
        for (const ActionRow& row : actionRows()) {
            QVERIFY2(codes.insert(codeOf(row)).second, row.text);
        }
        QVERIFY(codes.contains("file/save-as"));
    }
};

SPACETOW_TEST(FinderTest)
#include "finder_test.moc"
