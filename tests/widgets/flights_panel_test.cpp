#include "editor/panels/flights_panel.h"

#include "core/level/edits.h"
#include "core/level/file.h"
#include "tests/support/folders.h"
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

} // namespace

class FlightsPanelTest : public QObject {
    Q_OBJECT

  private slots:
    void eachEditFliesTheStoredFlightsAgain() {
        TestWindow test;
        FlightsPanel& panel = flightsShown(test);
        QCOMPARE(panel.list().count(), 1);
        QCOMPARE(panel.results().front().end, FlightEnd::Won);
        QVERIFY(panel.list().item(0)->text().startsWith("haul.fast.replay.json: wins after"));
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
        QVERIFY(test.canvas().view().visible().contains(panel.results().front().place));
        Q_EMIT panel.list().itemActivated(panel.list().item(0));
        QVERIFY(test.window->isPlaying());
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
