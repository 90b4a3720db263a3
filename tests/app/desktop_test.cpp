// The whole program as a user has it: its windows, a window manager, and keys and mouse that come through the X server.

#include "core/level/file.h"
#include "editor/editing/journal.h"
#include "tests/support/desktop.h"
#include "tests/support/folders.h"
#include "tests/support/test_main.h"

#include <QDirIterator>
#include <QFile>
#include <QTemporaryDir>

using namespace spacetow;
using spacetow::test::Desktop;
using spacetow::test::waitUntil;

namespace {

constexpr QPoint corner(150, 680); // of the cave, on the screen; its floor goes to the right from there
constexpr double pixels = 66;      // a metre, at the size in which the program begins

/// On the screen, of what lies there in the cave; m.
QPoint at(double x, double y) {
    return corner + QPoint(qRound(pixels * x), -qRound(pixels * y));
}

struct Studio {
    Studio() {
        QProcessEnvironment environment = desktop.environment();
        for (const char* name : {"HOME", "XDG_CONFIG_HOME", "XDG_STATE_HOME", "XDG_DATA_HOME", "XDG_CACHE_HOME"}) {
            environment.insert(QString::fromLatin1(name), folder.path());
        }
        program.setProcessEnvironment(environment);
        program.setProcessChannelMode(QProcess::ForwardedChannels);
    }
    ~Studio() {
        program.kill();
        program.waitForFinished(5000);
    }

    void start() { program.start(spacetow::test::binaryFolder() + "/bin/spacetow", {}); }
    bool isCalled(const QString& title) {
        return desktop.waitForTitle([&](const QString& now) { return now == title; });
    }
    void key(const char* stroke) { desktop.keys({QString::fromLatin1(stroke)}); }
    void keys(const QStringList& strokes) { desktop.keys(strokes); }
    /// A busy machine may take two taps of a key for one; then once more.
    bool tapUntilCalled(const char* stroke, const QString& title) {
        constexpr int second = 1000; // ms
        return waitUntil([&] {
            key(stroke);
            return QTest::qWaitFor([&] { return desktop.title() == title; }, second);
        });
    }
    void click(const QPoint& place) { desktop.click(place.x(), place.y()); }

    std::optional<Level> saved() const {
        const Result<LevelFile> file = readLevel(path.toStdString(), Checks::FileOnly);
        return file ? file.value().level : std::nullopt;
    }

    /// What is not saved is in the journal, all of it and under its own name.
    bool isKept() const {
        QDirIterator files(folder.path(), {"*.journal"}, QDir::Files | QDir::Hidden, QDirIterator::Subdirectories);
        while (files.hasNext()) {
            QFile file(files.next());
            if (!file.open(QIODevice::ReadOnly)) {
                continue;
            }
            const std::optional<JournalEntry> entry = parsedJournal(file.readAll().toStdString());
            if (entry && entry->text.find("\"payload\"") != std::string::npos &&
                entry->text.find("\"type\": \"finish\"") == std::string::npos) {
                return true;
            }
        }
        return false;
    }

    QTemporaryDir folder;
    QString path = folder.filePath(QStringLiteral("cave.json"));
    Desktop desktop;
    QProcess program;
};

void drawCave(Studio& studio) {
    studio.key("e");
    studio.click(at(0, 0));
    studio.keys({"8", "Tab", "0", "Return"});
    studio.keys({"5", "Tab", "9", "0", "Return"});
    studio.keys({"8", "Tab", "1", "8", "0", "Return"});
    studio.click(at(0, 0));
}

/// The last of what the only object touches, reached from the field below it.
void untickDebris(Studio& studio) {
    studio.keys({"s", "ctrl+a", "ctrl+f", "shift+Tab", "shift+Tab", "space", "Escape"});
}

void placeGame(Studio& studio) {
    studio.key("i");
    studio.click(at(4, 3.5));
    studio.key("i");
    studio.click(at(5, 3.5));
    studio.key("i");
    const QPoint from = at(4.5, 3);
    const QPoint to = at(6, 3);
    studio.desktop.drag(from.x(), from.y(), to.x(), to.y());
    studio.key("s");
}

void save(Studio& studio) {
    studio.key("ctrl+s");
    QVERIFY(studio.desktop.waitForTitle([](const QString& now) { return now.startsWith("Save level as"); }));
    studio.desktop.type(studio.path);
    studio.key("Return");
    QVERIFY(studio.isCalled("cave.json - SpaceTow Studio"));
}

} // namespace

class DesktopTest : public QObject {
    Q_OBJECT

  private slots:
    void aLevelIsDrawnSavedPlayedLostAndFoundAgain() {
        Studio studio;
        if (!studio.desktop.trouble().isEmpty()) {
            QSKIP(qPrintable("No desktop to test on: " + studio.desktop.trouble()));
        }
        studio.start();
        QVERIFY(studio.isCalled("Welcome - SpaceTow Studio"));
        studio.key("ctrl+n");
        QVERIFY(studio.isCalled("Untitled - SpaceTow Studio"));

        drawCave(studio);
        QVERIFY(studio.isCalled("Untitled* - SpaceTow Studio"));
        untickDebris(studio);
        placeGame(studio);
        save(studio);
        const std::optional<Level> level = studio.saved();
        QVERIFY(level && level->objects.size() == 4);
        const auto& cave = std::get<BodyObject>(level->objects[0].data);
        QVERIFY(cave.shapes.front() == LevelShape(EdgeChain{{{0, 0}, {8, 0}, {8, 5}, {0, 5}}, true, noBack}));
        QVERIFY(!(cave.filter == BodyObject().filter));
        QVERIFY(firstOf<ShipObject>(*level) && firstOf<PayloadObject>(*level) && firstOf<FinishObject>(*level));

        studio.key("F5");
        QVERIFY(studio.isCalled("cave.json (ready) - SpaceTow Studio"));
        QVERIFY(studio.tapUntilCalled("Up", "cave.json (playing) - SpaceTow Studio")); // and then nothing more
        QVERIFY(studio.isCalled("cave.json (crashed) - SpaceTow Studio"));
        QVERIFY(studio.tapUntilCalled("Up", "cave.json (ready) - SpaceTow Studio"));
        QVERIFY(studio.tapUntilCalled("Up", "cave.json (playing) - SpaceTow Studio"));
        studio.key("space"); // the payload hangs just above the finish
        QVERIFY(studio.isCalled("cave.json (won) - SpaceTow Studio"));
        studio.key("F8");
        QVERIFY(studio.isCalled("cave.json - SpaceTow Studio"));

        studio.key("ctrl+z");
        QVERIFY(studio.isCalled("cave.json* - SpaceTow Studio"));
        QVERIFY(waitUntil([&] { return studio.isKept(); }));
        studio.program.kill();
        QVERIFY(studio.program.waitForFinished(Desktop::patience));
        QVERIFY(studio.saved() && *studio.saved() == *level);

        studio.start();
        QVERIFY(studio.isCalled("cave.json - SpaceTow Studio")); // as it was saved
        studio.key("ctrl+alt+j");
        QVERIFY(waitUntil([&] {
            studio.key("space"); // on the button, once it is there
            return studio.desktop.title() == "cave.json* - SpaceTow Studio";
        }));
        studio.key("ctrl+s");
        QVERIFY(studio.isCalled("cave.json - SpaceTow Studio"));
        const std::optional<Level> recovered = studio.saved();
        QVERIFY(recovered && recovered->objects.size() == 3 && firstOf<FinishObject>(*recovered) == nullptr);
        studio.key("ctrl+q");
        QVERIFY(studio.program.waitForFinished(Desktop::patience));
        QCOMPARE(studio.program.exitCode(), 0);
    }
};

SPACETOW_TEST(DesktopTest)
#include "desktop_test.moc"
