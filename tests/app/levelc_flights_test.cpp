// What levelc says of recorded flights.

#include "core/game/flights.h"
#include "core/level/file.h"
#include "tests/support/folders.h"
#include "tests/support/random_level.h"
#include "tests/support/run_levelc.h"
#include "tests/support/test_main.h"

#include <QFile>
#include <QRegularExpression>
#include <QTemporaryDir>

using namespace spacetow;
using namespace spacetow::test;

class LevelcFlightsTest : public QObject {
    Q_OBJECT

  private slots:
    void init() { m_folder.emplace(); }

    void aSimulationIsNeitherWonNorLost() {
        write("level.json", levelText(populatedLevel()));
        Replay replay;
        replay.kind = RunKind::Simulation;
        replay.level = "level.json";
        replay.runs = {{{}, 50}};
        write("level.replay.json", replayText(replay));
        const LevelcRun run = runLevelc({"replay", path("level.json"), path("level.replay.json")});
        QCOMPARE(run.status, 0);
        QVERIFY2(run.out.startsWith("outcome=simulation "), qPrintable(run.out));
        QVERIFY2(run.err.contains("level.replay.json is a simulation"), qPrintable(run.err));
        const LevelcRun all = runLevelc({"flights", path("level.json")});
        QCOMPARE(all.status, 0);
        QVERIFY2(all.out.endsWith("level.replay.json: outcome=simulation update=50 seconds=0.5\n"),
                 qPrintable(all.out));
        QVERIFY2(all.err.contains("level.replay.json is a simulation"), qPrintable(all.err));
    }

    void allFlightsBesideALevelAreFlown() {
        QVERIFY(QFile::copy(sourceFolder() + "/levels/01_first_haul.json", path("haul.json")));
        QVERIFY(QFile::copy(sourceFolder() + "/tests/replays/01_first_haul.replay.json", path("haul.a.replay.json")));
        const LevelcRun run = runLevelc({"flights", path("haul.json")});
        QCOMPARE(run.status, 0);
        QCOMPARE(run.out.count('\n'), 1);
        QVERIFY2(run.out.contains("haul.a.replay.json: outcome=won before=unknown news=new time="),
                 qPrintable(run.out));
        Replay flight =
            readReplay((sourceFolder() + "/tests/replays/01_first_haul.replay.json").toStdU16String()).value();
        flight.runs.resize(flight.runs.size() / 2); // and so it is not won
        flight.ended = flightResult(
            *readLevel((sourceFolder() + "/levels/01_first_haul.json").toStdU16String()).value().level, flight);
        write("haul.b.replay.json", replayText(flight));
        const LevelcRun same = runLevelc({"flights", path("haul.json")});
        QCOMPARE(same.status, 0);
        QVERIFY2(
            same.out.contains(QRegularExpression("haul.b.replay.json: outcome=(lost|running) before=\\1 news=same ")),
            qPrintable(same.out));
        flight.ended->end = FlightEnd::Won;
        write("haul.b.replay.json", replayText(flight));
        const LevelcRun worse = runLevelc({"flights", path("haul.json")});
        QCOMPARE(worse.status, 1);
        QVERIFY2(worse.out.contains("before=won news=worse "), qPrintable(worse.out));
        write("haul.b.replay.json", "{");
        const LevelcRun both = runLevelc({"flights", path("haul.json")});
        QCOMPARE(both.status, 1);
        QVERIFY2(both.out.contains("haul.b.replay.json: outcome=unreadable"), qPrintable(both.out));
        QVERIFY2(both.err.contains("haul.b.replay.json: Line 1: The file ends too early"), qPrintable(both.err));
        QCOMPARE(runLevelc({"flights", path("nothing.json")}).status, 2);
    }

    void whatCannotBeReadSaysWhichFileItIsAndWhereInIt_data() {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QString>("said");
        const auto row = [](const char* title, const QStringList& arguments, const QByteArray& text, const char* said) {
            QTest::newRow(title) << arguments << text << QString(said);
        };
        const QByteArray flight = "{\"replay\": 1, \"level\": \"a\",\n\"seed\": -1, \"updates\": []}";
        row("an empty flight", {"replay", "level.json", "FILE"}, "", "FILE: The file is empty. Fetch it again");
        row("a flight with a mistake", {"replay", "level.json", "FILE"}, flight, "FILE: Line 2: “/seed” is missing or");
        row("a flight to be painted", {"render", "level.json", "-o", "x.png", "--replay", "FILE"}, flight,
            "FILE: Line 2: “/seed”");
        row("a flight cut off", {"replay", "level.json", "FILE"}, flight.chopped(1), "FILE: Line 2: The file ends too");
        row("an empty level", {"check", "FILE"}, "", "FILE:1: error: empty-file: The file is empty. Fetch it again");
        row("an empty level to be fixed", {"fix", "FILE"}, "", "FILE:1: error: empty-file: The file is empty.");
        row("an empty drawing", {"import", "FILE", "-o", "x.json"}, "", "FILE: The file is empty.");
        row("a map with a mistake", {"import", "FILE", "-o", "x.json"}, "{\n\"type\": map",
            "FILE: Line 2: “map” is not");
    }
    void whatCannotBeReadSaysWhichFileItIsAndWhereInIt() {
        QFETCH(QStringList, arguments);
        QFETCH(QByteArray, text);
        QFETCH(QString, said);
        write("level.json", levelText(populatedLevel()));
        write("FILE", text.toStdString());
        for (QString& argument : arguments) {
            argument = QRegularExpression("FILE|\\.json$").match(argument).hasMatch() ? path(argument) : argument;
        }
        const LevelcRun run = runLevelc(arguments);
        const QString all = run.out + run.err;
        QVERIFY2(run.status > 0, qPrintable(all));
        QVERIFY2(all.contains(said.replace("FILE", path("FILE"))), qPrintable(all));
    }

    void numbersArePlainAndSizesAreForPeople() {
        write("level.json", levelText(populatedLevel()));
        write("large.replay.json", std::string(maxReplayBytes + 1, ' '));
        const LevelcRun large = runLevelc({"replay", path("level.json"), path("large.replay.json")});
        QVERIFY2(large.err.endsWith("is too large: at most 8.4 MB can be read.\n"), qPrintable(large.err));
        write("long.replay.json", R"({"replay":1,"level":"","seed":1,"updates":[[0,1000001]]})");
        const LevelcRun tooLong = runLevelc({"replay", path("level.json"), path("long.replay.json")});
        QVERIFY2(tooLong.err.contains(" longer than 1000000 updates"), qPrintable(tooLong.err));
    }

  private:
    QString path(const QString& name) const { return m_folder->filePath(name); }
    void write(const QString& name, const std::string& text) const {
        QFile file(path(name));
        QVERIFY(file.open(QIODevice::WriteOnly));
        QCOMPARE(file.write(text.data(), static_cast<qint64>(text.size())), static_cast<qint64>(text.size()));
    }

    std::optional<QTemporaryDir> m_folder;
};

SPACETOW_TEST(LevelcFlightsTest)
#include "levelc_flights_test.moc"
