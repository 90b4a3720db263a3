// Several windows in one program: what opens where, two views of one level, and what is remembered.

#include "tests/support/folders.h"
#include "tests/support/test_main.h"
#include "tests/support/windows.h"

#include <QFile>
#include <QMenu>
#include <QMenuBar>

using namespace spacetow;
using spacetow::test::TestApplication;

namespace {

QStringList windowNames(MainWindow& window) {
    for (QMenu* menu : window.menuBar()->findChildren<QMenu*>()) {
        if (menu->actions().contains(&window.actions()[Act::NewView])) {
            Q_EMIT menu->aboutToShow();
            QStringList names;
            for (const QAction* action : menu->actions()) {
                if (action->property("window").toBool() && !action->isSeparator()) {
                    names << action->text();
                }
            }
            return names;
        }
    }
    return {};
}

} // namespace

class ApplicationTest : public QObject {
    Q_OBJECT

  private slots:
    void allFilesThatAreNamedAreOpenedEachInItsWindow() {
        TestApplication test;
        const QString a = test.writtenLevel("a.json");
        const QString b = test.writtenLevel("b.json");
        test.start({a, b, a});
        QCOMPARE(test.count(), 2u);
        QCOMPARE(test.window(0).files().path(), a);
        QCOMPARE(test.window(1).files().path(), b);
        QVERIFY(test.window(0).isVisible() && test.window(1).isVisible());
    }

    void aFileThatCannotBeOpenedIsToldAndTheOthersAreOpened() {
        TestApplication test;
        const QString a = test.writtenLevel("a.json");
        test.start({test.file("gone.json"), a, test.file("lost.json")});
        QCOMPARE(test.count(), 1u);
        QCOMPARE(test.window(0).files().path(), a);
        const QString said = test.window(0).messageBar().text();
        QVERIFY2(said.contains("gone.json") && said.contains("lost.json"), qPrintable(said));
    }

    void aBrokenFileOffersItsNewestBackupBesideOtherWorkToo() {
        TestApplication test;
        const QString a = test.writtenLevel("a.json");
        test.start({a});
        const Level first = test.window(0).document().level();
        QVERIFY(test.window(0).files().overwrite()); // which puts aside what was there
        test.window(0).files().startOver();
        const QString b = test.writtenLevel("b.json");
        QVERIFY(test.window(0).open(b));
        QFile out(a);
        QVERIFY(out.open(QIODevice::WriteOnly | QIODevice::Truncate));
        out.write("{ nonsense");
        out.close();
        test.toOpen = {a};
        test.trigger(0, Act::Open);
        QCOMPARE(test.count(), 1u);
        QVERIFY(test.window(0).messageBar().text().contains("a.json"));
        QCOMPARE(test.window(0).messageBar().buttons().size(), std::size_t{1});
        test.window(0).messageBar().buttons().front()->click();
        QCOMPARE(test.count(), 2u);
        QCOMPARE(test.window(0).files().path(), b);
        QVERIFY(test.window(1).document().level() == first && test.window(1).isWindowModified());
    }

    void openReusesAWindowInWhichNothingWasDone() {
        TestApplication test;
        test.start();
        test.toOpen = {test.writtenLevel("a.json")};
        test.trigger(0, Act::Open);
        QCOMPARE(test.count(), 1u);
        test.toOpen = {test.writtenLevel("b.json"), test.writtenLevel("c.json")};
        test.trigger(0, Act::Open);
        QCOMPARE(test.count(), 3u);
        QCOMPARE(test.window(2).files().path(), test.toOpen[1]);
        QCOMPARE(test.asked, QStringList());
    }

    void allViewsOfALevelShareItsCheck() {
        TestApplication test;
        test.start({test.writtenLevel("a.json")});
        test.application->newView(test.window(0));
        QCOMPARE(test.count(), 2u);
        const LevelCheck& check = test.window(0).openLevel()->check;
        QTRY_VERIFY(check.isUpToDate());
        const int before = check.checks();
        Level level = *test.window(0).document().current().level;
        level.objects.append({77, {}, BodyObject(), {}}); // without a shape
        test.window(0).document().commit({"draw-polygon", 1}, {std::make_shared<const Level>(level), {}});
        QTRY_VERIFY(test.window(1).problems().errors() > 0);
        QCOMPARE(check.checks(), before + 1);
        QCOMPARE(test.window(1).problems().marks(), test.window(0).problems().marks());
    }

    void newLeavesAnEditedLevelWhereItIs() {
        TestApplication test;
        test.start({test.writtenLevel("a.json")});
        TestApplication::edit(test.window(0));
        test.trigger(0, Act::New);
        QCOMPARE(test.count(), 2u);
        QVERIFY(test.window(0).document().isModified());
        QCOMPARE(test.window(1).document().level().objects.size(), 0);
        test.trigger(1, Act::New); // where nothing has been done yet
        QCOMPARE(test.count(), 2u);
        test.trigger(1, Act::NewWindow); // but if one asks for it
        QCOMPARE(test.count(), 3u);
        QCOMPARE(test.asked, QStringList());
    }

    void newLevelsAreToldApartByNumbers() {
        TestApplication test;
        test.start();
        TestApplication::edit(test.window(0));
        test.trigger(0, Act::New);
        TestApplication::edit(test.window(1));
        QVERIFY(test.window(0).windowTitle().startsWith("Untitled[*]"));
        QVERIFY(test.window(1).windowTitle().startsWith("Untitled 2[*]"));
        QCOMPARE(windowNames(test.window(1)), (QStringList{"&1 Untitled*", "&2 Untitled 2*"}));
        test.trigger(1, Act::Close);
        QCOMPARE(test.asked, QStringList{"Untitled 2"});
        test.trigger(0, Act::New); // one has come and stays, the next is another
        TestApplication::edit(test.window(2));
        QCOMPARE(test.window(2).files().name(), QString("Untitled 3"));
        test.toSave = test.file("a.json");
        test.trigger(1, Act::Save);
        QCOMPARE(test.window(1).files().name(), QString("a.json"));
        test.trigger(1, Act::New); // the number is free
        QCOMPARE(test.window(3).files().name(), QString("Untitled 2"));
        test.trigger(0, Act::NewView);
        QCOMPARE(test.window(4).files().name(), QString("Untitled"));
    }

    void copiesOfOneExampleAreToldApartByNumbers() {
        TestApplication test;
        test.start();
        test.window(0).openExample();
        const QString name = test.window(0).files().name();
        TestApplication::edit(test.window(0));
        test.window(0).openFiles({":/levels/" + name});
        QCOMPARE(test.count(), 2u);
        QCOMPARE(test.window(0).files().name(), name);
        QCOMPARE(test.window(1).files().name(), QString(name).replace(".json", " 2.json"));
        test.answer();
        test.window(1).startNew();
        QCOMPARE(test.window(1).files().name(), QString("Untitled"));
    }

    void twoViewsShowOneLevelEachItsOwnPart() {
        TestApplication test;
        test.start({test.writtenLevel("a.json")});
        test.trigger(0, Act::NewView);
        QCOMPARE(test.count(), 2u);
        MainWindow& one = test.window(0);
        MainWindow& two = test.window(1);
        QCOMPARE(two.canvas().view().scale, one.canvas().view().scale);
        two.canvas().zoom(3);
        QVERIFY(two.canvas().view().scale > 2 * one.canvas().view().scale);

        TestApplication::edit(two);
        QVERIFY(one.document().level() == two.document().level());
        QVERIFY(one.isWindowModified() && two.isWindowModified());
        test.trigger(0, Act::Undo);
        QCOMPARE(two.document().level().objects.size(), 1);
        QVERIFY(one.windowTitle().startsWith("a.json: 1") && two.windowTitle().startsWith("a.json: 2"));
    }

    void closingOneOfTwoViewsAsksNothingTheLastOneDoes() {
        TestApplication test;
        test.start({test.writtenLevel("a.json")});
        test.trigger(0, Act::NewView);
        TestApplication::edit(test.window(0));
        test.trigger(0, Act::Close);
        QCOMPARE(test.count(), 1u);
        QCOMPARE(test.asked, QStringList());
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        TestApplication::edit(test.window(0)); // nobody listens who is gone
        QVERIFY(test.window(0).windowTitle().startsWith("a.json["));
        test.trigger(0, Act::Close);
        QCOMPARE(test.count(), 1u);
        QCOMPARE(test.asked, QStringList{"a.json"});
        test.unsaved = Unsaved::Discard;
        test.trigger(0, Act::Close);
        QCOMPARE(test.count(), 1u);
        QVERIFY(test.window(0).isWelcoming());
        test.trigger(0, Act::Close);
        QCOMPARE(test.count(), 0u);
    }

    void aShapeHalfDrawnInOneViewIsFinishedWhenTheOtherComesForward() {
        TestApplication test;
        test.start({test.writtenLevel("a.json")});
        test.trigger(0, Act::NewView);
        MainWindow& one = test.window(0);
        one.openLevel()->bringToFront(one);
        one.takeTool(ToolId::Edge);
        const int objects = one.document().level().objects.size();
        const QPoint middle = one.canvas().rect().center();
        for (const QPoint& offset : {QPoint(-90, 90), QPoint(90, 90), QPoint(90, -90)}) {
            QTest::mouseMove(&one.canvas(), middle + offset);
            QTest::mouseClick(&one.canvas(), Qt::LeftButton, {}, middle + offset);
        }
        QVERIFY(one.toolbox().isBusy());
        one.openLevel()->bringToFront(test.window(1));
        QVERIFY(!one.toolbox().isBusy());
        QCOMPARE(test.window(1).document().level().objects.size(), objects + 1);
    }

    void quitAsksOnceForEachLevelBeforeItClosesAny() {
        TestApplication test;
        test.start({test.writtenLevel("a.json"), test.writtenLevel("b.json")});
        test.trigger(0, Act::NewView);
        TestApplication::edit(test.window(0));
        TestApplication::edit(test.window(1));
        test.unsaved = Unsaved::Cancel;
        test.trigger(0, Act::Quit);
        QCOMPARE(test.count(), 3u);
        QCOMPARE(test.asked, QStringList{"a.json"});
        test.asked.clear();
        test.unsaved = Unsaved::Save;
        QVERIFY(test.application->quit());
        QCOMPARE(test.count(), 0u);
        QCOMPARE(test.asked, (QStringList{"a.json", "b.json"}));
        const Result<LevelFile> saved = readLevel(test.file("b.json").toStdString());
        QCOMPARE(saved.value().level->objects.size(), 2);
    }

    void theWindowsAreListedAndNextGoesThroughThem() {
        TestApplication test;
        test.start({test.writtenLevel("a.json"), test.writtenLevel("b & c.json")});
        TestApplication::edit(test.window(0));
        QCOMPARE(windowNames(test.window(1)), (QStringList{"&1 a.json*", "&2 b && c.json"}));
        test.window(0).showMinimized();
        test.trigger(1, Act::NextWindow);
        QVERIFY(!test.window(0).isMinimized());
    }

    void theNextRunBeginsWithWhatWasOpen() {
        TestApplication test;
        const QString b = test.writtenLevel("b.json");
        test.start({test.writtenLevel("a.json"), b});
        test.trigger(1, Act::NewView);
        Viewport view = test.window(2).canvas().view();
        view.center = Vec2(3, 4);
        view.scale = 120;
        test.window(2).canvas().setView(view);
        test.startAgain();
        QCOMPARE(test.count(), 3u);
        QCOMPARE(test.window(1).files().path(), b);
        QCOMPARE(test.window(1).openLevel(), test.window(2).openLevel());
        QVERIFY(test.window(2).canvas().view().center == Vec2(3, 4));
        QCOMPARE(test.window(2).canvas().view().scale, 120.0);

        test.startAgain({b}); // what is named wins
        QCOMPARE(test.count(), 1u);
        test.trigger(0, Act::RestoreWindows); // off
        test.startAgain();
        QCOMPARE(test.count(), 1u);
        QCOMPARE(test.window(0).files().path(), QString());
    }

    void theLastWindowThatIsClosedIsThereAgain() {
        TestApplication test;
        const QString b = test.writtenLevel("b.json");
        test.start({test.writtenLevel("a.json"), b});
        test.trigger(0, Act::Close);
        QVERIFY(test.window(0).close());
        QCOMPARE(test.count(), 0u);
        test.startAgain();
        QCOMPARE(test.count(), 1u);
        QCOMPARE(test.window(0).files().path(), b);
    }

    void whatIsGoneIsToldAndTheRestIsOpened() {
        TestApplication test;
        const QString a = test.writtenLevel("a.json");
        test.start({a, test.writtenLevel("b.json")});
        QVERIFY(test.application->quit());
        QVERIFY(QFile::remove(a));
        test.startAgain();
        QCOMPARE(test.count(), 1u);
        QVERIFY(test.window(0).messageBar().text().contains("a.json"));
    }

    void aClosedLevelIsReopenedWhereItWasLookedAt() {
        TestApplication test;
        const QString b = test.writtenLevel("b.json");
        test.start({test.writtenLevel("a.json"), b});
        QVERIFY(!test.window(0).actions()[Act::ReopenClosed].isEnabled());
        Viewport view = test.window(1).canvas().view();
        view.center = Vec2(3, 4);
        test.window(1).canvas().setView(view);
        test.trigger(1, Act::Close);
        test.trigger(0, Act::ReopenClosed);
        QCOMPARE(test.count(), 2u);
        QCOMPARE(test.window(1).files().path(), b);
        QVERIFY(test.window(1).canvas().view().center == Vec2(3, 4));
        QVERIFY(!test.application->canReopen());
    }

    void aLevelWithoutAFileComesBackAsItWasAndUnsaved() {
        TestApplication test;
        test.start({test.writtenLevel("a.json")});
        test.trigger(0, Act::New);
        TestApplication::edit(test.window(1));
        const Level level = test.window(1).document().level();
        test.unsaved = Unsaved::Discard;
        test.trigger(1, Act::Close);
        test.trigger(0, Act::ReopenClosed);
        QCOMPARE(test.count(), 2u);
        QVERIFY(test.window(1).document().level() == level);
        QVERIFY(test.window(1).document().isModified() && test.window(1).files().path().isEmpty());
    }

    void lightAndDarkAreThatOfAllWindows() {
        TestApplication test;
        test.start({test.writtenLevel("a.json"), test.writtenLevel("b.json")});
        test.trigger(0, Act::AppearanceDark);
        QVERIFY(test.window(1).appearance() == Appearance::Dark);
        test.trigger(1, Act::AppearanceLight);
        QVERIFY(test.window(0).appearance() == Appearance::Light);
    }

    void whileAGameIsPlayedTheTitleSaysHowItStands() {
        TestApplication test;
        test.start({spacetow::test::sourceFolder() + "/levels/01_first_haul.json"});
        test.trigger(0, Act::Play);
        QVERIFY(test.window(0).windowTitle().startsWith("01_first_haul.json[*] (ready)"));
        QTest::keyPress(&test.window(0).canvas(), Qt::Key_Up);
        QVERIFY(QTest::qWaitFor([&] { return test.window(0).windowTitle().contains("(playing)"); }));
        test.trigger(0, Act::Stop);
        QVERIFY(test.window(0).windowTitle().startsWith("01_first_haul.json[*] - "));
    }
};

SPACETOW_TEST(ApplicationTest)
#include "application_test.moc"
