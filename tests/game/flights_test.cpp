// Every shipped level can be won, and a recording shows how. After a change of the physics or of a level,
//   SPACETOW_RECORD_FLIGHTS=1 game_tests flights_test
// flies them again and writes the recordings anew.

#include "core/game/replay.h"
#include "core/level/file.h"
#include "core/level/lint.h"
#include "tests/support/folders.h"
#include "tests/support/record_flight.h"
#include "tests/support/test_main.h"

#include <algorithm>
#include <filesystem>

using namespace spacetow;
using namespace spacetow::test;
namespace fs = std::filesystem;

namespace {

const fs::path root(sourceFolder().toStdString());

std::vector<fs::path> levelFiles(const fs::path& folder) {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(folder)) {
        if (entry.path().extension() == ".json") {
            files.push_back(entry.path());
        }
    }
    std::ranges::sort(files);
    return files;
}

Level levelFrom(const fs::path& path) {
    Result<LevelFile> file = readLevel(path);
    EXPECTS(file && file.value().level);
    return *file.value().level;
}

fs::path replayPath(const fs::path& level) {
    return root / "tests" / "replays" / (level.stem().string() + ".replay.json");
}

} // namespace

class FlightsTest : public QObject {
    Q_OBJECT

  private slots:
    void shippedLevelsHaveNoProblems_data() {
        QTest::addColumn<QString>("path");
        for (const fs::path& folder : {root / "levels", root / "levels" / "sandbox"}) {
            for (const fs::path& path : levelFiles(folder)) {
                QTest::addRow("%s", path.filename().c_str()) << QString::fromStdString(path.string());
            }
        }
    }
    void shippedLevelsHaveNoProblems() {
        QFETCH(QString, path);
        const Result<LevelFile> file = readLevel(path.toStdString());
        QVERIFY(file);
        for (const Problem& problem : file.value().problems) {
            QFAIL(problem.code.text().data());
        }
        QVERIFY(file.value().level.has_value());
    }

    void theAutopilotFliesEachPlan_data() { addLevelsWithAShip(); }
    void theAutopilotFliesEachPlan() {
        QFETCH(QString, path);
        const fs::path file = path.toStdString();
        const Level level = levelFrom(file);
        const std::optional<FlightPlan> plan = flightPlan(file.filename().string());
        QVERIFY2(plan, "tests/support/record_flight.cpp has no plan for this level");
        std::optional<Replay> replay = winningFlight(level, *plan);
        QVERIFY(replay);
        if (qEnvironmentVariableIsSet("SPACETOW_RECORD_FLIGHTS")) {
            replay->level = file.filename().string();
            replay->levelHash = levelHash(level);
            QVERIFY(!writeReplay(replayPath(file), *replay));
        }
    }

    void theRecordedFlightWins_data() { addLevelsWithAShip(); }
    void theRecordedFlightWins() {
        QFETCH(QString, path);
        const fs::path file = path.toStdString();
        const Result<Replay> replay = readReplay(replayPath(file));
        QVERIFY2(replay, "the level has no readable recording");
        QCOMPARE(QString::fromStdString(replay.value().level), QString::fromStdString(file.filename().string()));
        const Outcome outcome = replayed(levelFrom(file), replay.value());
        QVERIFY2(!outcome.levelChanged, "the level was changed after the recording");
        QVERIFY(outcome.won());
        QCOMPARE(outcome.lives, levelFrom(file).rules.lives);
        QVERIFY(outcome.fuel > 0 && outcome.time > 0);
    }

    void withoutItsLastPartTheFlightDoesNotWin() {
        const fs::path file = root / "levels" / "01_first_haul.json";
        Replay replay = readReplay(replayPath(file)).value();
        replay.runs.resize(replay.runs.size() / 2);
        QVERIFY(!replayed(levelFrom(file), replay).won());
    }

  private:
    static void addLevelsWithAShip() {
        QTest::addColumn<QString>("path");
        for (const fs::path& path : levelFiles(root / "levels")) {
            if (firstOf<ShipObject>(levelFrom(path)) != nullptr) {
                QTest::addRow("%s", path.filename().c_str()) << QString::fromStdString(path.string());
            }
        }
    }
};

SPACETOW_TEST(FlightsTest)
#include "flights_test.moc"
