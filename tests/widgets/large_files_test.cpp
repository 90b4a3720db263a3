// Large files are read, and large levels painted for the first time, beside the window.
#include "core/level/bounds.h"
#include "core/level/file.h"
#include "editor/window/dropped_files.h"
#include "editor/window/window_memory.h"
#include "tests/support/board.h"
#include "tests/support/body_with.h"
#include "tests/support/test_main.h"
#include "tests/support/windows.h"

#include <QFile>

using namespace spacetow;
using namespace spacetow::test;

namespace {

void openIn(MainWindow& window, const QStringList& paths) {
    openDropped(paths, window);
}

void putText(const QString& path, const std::string& text) {
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    QCOMPARE(file.write(text.data(), static_cast<qint64>(text.size())), static_cast<qint64>(text.size()));
}

/// Of a level that is too large to be read while one waits.
std::string largeText(const std::string& name) {
    Level level;
    level.name = name;
    const std::string line = std::string(99, 'x') + '\n'; // one of all that would take a text box long to lay out
    while (static_cast<qint64>(level.description.size()) <= FileReader::small) {
        level.description += line;
    }
    level.objects.append(TestApplication::ball(1, {0, 0}));
    return levelText(level);
}

/// A line that has so many points.
Level zigzag(int points) {
    LineChain line;
    for (int i = 0; i < points; ++i) {
        line.vertices.emplace_back(0.1 * i, i % 2);
    }
    Level level;
    level.objects.append(bodyWith(1, line));
    return level;
}

} // namespace

class LargeFilesTest : public QObject {
    Q_OBJECT

  private slots:
    void evenTheFirstPictureOfALargeLevelIsPaintedBeside() {
        const auto request = [](int points) {
            const auto level = std::make_shared<const Level>(zigzag(points));
            Viewport view;
            view.size = Vec2(300, 200);
            return boardRequest(level, view.showing(boundsOf(*level)));
        };
        Board board([] {});
        const QImage small = shownBy(board, request(10));
        QImage background = small;
        background.fill(editingTheme().background);
        QVERIFY(small != background);
        board.forget();
        const BoardRequest large = request(3000);
        QCOMPARE(shownBy(board, large), background);
        QVERIFY(finishedBy(board, large) != background);
    }

    void aLargeLevelIsReadBesideTheWindowWhichSaysSo() {
        TestApplication test;
        test.start({test.writtenLevel("a.json")});
        MainWindow& window = test.window(0);
        const QString path = test.file("large.json");
        putText(path, largeText("Large"));
        openIn(window, {path});
        QVERIFY(window.fileReader().isReading());
        QCOMPARE(test.count(), 1u);
        QVERIFY2(window.statusLine().hint().startsWith("Reading large.json (26"),
                 qPrintable(window.statusLine().hint()));
        QVERIFY(window.actions()[Act::Stop].isEnabled());
        TestApplication::edit(window); // one edits on
        QTRY_COMPARE(test.count(), 2u);
        QCOMPARE(test.window(1).files().path(), path);
        QCOMPARE(test.window(1).document().level().name, std::string("Large"));
        QVERIFY(!window.fileReader().isReading());
        QVERIFY(!window.statusLine().hint().startsWith("Reading"));
        test.unsaved = Unsaved::Discard;
    }

    void whatIsBeingReadCanBeLeftAndAnotherFileOpened() {
        TestApplication test;
        test.start({test.writtenLevel("a.json")});
        MainWindow& window = test.window(0);
        putText(test.file("one.json"), largeText("One"));
        putText(test.file("two.json"), largeText("Two"));
        openIn(window, {test.file("one.json")});
        test.trigger(0, Act::Stop);
        QVERIFY(!window.fileReader().isReading());
        openIn(window, {test.file("two.json")});
        window.fileReader().finish();
        QCOMPARE(test.count(), 2u);
        QCOMPARE(test.window(1).document().level().name, std::string("Two"));
    }

    void severalLargeFilesThatAreDroppedOneAfterAnotherAllArrive() {
        TestApplication test;
        test.start({test.writtenLevel("a.json")});
        for (const char* name : {"one", "two", "three"}) {
            putText(test.file(QString(name) + ".json"), largeText(name));
            openIn(test.window(0), {test.file(QString(name) + ".json")});
        }
        test.window(0).fileReader().finish();
        QCOMPARE(test.count(), 4u);
    }

    void whatALongFileIsIsLookedForBesideTheWindowToo() {
        TestApplication test;
        test.start({test.writtenLevel("a.json")});
        const std::string start = "{\"notes\": \"" + std::string(FileReader::small, 'x') + "\",\n";
        putText(test.file("level.json"), start + "\"schema\": 2, \"objects\": []}");
        putText(test.file("map.json"), start + "\"type\": \"map\"}");
        MainWindow& window = test.window(0);
        openIn(window, {test.file("level.json"), test.file("map.json")});
        QVERIFY(window.fileReader().isReading());
        window.fileReader().finish();
        QCOMPARE(test.count(), 2u);
        QCOMPARE(test.window(1).files().path(), test.file("level.json"));
        QVERIFY(!window.exchange().importBar().isHidden());
    }

    void aFileThatHasBeenChangedSinceItWasReadIsReadAgain() {
        TestApplication test;
        const QString path = test.writtenLevel("a.json");
        const FileToOpen file = readWhole(path);
        FileState disk;
        QCOMPARE(levelOfFile(file, disk).value().level->name, std::string("a.json"));
        putText(path, largeText("Changed"));
        QCOMPARE(levelOfFile(file, disk).value().level->name, std::string("Changed"));
        QVERIFY(disk.sameContent(fileState(path.toStdString())));
    }

    void aLargeLevelOfTheLastRunComesBackInAllItsViewsAndIsRememberedMeanwhile() {
        TestApplication test;
        const QString path = test.file("large.json");
        putText(path, largeText("Large"));
        test.start({test.writtenLevel("a.json"), path});
        test.window(0).fileReader().finish();
        QCOMPARE(test.count(), 2u);
        test.trigger(1, Act::NewView);
        QCOMPARE(test.count(), 3u);
        test.startAgain();
        QCOMPARE(test.count(), 2u); // the second view waits for its level
        QCOMPARE(rememberedWindows().size(), 3u);
        QTRY_COMPARE(test.count(), 3u);
        QCOMPARE(test.window(1).openLevel(), test.window(2).openLevel());
        QCOMPARE(test.window(2).files().path(), path);
    }

    void aLevelOfTheLastRunDoesNotTakeThePlaceOfOneThatWasOpenedMeanwhile() {
        TestApplication test;
        const QString path = test.file("large.json");
        putText(path, largeText("Large"));
        const QString other = test.writtenLevel("b.json");
        test.start({path});
        test.window(0).fileReader().finish();
        test.startAgain();
        MainWindow& window = test.window(0);
        QVERIFY(window.files().path().isEmpty()); // its level is being read
        window.open(other);
        QTRY_COMPARE(test.count(), 2u);
        QCOMPARE(window.files().path(), other);
        QCOMPARE(test.window(1).files().path(), path);
    }
};

SPACETOW_TEST(LargeFilesTest)
#include "large_files_test.moc"
