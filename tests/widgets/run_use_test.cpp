// What people do with a run in the window besides looking at it: step it by keys, zoom, draw, save it, cure the level.

#include "core/level/bounds.h"
#include "editor/window/preferences.h"
#include "tests/support/game_levels.h"
#include "tests/support/test_main.h"
#include "tests/support/window.h"

#include <cmath>

using namespace spacetow;
using namespace spacetow::test;

class RunUseTest : public QObject {
    Q_OBJECT

  private slots:
    void aFlightThatIsStoppedWhileItIsBeingSavedIsSavedAllTheSame() {
        TestWindow test;
        test.document().reset(openSpace());
        const QString path = test.file("stopped.replay.json");
        test.window->whereToSaveFlight = [&](const QString&) { return path; };
        test.trigger(Act::Play);
        QTRY_VERIFY(test.window->liveRun().updates() > 5);
        test.trigger(Act::SaveFlight);
        test.trigger(Act::Stop);
        test.window->flightFile().finish();
        const Result<Replay> replay = readReplay(path.toStdU16String());
        QVERIFY(bool(replay) && replay.value().updates() > 5);
        QVERIFY(test.window->messageBar().text().contains("stopped.replay.json"));
    }

    void aFlightThatIsLongerThanAFileHoldsSaysSo() {
        Recording recording;
        recording.run.runs = {{{}, 1000}};
        recording.updates = 1000;
        QVERIFY(!FlightFile::savedWords("a.replay.json", recording).contains("1,000"));
        recording.updates = 1200;
        const QString said = FlightFile::savedWords("a.replay.json", recording);
        QVERIFY2(said.contains("1,000 of 1,200 updates"), qPrintable(said));
    }

    void aKeyThatIsHeldWhenTheFrameIsSteppedCountsInIt() {
        TestWindow test;
        test.document().reset(openSpace());
        test.trigger(Act::Play);
        LiveRun& run = test.window->liveRun();
        test.trigger(Act::Pause);
        QTRY_VERIFY(run.frame()->paused);
        const std::int64_t before = run.updates();
        QTest::keyPress(&test.canvas(), Qt::Key_Right);
        test.trigger(Act::Step);
        test.trigger(Act::Step);
        QTest::keyRelease(&test.canvas(), Qt::Key_Right); // before the runner has come to the second, perhaps
        test.trigger(Act::Step);
        QTRY_COMPARE(run.updates(), before + 3);
        Replay recording = run.runner()->askRecording()().run;
        QVERIFY(recording.runs.size() >= 2 && recording.runs.back() == (Replay::Run{idle, 1}));
        QVERIFY(recording.runs[recording.runs.size() - 2] == (Replay::Run{right, 2}));
    }

    void inAGameNothingMovesBeforeTheFirstKey() {
        TestWindow test;
        Level level = openSpace();
        addBall(level, Vec2(4, 4), 0.3, Vec2(1, 0));
        test.document().reset(level);
        LiveRun& run = test.window->liveRun();
        test.trigger(Act::Play);
        QTRY_VERIFY(run.isRunning() && run.frame()->paused);
        QVERIFY(run.isGame() && !run.isPaused());
        QCOMPARE(run.updates(), std::int64_t(0));
        QTest::keyPress(&test.canvas(), Qt::Key_Right);
        QTRY_VERIFY(run.phase() == Phase::Flying && run.updates() > 1);
        QTest::keyRelease(&test.canvas(), Qt::Key_Right);
        test.trigger(Act::Stop);
        test.trigger(Act::Simulate); // in which nobody steers
        QTRY_VERIFY(run.updates() > 1);
    }

    void theViewIsZoomedByItsActionsInAGame() {
        TestWindow test;
        test.document().reset(openSpace());
        test.trigger(Act::Play);
        QVERIFY(test.window->isInGame());
        const double scale = test.canvas().view().scale;
        test.trigger(Act::ZoomIn);
        QVERIFY(test.canvas().view().scale > scale);
        test.trigger(Act::FitLevel);
        QVERIFY(test.canvas().view().visible().contains(Vec2(0, 2)));
        QVERIFY(!test.window->liveView().isFollowing());
    }

    void aRecordedFlightThatIsHeldSaysSo() {
        TestWindow test;
        test.document().reset(openSpace());
        Replay flown;
        flown.runs = {{idle, 3000}};
        test.window->playReplay(flown);
        LiveRun& run = test.window->liveRun();
        QTRY_VERIFY(run.timeline()->last == run.timeline()->goal);
        QTRY_VERIFY(test.window->statusLine().hint().contains("recorded flight"));
        test.trigger(Act::Pause);
        QTRY_VERIFY(test.window->statusLine().hint().startsWith("Held"));
    }

    void whatIsDrawnOrDraggedInARunLandsOnTheGridAsInEditing() {
        TestWindow test;
        Level level = openSpace();
        addBall(level, {1.03, 1.01}, 0.2, {0.137, 0.211});
        test.document().reset(level);
        SnapSettings snap;
        snap.step = 0.5;
        test.window->setSnap(snap);
        test.trigger(Act::Simulate);
        LiveRun& run = test.window->liveRun();
        QTRY_VERIFY(run.updates() > 5);
        test.trigger(Act::Pause);
        QTRY_VERIFY(run.frame()->paused);
        const auto isRound = [](const Vec2& place) {
            return std::fmod(place.x(), 0.5) == 0 && std::fmod(place.y(), 0.5) == 0;
        };
        const auto place = [&](int index) { return std::get<BodyObject>(test.level().objects[index].data).position; };
        test.trigger(ToolId::Circle);
        test.drag(3.07, 0.04, 4.1, 0.09);
        QCOMPARE(test.level().objects.size(), level.objects.size() + 1);
        QVERIFY(isRound(place(4)));
        test.trigger(ToolId::Select);
        test.window->liveView().refresh();
        const Key ball = level.objects[3].key;
        const Level posed = test.window->liveView().posedShown(std::span(&ball, 1));
        const Vec2 from = std::get<BodyObject>(posed.objects[0].data).position;
        QVERIFY(!isRound(from) && !isRound(place(3)));
        test.drag(from.x(), from.y(), from.x() + 1.13, from.y() + 0.57);
        QVERIFY(isRound(place(3)) && place(3).x() > 1.6);
        test.trigger(Act::Stop);
        QVERIFY(test.window->toolbox().snap == snap);
        QVERIFY(Preferences().snap() == snap);
    }

    void aKeyThatTheGameHasMovesNoView() {
        TestWindow test;
        test.window->openExample();
        PlayKeys keys = test.window->liveRun().keys();
        keys.set(PlayKey::Thrust, {QKeySequence("4")});
        test.window->liveView().setKeys(keys);
        test.trigger(Act::Play);
        const double scale = test.canvas().view().scale;
        QTest::keyPress(&test.canvas(), Qt::Key_4);
        QTRY_COMPARE(test.window->liveRun().phase(), Phase::Flying);
        QCOMPARE(test.canvas().view().scale, scale);
        QTest::keyRelease(&test.canvas(), Qt::Key_4);
        QTest::keyClick(&test.canvas(), Qt::Key_Minus);
        QVERIFY(test.canvas().view().scale < scale);
    }

    void aCureKeepsTheViewUnlessWhatItCuredIsOutOfSight() {
        TestWindow test;
        Level level;
        level.objects.append(
            {1, {}, BodyObject{.shapes = {Polygon{{{0, 0}, {0, 1}, {1, 1}, {1, 0}}}}}, {}}); // clockwise
        test.document().commit({"draw-polygon", 1}, {std::make_shared<const Level>(level), Selection()});
        ProblemsPanel& panel = test.window->problems();
        panel.check();
        panel.go(1);
        QVERIFY(panel.canFixCurrent());
        const Aabb box = boundsOf(test.level(), std::vector<Key>{panel.currentProblem()->object});
        Viewport view = test.canvas().view();
        view.center = box.center() + Vec2(0.4 * view.size.x() / view.scale, 0);
        test.canvas().setView(view);
        panel.fixCurrent();
        QVERIFY(test.canvas().view().center == view.center);
        test.trigger(Act::Undo);
        view.center = box.center() + Vec2(1000, 0);
        test.canvas().setView(view);
        panel.check();
        panel.fixCurrent();
        QVERIFY(test.canvas().view().visible().overlaps(box));
    }
};

SPACETOW_TEST(RunUseTest)
#include "run_use_test.moc"
