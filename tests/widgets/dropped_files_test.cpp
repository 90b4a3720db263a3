// Levels, flights and drawings that are dropped on a window or opened otherwise.

#include "core/game/replay.h"
#include "editor/window/dropped_files.h"
#include "tests/support/folders.h"
#include "tests/support/test_main.h"
#include "tests/support/windows.h"

#include <QDragEnterEvent>
#include <QFile>
#include <QMimeData>

#include <sys/stat.h>

using namespace spacetow;
using spacetow::test::TestApplication;

namespace {

void letFall(MainWindow& window, const QStringList& paths) {
    QList<QUrl> urls;
    for (const QString& path : paths) {
        urls << QUrl::fromLocalFile(path);
    }
    QMimeData data;
    data.setUrls(urls);
    QDragEnterEvent enter(QPoint(50, 50), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&window, &enter);
    QVERIFY(enter.isAccepted());
    QDropEvent event(QPointF(50, 50), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&window, &event);
}

/// The same, and waits until all has been read.
void drop(MainWindow& window, const QStringList& paths) {
    letFall(window, paths);
    window.fileReader().finish();
    window.flightReader().finish();
}

QString storedFlight(const QString& level) {
    return spacetow::test::sourceFolder() + "/tests/replays/" + level + ".replay.json";
}

} // namespace

class DroppedFilesTest : public QObject {
    Q_OBJECT

  private slots:
    void aDroppedFlightIsFlownInTheLevelThatIsOpen() {
        TestApplication test;
        const QString level = spacetow::test::sourceFolder() + "/levels/01_first_haul.json";
        test.start({test.writtenLevel("a.json"), level});
        drop(test.window(0), {spacetow::test::sourceFolder() + "/tests/replays/01_first_haul.replay.json"});
        QCOMPARE(test.count(), 2u);
        QVERIFY(test.window(1).isPlaying() && !test.window(0).isPlaying());
        QCOMPARE(test.window(1).messageBar().text(), QString());
    }

    void aFlightFindsItsLevelBesideItOrAmongTheShippedOnes() {
        TestApplication test;
        test.start();
        const QString copy = test.file("flight.json"); // whatever it is called
        QVERIFY(QFile::copy(spacetow::test::sourceFolder() + "/tests/replays/01_first_haul.replay.json", copy));
        QCOMPARE(kindOfFile(copy), FileKind::Replay);
        drop(test.window(0), {copy});
        QVERIFY(test.window(0).isPlaying());
        QCOMPARE(test.window(0).messageBar().text(), QString());
    }

    void aFlightInTheSecondCopyOfAnExampleFindsTheExample() {
        const QString path = QStringLiteral(":/levels/01_first_haul.json");
        QString flight;
        TestApplication test;
        test.start();
        test.window(0).openFiles({path});
        TestApplication::edit(test.window(0));
        test.window(0).openFiles({path});
        MainWindow& copy = test.window(1);
        QVERIFY(copy.files().name().contains(QStringLiteral(" 2")));
        flight = test.file("copy.replay.json");
        copy.whereToSaveFlight = [&](const QString&) { return flight; };
        test.trigger(1, Act::Simulate);
        QTRY_VERIFY(copy.liveRun().updates() > 5);
        test.trigger(1, Act::SaveFlight);
        copy.flightFile().finish();
        QCOMPARE(readReplay(flight.toStdU16String()).value().level, std::string("01_first_haul.json"));
        test.unsaved = Unsaved::Discard;
    }

    void aSimulationThatIsSavedAndDroppedOpensAsASimulationAndRunsToItsEnd() {
        TestApplication test;
        test.start({spacetow::test::sourceFolder() + "/levels/01_first_haul.json"});
        MainWindow& window = test.window(0);
        const QString path = test.file("watched.replay.json");
        window.whereToSaveFlight = [&](const QString&) { return path; };
        test.trigger(0, Act::Simulate);
        QTRY_VERIFY(window.liveRun().updates() > 5);
        test.trigger(0, Act::SaveFlight);
        window.flightFile().finish();
        QVERIFY2(window.messageBar().text().startsWith("The simulation "), qPrintable(window.messageBar().text()));
        test.trigger(0, Act::Stop);
        drop(window, {path});
        QTRY_VERIFY(window.isPlaying());
        QVERIFY(!window.isInGame());
        QTRY_VERIFY(window.liveRun().isPaused()); // at its end
        QCOMPARE(window.liveRun().updates(), readReplay(path.toStdU16String()).value().updates());
    }

    void aFlightInAChangedLevelIsFlownWithAWarning() {
        TestApplication test;
        test.start({spacetow::test::sourceFolder() + "/levels/01_first_haul.json"});
        TestApplication::edit(test.window(0));
        drop(test.window(0), {spacetow::test::sourceFolder() + "/tests/replays/01_first_haul.replay.json"});
        QVERIFY(test.window(0).isPlaying());
        QVERIFY(test.window(0).messageBar().text().contains(QStringLiteral("changed")));
        test.unsaved = Unsaved::Discard;
    }

    void ofASimulationNoSentenceSaysThatItIsAFlight() {
        TestApplication test;
        test.start({spacetow::test::sourceFolder() + "/levels/01_first_haul.json"});
        Replay replay =
            readReplay((spacetow::test::sourceFolder() + "/tests/replays/01_first_haul.replay.json").toStdU16String())
                .value();
        replay.kind = RunKind::Simulation;
        const QString path = test.file("watched.replay.json");
        QVERIFY(!writeReplay(path.toStdU16String(), replay));
        TestApplication::edit(test.window(0));
        drop(test.window(0), {path});
        QTRY_VERIFY(test.window(0).isPlaying());
        const QString changed = test.window(0).messageBar().text();
        QVERIFY2(changed.contains("since the simulation was recorded"), qPrintable(changed));
        test.trigger(0, Act::Stop);
        replay.level = "nowhere.json";
        replay.levelHash = 1;
        QVERIFY(!writeReplay(path.toStdU16String(), replay));
        drop(test.window(0), {path});
        const QString nowhere = test.window(0).messageBar().text();
        QVERIFY2(nowhere.contains("nowhere.json") && !nowhere.contains("flight"), qPrintable(nowhere));
        test.unsaved = Unsaved::Discard;
    }

    void aFlightIsReadBesideTheWindowWhichSaysSo() {
        TestApplication test;
        test.start({spacetow::test::sourceFolder() + "/levels/01_first_haul.json"});
        MainWindow& window = test.window(0);
        letFall(window, {storedFlight("01_first_haul")});
        QVERIFY(!window.isPlaying() && window.flightReader().isReading());
        QVERIFY2(window.statusLine().hint().contains("Getting ready"), qPrintable(window.statusLine().hint()));
        QVERIFY(window.actions()[Act::Stop].isEnabled() && !window.actions()[Act::Pause].isEnabled());
        QTRY_VERIFY(window.isInGame());
        QVERIFY(!window.flightReader().isReading());
        QVERIFY(!window.statusLine().hint().contains("Getting ready"));
    }

    void whatIsBeingReadCanBeLeftAndAnotherFlightOpened() {
        TestApplication test;
        test.start({spacetow::test::sourceFolder() + "/levels/01_first_haul.json"});
        MainWindow& window = test.window(0);
        letFall(window, {storedFlight("01_first_haul")});
        test.trigger(0, Act::Stop);
        QVERIFY(!window.flightReader().isReading());
        QVERIFY(!window.statusLine().hint().contains("Getting ready"));
        window.flightReader().finish();
        QVERIFY(!window.isPlaying() && test.count() == 1);
        letFall(window, {storedFlight("01_first_haul")});
        letFall(window, {storedFlight("02_airlock")}); // instead
        window.flightReader().finish();
        QVERIFY(!window.isPlaying() && test.count() == 2 && test.window(1).isInGame());
    }

    void severalFlightsAreFlownEachInItsLevel() {
        TestApplication test;
        test.start({spacetow::test::sourceFolder() + "/levels/01_first_haul.json"});
        drop(test.window(0), {storedFlight("02_airlock"), storedFlight("01_first_haul")});
        QVERIFY(test.count() == 2 && test.window(0).isInGame() && test.window(1).isInGame());
    }

    void whatIsTooMuchOrNeverEndsIsRefusedWithASentence_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("kind");
        QTest::addColumn<QString>("said");
        for (const char* name : {"x.replay.json", "x.json"}) {
            QTest::addRow("many bytes in %s", name) << name << "large"
                                                    << "too large";
            QTest::addRow("pipe in %s", name) << name << "pipe"
                                              << "not a regular file";
            QTest::addRow("device in %s", name) << name << "/dev/zero"
                                                << "not a regular file";
        }
    }
    void whatIsTooMuchOrNeverEndsIsRefusedWithASentence() {
        QFETCH(QString, name);
        QFETCH(QString, kind);
        QFETCH(QString, said);
        TestApplication test;
        test.start({test.writtenLevel("a.json")});
        const QString path = test.file(name);
        if (kind == "large") {
            QFile file(path);
            QVERIFY(file.open(QIODevice::WriteOnly) && file.resize(qint64{700} << 20)); // takes no room on the disk
        } else if (kind == "pipe") {
            QCOMPARE(mkfifo(qPrintable(path), 0600), 0);
        } else {
            QVERIFY(QFile::link(kind, path));
        }
        drop(test.window(0), {path});
        QVERIFY(!test.window(0).isPlaying());
        const QString words = test.window(0).messageBar().text();
        QVERIFY2(words.contains(said), qPrintable(words));
    }

    void aFlightWhoseLevelIsNowhereSaysSo() {
        TestApplication test;
        test.start({test.writtenLevel("a.json")});
        Replay replay;
        replay.level = "nowhere.json";
        const QString path = test.file("x.replay.json");
        QVERIFY(!writeReplay(path.toStdString(), replay));
        drop(test.window(0), {path});
        QVERIFY(!test.window(0).isPlaying());
        QVERIFY(test.window(0).messageBar().text().contains("nowhere.json"));
    }

    void whatCannotBeReadSaysWhichFileItIsWhereInItAndWhatToDo_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QStringList>("said");
        const QString fetch = "Fetch it again";
        const auto row = [](const char* title, const char* name, const QByteArray& text, const QStringList& said) {
            QTest::newRow(title) << QString(name) << text << said;
        };
        row("an empty flight", "x.replay.json", "", {"x.replay.json cannot be opened.", "The file is empty. " + fetch});
        row("a flight cut off", "x.replay.json", "{\"replay\": 1,\n",
            {"x.replay.json cannot be opened.", "Line 2: The file ends too early", "fetch it again"});
        row("a flight with a mistake", "x.replay.json",
            "{\"replay\": 1, \"level\": \"a\", \"seed\": 1,\n\"updates\": 3}",
            {"x.replay.json cannot be opened.", "Line 2: “/updates” is missing or not", "Correct it"});
        row("another list", "x.replay.json", "[]", {"x.replay.json cannot be opened.", "not a recorded flight"});
        row("an empty level", "x.json", "", {"x.json cannot be opened.", "Line 1: The file is empty. " + fetch});
        row("a level with a mistake", "x.json", "{\"schema\": 2,\n\"objects\": [,]}",
            {"x.json cannot be opened.", "Line 2: “,” is not expected here"});
        row("an empty drawing", "x.svg", "", {"x.svg was not imported.", "The file is empty. " + fetch});
        row("a drawing cut off", "x.svg", "<svg>\n<g>", {"x.svg was not imported.", "line 2, column 4"});
        row("a map with a mistake", "x.tmj", "{\"type\": \"map\",\n}",
            {"x.tmj was not imported.", "Line 1: There is a comma before “}”"});
        row("zeros in place of text", "x.json", QByteArray("{\n\0\0", 4),
            {"x.json cannot be opened.", "Line 2: There is a zero byte here", fetch});
        row("something else", "x.json", "{\n\xff\xfe",
            {"x.json cannot be opened.", "Line 2: The file is not text", fetch});
    }
    void whatCannotBeReadSaysWhichFileItIsWhereInItAndWhatToDo() {
        QFETCH(QString, name);
        QFETCH(QByteArray, text);
        QFETCH(QStringList, said);
        TestApplication test;
        test.start({test.writtenLevel("a.json")});
        QFile file(test.file(name));
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(text) == text.size());
        file.close();
        drop(test.window(0), {file.fileName()});
        test.window(0).exchange().importBar().finishWork();
        const QString words = test.window(0).messageBar().text();
        for (const QString& part : said) {
            QVERIFY2(words.contains(part), qPrintable(words));
        }
        QCOMPARE(words.count(name), 1);
    }

    void drawingsAreImportedOneAtATimeIntoTheLevelThatCameWithThem() {
        TestApplication test;
        test.start();
        QStringList drawings;
        for (const char* name : {"one.svg", "two.svg"}) {
            QFile file(test.file(name));
            QVERIFY(file.open(QIODevice::WriteOnly));
            file.write("<svg xmlns='http://www.w3.org/2000/svg'><rect width='9' height='9'/></svg>");
            drawings << file.fileName();
        }
        const QString level = test.writtenLevel("a.json");
        drop(test.window(0), drawings + QStringList{level});
        QCOMPARE(test.count(), 1u);
        QCOMPARE(test.window(0).files().path(), level);
        QVERIFY(!test.window(0).exchange().importBar().isHidden());
        const QString said = test.window(0).messageBar().text();
        QVERIFY2(said.contains("one.svg"), qPrintable(said));
    }

    void aForeignFileIsImportedWhateverItIsCalledAndHoweverItIsOpened() {
        TestApplication test;
        const QString scene = test.file("scene.json");
        QVERIFY(QFile::copy(spacetow::test::sourceFolder() + "/tests/golden/import/rube_scene/in.json", scene));
        QCOMPARE(kindOfFile(scene), FileKind::Foreign);
        test.start({scene}); // the command line
        QVERIFY(!test.window(0).exchange().importBar().isHidden());
        QCOMPARE(test.window(0).files().path(), QString());
        test.window(0).exchange().cancel();
        drop(test.window(0), {scene});
        QVERIFY(!test.window(0).exchange().importBar().isHidden());
        test.window(0).exchange().cancel();
        test.window(0).files().questions.whichToOpen = [&](const QString&) { return QStringList{scene}; };
        test.trigger(0, Act::Open);
        QVERIFY(!test.window(0).exchange().importBar().isHidden());
        test.window(0).exchange().cancel();
    }

    void aLevelIsOneWhateverItIsCalled() {
        TestApplication test;
        const QString path = test.writtenLevel("a.json") + ".svg";
        QVERIFY(QFile::rename(test.file("a.json"), path));
        QCOMPARE(kindOfFile(path), FileKind::Level);
        test.start({path});
        QCOMPARE(test.window(0).files().path(), path);
    }

    void severalLevelsAreDroppedAtOnce() {
        TestApplication test;
        test.start();
        drop(test.window(0), {test.writtenLevel("a.json"), test.writtenLevel("b.json")});
        QCOMPARE(test.count(), 2u);
    }
};

SPACETOW_TEST(DroppedFilesTest)
#include "dropped_files_test.moc"
