// A level that takes long to build is built beside the window, and one edits on until it runs.
#include "tests/support/game_levels.h"
#include "tests/support/test_main.h"
#include "tests/support/window.h"

using namespace spacetow;
using namespace spacetow::test;

namespace {

constexpr Key firstBall = 100;

/// A ship beside balls that float, more than are built within a frame.
Level manyBalls() {
    Level level = openSpace();
    constexpr int perRow = 33;
    for (int i = 0; i < perRow * perRow; ++i) {
        Object ball;
        ball.key = firstBall + static_cast<Key>(i);
        ball.data = BodyObject{.kind = BodyKind::Dynamic,
                               .shapes = {Circle{{0, 0}, 0.1}},
                               .position = {5.0 + i % perRow, 5.0 + i / perRow}}; // NOLINT(bugprone-integer-division)
        level.objects.append(ball);
    }
    return level;
}

struct Starting : TestWindow {
    Starting() { document().reset(manyBalls()); }
    LiveRun& run() { return window->liveRun(); }
    bool isPossible(Act act) { return window->actions()[act].isEnabled(); }
    /// Of those that have been given up.
    bool allHaveEnded() { return run().ending() == 0; }
};

} // namespace

class StartingTest : public QObject {
    Q_OBJECT

  private slots:
    void aLargeLevelIsBuiltBesideTheWindowWhichSaysSo() {
        Starting test;
        test.trigger(Act::Play);
        QVERIFY(test.run().isStarting() && !test.run().isRunning() && !test.window->isPlaying());
        QVERIFY(!test.canvas().isLive() && test.window->inspector().isVisible());
        QVERIFY2(test.window->statusLine().hint().contains("Getting ready"),
                 qPrintable(test.window->statusLine().hint()));
        QVERIFY(test.isPossible(Act::Stop) && !test.isPossible(Act::Pause));
        QTRY_VERIFY(test.window->isInGame());
        QVERIFY(!test.run().isStarting() && test.canvas().isLive() && test.isPossible(Act::Pause));
        QVERIFY(!test.window->statusLine().hint().contains("Getting ready"));
        QTest::keyPress(&test.canvas(), Qt::Key_W);
        QTRY_VERIFY(test.run().updates() > 2);
    }
    void aSmallLevelRunsAtOnce() {
        TestWindow test;
        test.document().reset(openSpace());
        test.trigger(Act::Play);
        QVERIFY(test.window->isInGame() && !test.window->liveRun().isStarting());
    }
    void stoppingLeavesARunThatIsGettingReady() {
        Starting test;
        test.trigger(Act::Simulate);
        test.trigger(Act::Stop);
        QVERIFY(!test.run().isStarting() && !test.isPossible(Act::Stop));
        QTRY_VERIFY(test.allHaveEnded());
        QVERIFY(!test.window->isPlaying());
        QVERIFY(!test.window->openLevel()->runChanges.isRunning());
        QVERIFY(!test.window->statusLine().hint().contains("Getting ready"));
    }
    void whoPressesAgainWaitsForTheSameRunAndWhoWantsAnotherGetsThat() {
        Starting test;
        test.trigger(Act::Simulate);
        test.trigger(Act::Simulate);
        QCOMPARE(test.run().ending(), 0);
        test.trigger(Act::Play);
        QVERIFY(test.run().isStarting());
        QTRY_VERIFY(test.window->isPlaying());
        QVERIFY(test.window->isInGame());
    }
    void whatIsEditedMeanwhileRunsAndIsNoChangeOfTheRun() {
        Starting test;
        test.trigger(Act::Simulate);
        test.document().select(Selection({firstBall}));
        test.trigger(Act::Delete);
        QCOMPARE(test.level().objects.find(firstBall), nullptr);
        QTRY_VERIFY(test.window->isPlaying());
        QTRY_VERIFY(test.run().session() && test.run().session()->level().objects.find(firstBall) == nullptr);
        QVERIFY(!test.run().session()->bodyOf(firstBall));
        QVERIFY(test.run().session()->bodyOf(firstBall + 1));
        test.trigger(Act::Stop);
        QVERIFY(!test.window->openLevel()->runChanges.areWaiting());
        QCOMPARE(test.level().objects.find(firstBall), nullptr);
    }
    void whatIsToldARunBeforeItIsThereHoldsThen() {
        Starting test;
        test.trigger(Act::Simulate);
        test.run().setPaused(true);
        QTRY_VERIFY(test.window->isPlaying());
        QVERIFY(test.run().isPaused() && test.window->actions()[Act::Pause].isChecked());
        QTRY_VERIFY(test.run().frame()->paused);
        const std::int64_t then = test.run().updates(); // it may have begun
        test.trigger(Act::Step);
        QTRY_COMPARE(test.run().updates(), then + 1);
    }
    void anotherLevelIsOpenedWithoutTheRun() {
        Starting test;
        test.trigger(Act::Play);
        test.unsaved = Unsaved::Discard;
        test.window->startNew();
        QVERIFY(!test.run().isStarting());
        QTRY_VERIFY(test.allHaveEnded());
        QVERIFY(!test.window->isPlaying());
    }
};

SPACETOW_TEST(StartingTest)
#include "starting_test.moc"
