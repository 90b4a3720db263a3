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

namespace {} // namespace

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
        QCOMPARE(runLevelc({"flights", path("nothing.json")}).status, 2);
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
