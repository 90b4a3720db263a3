// Time that is held, stepped, slowed down and turned back, bodies that are pulled, and levels that are edited
// meanwhile.
#include "tests/support/game_view.h"
#include "tests/support/test_main.h"
#include "tests/support/window.h"

#include "core/game/flights.h"

#include <QFile>
#include <QMenu>
#include <QSignalSpy>
#include <QTimer>
#include <QToolButton>

#include <algorithm>

using namespace spacetow;
using namespace spacetow::test;

namespace {

/// Without gravity: a ball that flies to the right by a metre a second from the origin.
Level flyingBall() {
    Level level;
    level.gravity = Vec2(0, 0);
    level.iterations = 10;
    Object ball;
    ball.key = 1;
    ball.data = BodyObject{.kind = BodyKind::Dynamic, .shapes = {Circle{{0, 0}, 0.3}}, .velocity = {1, 0}};
    level.objects.append(ball);
    return level;
}

bool hasMark(const LiveRun& run, MarkKind kind) {
    const auto timeline = run.timeline();
    return std::ranges::any_of(timeline->marks.all(), [&](const TimelineMark& mark) { return mark.kind == kind; });
}

} // namespace

class TransportTest : public QObject {
    Q_OBJECT

  private slots:
    void bracketsChangeTheSpeedWithinItsLimitsAndRestartsKeepIt() {
        Game game;
        QCOMPARE(game.live().speed(), 1.0);
        for (int i = 0; i < 9; ++i) {
            QTest::keyClick(&game.view(), Qt::Key_BracketLeft);
        }
        QCOMPARE(game.live().speed(), 1.0 / 16);
        QCOMPARE(game.live().frame()->speed, 1.0 / 16);
        QTest::keyClick(&game.view(), Qt::Key_R);
        QCOMPARE(game.live().frame()->speed, 1.0 / 16);
        for (int i = 0; i < 9; ++i) {
            QTest::keyClick(&game.view(), Qt::Key_BracketRight);
        }
        QCOMPARE(game.live().speed(), 8.0);
    }
    void theStatusBarSaysHowFastTimeRuns() {
        TestWindow test;
        test.document().reset(flyingBall());
        test.trigger(Act::Simulate);
        test.trigger(Act::Slower);
        test.trigger(Act::Slower);
        QVERIFY2(test.window->statusLine().pace().contains("1/4 ×"), qPrintable(test.window->statusLine().pace()));
        for (int i = 0; i < 3; ++i) {
            QTest::keyClick(&test.canvas(), Qt::Key_BracketRight); // beside the tools of the editor, too
        }
        QVERIFY2(test.window->statusLine().pace().contains("2 ×"), qPrintable(test.window->statusLine().pace()));
        test.trigger(Act::Stop);
        test.trigger(Act::Simulate);
        QCOMPARE(test.window->liveRun().speed(), 1.0);
    }
    void theTimelineHasAMenuOfSpeedsUnlessItIsNarrow() {
        TestWindow test;
        test.document().reset(flyingBall());
        test.window->resize(1200, 800);
        test.trigger(Act::Simulate);
        TimelineBar& bar = test.window->timelineBar();
        QToolButton& button = bar.speedButton();
        QVERIFY(button.isVisible());
        QCOMPARE(button.text(), QString("1 ×"));
        const QList<QAction*> speeds = button.menu()->actions();
        QCOMPARE(speeds.size(), 8);
        speeds.front()->trigger();
        QCOMPARE(test.window->liveRun().speed(), Runner::slowest);
        QCOMPARE(button.text(), QString("1/16 ×"));
        test.trigger(Act::Faster);
        QCOMPARE(button.text(), QString("1/8 ×"));
        QVERIFY(speeds[1]->isChecked() && !speeds[0]->isChecked());

        TimelineBar small;
        const int least = small.minimumSizeHint().width();
        small.resize(least, 40);
        small.show();
        QVERIFY(!small.speedButton().isVisible());
        QCOMPARE(small.minimumSizeHint().width(), least);
    }
    void theStatusBarSaysWhereAHeldRunStands() {
        TestWindow test;
        test.document().reset(openSpace());
        test.trigger(Act::Play);
        const auto hint = [&] { return test.window->statusLine().hint(); };
        QTRY_VERIFY(hint().contains("Playing"));
        test.trigger(Act::Pause);
        QVERIFY2(hint().startsWith("Held"), qPrintable(hint()));
        test.trigger(Act::Stop);
        test.document().reset(flyingBall()); // ten iterations
        test.trigger(Act::Simulate);
        test.trigger(Act::StepIteration);
        QTRY_VERIFY2(hint().contains("iteration 1 of 10"), qPrintable(hint()));
        test.trigger(Act::StepIteration);
        QTRY_VERIFY2(hint().contains("iteration 2 of 10"), qPrintable(hint()));
        test.trigger(Act::Step);
        QTRY_VERIFY2(hint().contains("Simulation held"), qPrintable(hint()));
    }
    void whatIsHeldIsNotShownAgainAndAgain() {
        TestWindow test;
        test.document().reset(flyingBall());
        test.trigger(Act::Simulate);
        LiveRun& run = test.window->liveRun();
        QTRY_VERIFY(run.updates() > 5);
        test.trigger(Act::Pause);
        QTRY_VERIFY(run.frame()->paused && test.window->liveView().picture().update == run.updates());
        QTimer clock;
        int ticks = 0;
        connect(&clock, &QTimer::timeout, this, [&] { ++ticks; });
        clock.start(20);
        QTRY_VERIFY(ticks > 3); // what is left of the pause has been shown
        const QSignalSpy shown(&run, &LiveRun::advanced);
        QTRY_VERIFY(ticks > 12);
        QCOMPARE(shown.size(), 0);
        QVERIFY(!test.window->statusLine().pace().contains("fps"));
        test.trigger(Act::Step);
        QTRY_VERIFY(!shown.isEmpty());
        test.trigger(Act::Pause);
        QTRY_VERIFY(shown.size() > 10);
    }
    void commaAndPointGoBackAndForthByOneUpdate() {
        Game game(flyingBall());
        game.run(50);
        const double x = game.body(1).pose.position.x();
        QTest::keyClick(&game.view(), Qt::Key_Comma);
        QVERIFY(game.live().isPaused());
        QCOMPARE(game.picture()->update, std::int64_t(49));
        QTest::keyClick(&game.view(), Qt::Key_Comma);
        QVERIFY(std::abs(game.body(1).pose.position.x() - (x - 0.04)) < 1e-9);
        QTest::keyClick(&game.view(), Qt::Key_Period);
        QTest::keyClick(&game.view(), Qt::Key_Period);
        QCOMPARE(game.picture()->update, std::int64_t(50));
        QCOMPARE(game.body(1).pose.position.x(), x);
    }
    void oneIterationIsLookedAtWithoutMakingTheUpdate() {
        Game game(flyingBall());
        game.run(10);
        const double x = game.body(1).pose.position.x();
        game.live().stepIteration();
        QVERIFY(game.live().isPaused());
        const double moved = game.body(1).pose.position.x() - x;
        QVERIFY2(std::abs(moved - 0.002) < 1e-9, qPrintable(QString::number(moved)));
        for (int i = 0; i < 9; ++i) {
            game.live().stepIteration();
        }
        QCOMPARE(game.picture()->update, std::int64_t(11));
    }
    void holdingBackspaceTurnsTimeBackAndThenItGoesOn() {
        TestWindow test;
        test.document().reset(flyingBall());
        test.trigger(Act::Simulate);
        LiveRun& run = test.window->liveRun();
        QTRY_VERIFY(run.updates() > 30);
        QTest::keyPress(&test.canvas(), Qt::Key_Backspace);
        QVERIFY(run.isRewinding() && run.isPaused());
        const std::int64_t from = run.updates();
        QTRY_VERIFY(run.updates() < from - 5);
        QVERIFY(test.level() == flyingBall()); // nothing was deleted
        QTest::keyRelease(&test.canvas(), Qt::Key_Backspace);
        QVERIFY(!run.isRewinding() && !run.isPaused());
        const std::int64_t at = run.updates();
        QTRY_VERIFY(run.updates() > at + 3);
    }
    void whatIsSaidWhileTimeGoesBackHolds() {
        for (const Qt::Key key : {Qt::Key_R, Qt::Key_P}) { // begin anew; go on
            Game game(spaceWithCeiling());
            game.run(50);
            QTest::keyPress(&game.view(), Qt::Key_Backspace);
            QVERIFY(game.live().isRewinding());
            QTest::keyClick(&game.view(), key);
            QVERIFY(!game.live().isPaused());
            const QSignalSpy frames(&game.live(), &LiveRun::advanced);
            QTRY_VERIFY(frames.count() >= 5); // of which each would turn time back
            QTest::keyRelease(&game.view(), Qt::Key_Backspace);
            QVERIFY(!game.live().isPaused());
            const std::int64_t before = game.picture()->update;
            game.run(3);
            QCOMPARE(game.picture()->update, before + 3);
        }
        Game game(spaceWithCeiling());
        game.run(50);
        QTest::keyPress(&game.view(), Qt::Key_Backspace);
        game.live().stepBack();
        QVERIFY(!game.live().isRewinding());
        QTest::keyRelease(&game.view(), Qt::Key_Backspace);
        QVERIFY(game.live().isPaused()); // who looks at a moment goes on looking
    }
    void theTimelineGoesToTheMomentAndPlayGoesOnFromThere() {
        TestWindow test;
        test.document().reset(flyingBall());
        QVERIFY(!test.window->timelineBar().isVisible());
        test.trigger(Act::Simulate);
        QVERIFY(test.window->timelineBar().isVisible());
        LiveRun& run = test.window->liveRun();
        QTRY_VERIFY(run.updates() > 40);
        test.trigger(Act::Pause);
        TimelineScale& scale = test.window->timelineBar().scale();
        QTRY_COMPARE(scale.state().shown, run.timeline()->last);
        const std::int64_t last = scale.state().last;
        QTest::mouseClick(&scale, Qt::LeftButton, {}, QPoint(qRound(scale.xOf(last / 2)), 15));
        QTRY_VERIFY(std::abs(run.updates() - last / 2) <= 1);
        QVERIFY(run.isPaused());
        QTRY_COMPARE(scale.state().shown, run.updates());
        const std::int64_t shown = scale.state().shown;
        QTest::keyClick(&scale, Qt::Key_Right);
        QTest::keyClick(&scale, Qt::Key_Right);
        QTRY_COMPARE(run.updates(), shown + 2);
        QTest::keyClick(&scale, Qt::Key_Home);
        QTRY_COMPARE(run.updates(), std::int64_t(0));
        test.trigger(Act::TimeLast);
        QTRY_COMPARE(run.updates(), last);
        test.trigger(Act::TimeFirst);
        QTRY_COMPARE(run.updates(), std::int64_t(0));
        test.trigger(Act::Pause);
        QTRY_VERIFY(run.updates() > 0);
        QVERIFY(run.timeline()->last < last); // another future
        QVERIFY(!run.timeline()->ghosts.empty());
        test.trigger(Act::Stop);
        QVERIFY(!test.window->timelineBar().isVisible());
    }
    void theScaleTellsWhatHappenedAndWhen() {
        TimelineBar bar;
        bar.resize(700, 40);
        bar.show();
        MarkList marks;
        marks.append({100, MarkKind::Crash});
        marks.append({250, MarkKind::Win});
        bar.showState({.first = 0, .last = 300, .shown = 150, .goal = 300, .marks = marks});
        TimelineScale& scale = bar.scale();
        QVERIFY(!scale.accessibleName().isEmpty());
        QVERIFY2(bar.time().contains("3.00 / 6.00"), qPrintable(bar.time()));
        QVERIFY(scale.markAt(scale.xOf(100) + 2)->kind == MarkKind::Crash);
        QVERIFY(scale.markAt(scale.xOf(250))->kind == MarkKind::Win);
        QVERIFY(!scale.markAt(scale.xOf(180)));
        QCOMPARE(scale.updateAt(scale.xOf(77)), std::int64_t(77));
        const QImage with = scale.grab().toImage();
        bar.showState({.first = 0, .last = 300, .shown = 150, .goal = 300});
        QVERIFY(with != scale.grab().toImage());
        QSignalSpy sought(&scale, &TimelineScale::sought);
        QTest::mouseClick(&scale, Qt::LeftButton, {}, QPoint(-20, 15)); // beyond the end
        QCOMPARE(sought.last().at(0).toLongLong(), qint64(0));
    }
    void aCrashIsMarkedOnTheTimeline() {
        Game game(spaceWithCeiling());
        QTest::keyPress(&game.view(), Qt::Key_W);
        game.run(200);
        QCOMPARE(game.phase(), Phase::Crashed);
        QVERIFY(hasMark(game.live(), MarkKind::Crash));
        QVERIFY(!hasMark(game.live(), MarkKind::Win));
    }
    void aBodyIsPulledByTheMouseAndThrown() {
        Game game(flyingBall());
        game.live().wantSession(&game, true);
        game.run(10);
        QTest::mousePress(&game.view(), Qt::LeftButton, {}, game.at({0.2, 0}));
        QTest::mouseMove(&game.view(), game.at({0.2, 1}));
        QVERIFY(game.scene().hand().grab().has_value());
        game.run(4);
        QVERIFY(game.body(1).velocity.y() > 0.5);
        game.viewport();
        const QImage pulled = game.view().grab().toImage();
        QTest::mouseRelease(&game.view(), Qt::LeftButton, {}, game.at({0.2, 1}));
        QVERIFY(!game.scene().hand().grab());
        QVERIFY(pulled != game.view().grab().toImage()); // the spring was shown
        game.run(1);
        const Vec2 thrown = game.body(1).velocity;
        game.run(50);
        QVERIFY((game.body(1).velocity - thrown).norm() < 1e-9);
        QVERIFY(game.document().level() == flyingBall());
    }
    void aLevelThatIsEditedWhileItRunsGoesOnAsItIsNow() {
        TestWindow test;
        test.document().reset(flyingBall());
        test.trigger(Act::Simulate);
        LiveRun& run = test.window->liveRun();
        const auto bodies = [&] { return run.frame()->now->bodies(); };
        QTRY_VERIFY(run.updates() > 5);
        QCOMPARE(bodies(), std::size_t(1));
        test.trigger(ToolId::Circle);
        test.drag(0, 3, 0.5, 3);
        QTRY_COMPARE(bodies(), std::size_t(2));
        test.trigger(ToolId::Select);
        test.document().select(Selection({1}));
        test.trigger(Act::Delete);
        QTRY_COMPARE(bodies(), std::size_t(1));
        test.trigger(Act::Undo);
        QTRY_COMPARE(bodies(), std::size_t(2));
        QVERIFY(run.updates() > 5); // it has not begun anew
    }
    void aFlightThatWasSavedOpensOnTheTimelineAndCanBeTakenOver() {
        TestWindow test;
        test.document().reset(openSpace());
        const QString path = test.file("up.replay.json");
        test.window->whereToSaveFlight = [&](const QString&) { return path; };
        test.trigger(Act::Play);
        QTest::keyPress(&test.canvas(), Qt::Key_Up);
        QTRY_VERIFY(test.window->liveRun().updates() > 20);
        test.trigger(Act::SaveFlight);
        QVERIFY(test.window->liveRun().isPaused());
        test.window->flightFile().finish();
        QVERIFY(QFile::exists(path));
        const std::int64_t flown = test.window->liveRun().timeline()->last;
        test.trigger(Act::Stop);
        const Result<Replay> replay = readReplay(path.toStdU16String());
        QVERIFY(bool(replay));
        QCOMPARE(replay.value().updates(), flown);
        QVERIFY(replay.value().levelHash == levelHash(openSpace()));
        QVERIFY(replay.value().ended == flightResult(openSpace(), replay.value()));
        test.window->playReplay(replay.value());
        LiveRun& run = test.window->liveRun();
        QVERIFY(run.isWatching());
        QTRY_COMPARE(run.timeline()->goal, flown);
        QTRY_VERIFY(run.isPaused()); // at its end
        QCOMPARE(run.updates(), flown);
        test.trigger(Act::Pause);
        QTRY_VERIFY(run.updates() > flown);
    }
};

SPACETOW_TEST(TransportTest)
#include "transport_test.moc"
