#include "core/game/flights.h"

#include "core/game/capsule.h"
#include "core/game/reach.h"
#include "core/game/session.h"
#include "core/level/edits.h"
#include "core/level/file.h"
#include "tests/support/folders.h"
#include "tests/support/full_run.h"
#include "tests/support/game_levels.h"
#include "tests/support/seed_text.h"
#include "tests/support/test_main.h"

#include <QTemporaryDir>

#include <filesystem>
#include <fstream>

using namespace spacetow;
using namespace spacetow::test;
namespace fs = std::filesystem;

namespace {

Level storedHaul() {
    return *readLevel(fs::path(sourceFolder().toStdString()) / "levels" / "01_first_haul.json").value().level;
}

Replay haulFlight() {
    return readReplay(fs::path(sourceFolder().toStdString()) / "tests" / "replays" / "01_first_haul.replay.json")
        .value();
}

/// Something in it is moved a little.
Level nudged(Level level, Random& random) {
    const std::vector<Key> keys{
        level.objects[static_cast<int>(random.below(static_cast<std::uint32_t>(level.objects.size())))].key};
    return moved(std::move(level), keys, Vec2(random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5)));
}

} // namespace

class StoredFlightsTest : public QObject {
    Q_OBJECT

  private slots:
    void theRecordedFlightWinsAndSaysWhere() {
        const FlightResult result = flightResult(storedHaul(), haulFlight());
        QCOMPARE(result.end, FlightEnd::Won);
        const Outcome outcome = replayed(storedHaul(), haulFlight());
        QCOMPARE(result.time, outcome.time);
        QCOMPARE(result.fuel, outcome.fuel);
        QVERIFY((*result.place - Vec2(11, 8.9)).norm() < 2); // at the finish
        QVERIFY(std::abs(result.seconds - static_cast<double>(result.update) * 0.02) < 1e-9);
        QVERIFY(result.update > 500 && result.update < outcome.updates);
    }

    void afterRandomEditsTheResultIsThatOfAFullReplay() {
        Random random(11);
        const Replay flight = haulFlight();
        const int edits = fullOrQuick(100, usualOrThin(12, 2));
        for (int i = 0; i < edits; ++i) {
            const Level level = nudged(storedHaul(), random);
            const FlightResult result = flightResult(level, flight);
            const Outcome outcome = replayed(level, flight);
            QVERIFY2((result.end == FlightEnd::Won) == outcome.won() && result.time == outcome.time &&
                         result.fuel == outcome.fuel,
                     seedText(static_cast<std::uint64_t>(i)));
            QVERIFY(!outcome.lost() || result.end == FlightEnd::Lost);
        }
    }

    void aCrashIsWhereTheShipWasLostFirst() {
        Replay flight;
        for (int i = 0; i < 400; ++i) {
            flight.append(thrust);
        }
        const FlightResult result = flightResult(spaceWithCeiling(), flight);
        QCOMPARE(result.end, FlightEnd::Lost);
        QVERIFY(result.place->y() > 0.5 && result.place->y() < 1);
        QVERIFY(result.update > 10 && result.update < 200);
        flight.runs.front().count = 10;
        QCOMPARE(flightResult(spaceWithCeiling(), flight).end, FlightEnd::UnderWay);
    }

    void aSandboxHasNoPlaceAndNoLoss() {
        Replay run;
        run.append({});
        const FlightResult result = flightResult(Level(), run);
        QVERIFY(result.end == FlightEnd::UnderWay && !result.place);
        QCOMPARE(result.update, std::int64_t(1));
    }

    void whatEndsAsBeforeIsNoNews() {
        const FlightResult won{FlightEnd::Won, 10, 3, Vec2(1, 2), 500, 10};
        FlightResult later = won;
        later.update = 501;
        FlightResult elsewhere = won;
        elsewhere.place = Vec2(1, 2.01);
        FlightResult lost = won;
        lost.end = FlightEnd::Lost;
        FlightResult underWay = won;
        underWay.end = FlightEnd::UnderWay;
        QCOMPARE(newsOf({}, won), FlightNews::New);
        QCOMPARE(newsOf(won, won), FlightNews::Same);
        QCOMPARE(newsOf(won, later), FlightNews::Elsewhere);
        QCOMPARE(newsOf(won, elsewhere), FlightNews::Elsewhere);
        QCOMPARE(newsOf(won, lost), FlightNews::Worse);
        QCOMPARE(newsOf(won, underWay), FlightNews::Worse);
        QCOMPARE(newsOf(lost, won), FlightNews::Better);
        QCOMPARE(newsOf(underWay, won), FlightNews::Better);
        QCOMPARE(newsOf(lost, underWay), FlightNews::Other);
        QCOMPARE(newsOf(underWay, lost), FlightNews::Other);
    }

    void whatNoMemoryWouldHoldIsNotFlown() {
        Level level = openSpace();
        for (int i = 0; i < 1800; ++i) { // more than a million pairs
            addBall(level, Vec2(20, 20), 0.5, Vec2(0, 0));
        }
        Replay flight;
        flight.append(idle);
        QCOMPARE(flightResult(level, flight).end, FlightEnd::Crowded);
        const HeldPath path = heldPath(Session(level), idle, 1);
        QVERIFY(path.ends);
        QCOMPARE(path.ship.size(), std::size_t(1)); // where it is now
        const Capsule capsule{.level = std::make_shared<const Level>(level), .run = flight};
        QCOMPARE(sessionOf(capsule).updates(), std::int64_t(0));
    }

    void aStopEndsIt() {
        std::stop_source stop;
        stop.request_stop();
        QCOMPARE(flightResult(storedHaul(), haulFlight(), stop.get_token()).end, FlightEnd::Stopped);
    }

    void flightsAreFoundBesideTheirLevel() {
        const QTemporaryDir folder;
        const fs::path place(folder.path().toStdString());
        for (const char* name : {"cave.replay.json", "cave.fast.replay.json"}) {
            QVERIFY(!writeReplay(place / name, haulFlight()));
        }
        QVERIFY(!writeReplay(place / "caves.replay.json", haulFlight()));
        std::ofstream(place / "cave.broken.replay.json") << "{";
        std::ofstream(place / "cave.json") << "{}";
        const std::vector<StoredFlight> found = flightsBeside(place / "cave.json");
        QCOMPARE(found.size(), std::size_t(3));
        QCOMPARE(found[0].path.filename().string(), std::string("cave.broken.replay.json"));
        QVERIFY(found[0].replay == nullptr && found[1].replay != nullptr && found[2].replay != nullptr);
        QVERIFY(flightsBeside(place / "nowhere" / "cave.json").empty());
        QVERIFY(!writeReplay(place / "cave.2.replay.json", haulFlight()));
        QVERIFY(!writeReplay(place / "cave.2.slow.replay.json", haulFlight()));
        QCOMPARE(flightsBeside(place / "cave.json").size(), std::size_t(5));
        std::ofstream(place / "cave.2.json") << "{}";
        QCOMPARE(flightsBeside(place / "cave.json").size(), std::size_t(3));
        QCOMPARE(flightsBeside(place / "cave.2.json").size(), std::size_t(2));
    }
};

SPACETOW_TEST(StoredFlightsTest)
#include "stored_flights_test.moc"
