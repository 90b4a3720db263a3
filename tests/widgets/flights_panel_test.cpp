#include "editor/panels/flights_panel.h"

#include "core/base/contract.h"
#include "core/level/edits.h"
#include "core/level/file.h"
#include "editor/window/messages.h"
#include "tests/support/folders.h"
#include "tests/support/game_levels.h"
#include "tests/support/test_main.h"
#include "tests/support/window.h"

#include <QDockWidget>
#include <QFile>

using namespace spacetow;
using namespace spacetow::test;

namespace {

/// The first level with its recorded flight beside it, and the panel in sight.
FlightsPanel& flightsShown(TestWindow& test) {
    QFile::copy(sourceFolder() + "/levels/01_first_haul.json", test.file("haul.json"));
    QFile::copy(sourceFolder() + "/tests/replays/01_first_haul.replay.json", test.file("haul.fast.replay.json"));
    test.window->open(test.file("haul.json"));
    test.window->panels().dock("flights").show();
    test.window->panels().dock("flights").raise();
    QApplication::processEvents();
    FlightsPanel& panel = test.window->flights();
    panel.finish();
    return panel;
}

/// What the list says of the only flight beside the level.
QString store(TestWindow& test, const Replay& flight) {
    const QString level = test.file("cave.json");
    EXPECTS(!writeReplay(test.file("cave.replay.json").toStdU16String(), flight));
    FlightsPanel panel(test.document(), [](const Error& error) { return sentence(error); });
    panel.setFile(level);
    panel.show();
    panel.finish();
    EXPECTS(panel.list().count() == 1);
    return panel.list().item(0)->text();
}

} // namespace

class FlightsPanelTest : public QObject {
    Q_OBJECT

  private slots:
    void eachEditFliesTheStoredFlightsAgain() {
        TestWindow test;
        FlightsPanel& panel = flightsShown(test);
        QCOMPARE(panel.list().count(), 1);
        QCOMPARE(panel.results().front().end, FlightEnd::Won);
        QVERIFY(panel.list().item(0)->text().startsWith("haul.fast.replay.json: wins after")); // an old recording
        const std::vector<Key> payload{firstOf<PayloadObject>(test.level())->key};
        const Level blocked = moved(test.level(), payload, Vec2(3, 3));
        test.document().commit({"move", 1}, {std::make_shared<const Level>(blocked), Selection(payload)});
        panel.finish();
        QVERIFY(panel.results().front().end != FlightEnd::Won);
        test.document().undo();
        panel.finish();
        QCOMPARE(panel.results().front().end, FlightEnd::Won);
    }

    void aFlightIsShownWhereItEndsAndPlayed() {
        TestWindow test;
        FlightsPanel& panel = flightsShown(test);
        Viewport away = test.canvas().view();
        away.center = Vec2(500, 500);
        test.canvas().setView(away);
        panel.list().setCurrentRow(0);
        QVERIFY(test.canvas().view().visible().contains(*panel.results().front().place));
        Q_EMIT panel.list().itemActivated(panel.list().item(0));
        QVERIFY(test.window->isPlaying());
        QTRY_COMPARE(test.window->liveRun().updates(), panel.results().front().update); // at the moment that is told
        QCOMPARE(test.window->liveRun().phase(), Phase::Won);
        QVERIFY(test.window->liveRun().isPaused());
    }

    void whatEndsOtherwiseThanBeforeIsTold() {
        TestWindow test;
        test.document().reset(spaceWithCeiling());
        const auto isNow = [&](const FlightResult& before, const Replay& flight) {
            Replay stored = flight;
            stored.ended = before;
            return store(test, stored);
        };
        Replay crash;
        for (int i = 0; i < 200; ++i) {
            crash.append({.thrust = true});
        }
        const FlightResult lost = flightResult(spaceWithCeiling(), crash);
        FlightResult won = lost;
        won.end = FlightEnd::Won;
        FlightResult later = lost;
        later.seconds = 77;
        ++later.update;
        Replay start = crash;
        start.runs.front().count = 10;
        const FlightResult underWay = flightResult(spaceWithCeiling(), start);
        const auto row = [](const QString& all) { return all.section(QStringLiteral(".json: "), 1); };
        QVERIFY2(row(isNow(lost, crash)).startsWith("still crashes at "), qPrintable(isNow(lost, crash)));
        QVERIFY(row(isNow(later, crash)).contains("before after 77 s"));
        QVERIFY(row(isNow(won, crash)).startsWith("won before, crashes now at "));
        QVERIFY(row(isNow(underWay, crash)).startsWith("crashes now, at "));
        QVERIFY(row(isNow(underWay, start)).startsWith("is still under way at its end, at "));
        QVERIFY(row(isNow(won, start)).startsWith("won before, now is under way"));
        QVERIFY(row(isNow(lost, start)).startsWith("crashed before, now is under way"));
        QVERIFY(row(store(test, crash)).startsWith("crashes at "));
        QVERIFY(row(isNow(underWay, crash)).contains("; ") && !row(isNow(underWay, crash)).contains('('));
    }

    void aFlightThatCannotBeReadSaysWhyAndWhere() {
        TestWindow test;
        for (const auto& [text, why] : {std::pair("", "cave.replay.json: cannot be read: The file is empty. "),
                                        std::pair("{\"replay\": 1,\n", "cave.replay.json: cannot be read: Line 2: ")}) {
            QFile file(test.file("cave.replay.json"));
            QVERIFY(file.open(QIODevice::WriteOnly) && file.write(text) >= 0);
            file.close();
            FlightsPanel panel(test.document(), [](const Error& error) { return sentence(error); });
            panel.setFile(test.file("cave.json"));
            panel.show();
            panel.finish();
            QCOMPARE(panel.list().count(), 1);
            QVERIFY2(panel.list().item(0)->text().startsWith(why), qPrintable(panel.list().item(0)->text()));
        }
    }

    void ofASimulationNothingIsSaidToBeWonOrLost() {
        TestWindow test;
        test.document().reset(spaceWithCeiling());
        Replay stored;
        stored.kind = RunKind::Simulation;
        stored.runs = {{{}, 200}};
        QVERIFY2(store(test, stored).endsWith(": is a simulation of 4 s"), qPrintable(store(test, stored)));
    }

    void whatIsSaidOfAFlightIsWrappedInANarrowPanel() {
        TestWindow test;
        FlightsPanel& panel = flightsShown(test);
        panel.list().setFixedWidth(180);
        QApplication::processEvents();
        const QRect row = panel.list().visualItemRect(panel.list().item(0));
        QVERIFY(row.right() <= panel.list().viewport()->width());
        QVERIFY(row.height() > 2 * panel.list().fontMetrics().height());
    }

    void aLevelWithoutAFileHasNone() {
        TestWindow test;
        test.window->panels().dock("flights").show();
        test.window->flights().finish();
        QCOMPARE(test.window->flights().list().count(), 0);
    }
};

SPACETOW_TEST(FlightsPanelTest)
#include "flights_panel_test.moc"
