// A game that stands still: what its keys do meanwhile.
#include "tests/support/game_view.h"
#include "tests/support/test_main.h"
#include "tests/support/window.h"

using namespace spacetow;
using namespace spacetow::test;

class LivePauseTest : public QObject {
    Q_OBJECT

  private slots:
    void pauseKeepsTheSceneInSightAndStepsSingly() {
        Game game;
        game.tap(Qt::Key_W);
        const std::int64_t at = game.picture()->update;
        QTest::keyClick(&game.view(), Qt::Key_P);
        QVERIFY(game.live().isPaused());
        QVERIFY(!game.menu()->isVisible());
        game.run(5);
        QTest::keyClick(&game.view(), Qt::Key_O);
        QTest::keyClick(&game.view(), Qt::Key_O);
        QCOMPARE(game.picture()->update, at + 2);
        QTest::keyClick(&game.view(), Qt::Key_P);
        QVERIFY(!game.live().isPaused());
        game.run(1);
        QCOMPARE(game.picture()->update, at + 3);
    }
    void aGameThatTheComputerCannotHoldEndsWithASentence() {
        TestWindow test;
        Level level = openSpace();
        for (int i = 0; i < 2000; ++i) {
            addBall(level, Vec2(5, 5), 1, Vec2(0, 0));
        }
        test.document().reset(level);
        test.trigger(Act::Play);
        QTRY_VERIFY(test.window->isPlaying());
        QTest::keyPress(&test.canvas(), Qt::Key_W);
        QTRY_VERIFY2(test.window->messageBar().text().contains("memory"), qPrintable(test.window->messageBar().text()));
        QVERIFY(!test.window->isPlaying() && !test.window->liveRun().isStarting());
        QVERIFY(test.level() == level);
    }
    void aGameThatIsTooMuchForTheComputerSaysHowFarBehindItIs() {
        TestWindow test;
        Level level = openSpace();
        level.updateSeconds = 1e-5; // a hundred thousand updates a second
        test.document().reset(level);
        test.trigger(Act::Play);
        QTest::keyPress(&test.canvas(), Qt::Key_W);
        QTRY_VERIFY(test.window->liveRun().behind() > 0);
        const QString hint = test.window->statusLine().hint();
        QVERIFY2(hint.contains("behind real time"), qPrintable(hint));
        test.trigger(Act::Stop);
        QCOMPARE(test.window->liveRun().behind(), 0.0);
    }
    void otherKeysThanTheUsualOnesPlayAndAreNamed() {
        Game game;
        PlayKeys keys;
        keys.set(PlayKey::Thrust, {QKeySequence("I")});
        keys.set(PlayKey::Pause, {QKeySequence("K")});
        keys.set(PlayKey::Restart, {QKeySequence("L")});
        game.scene().setKeys(keys);
        game.tap(Qt::Key_W); // nobody's now
        QCOMPARE(game.phase(), Phase::AwaitingInput);
        game.tap(Qt::Key_I);
        QCOMPARE(game.phase(), Phase::Flying);
        QTest::keyClick(&game.view(), Qt::Key_K);
        QVERIFY(game.live().isPaused());
        QTest::keyClick(&game.view(), Qt::Key_K);
        QVERIFY(!game.live().isPaused());
        QTest::keyClick(&game.view(), Qt::Key_Escape);
        QVERIFY(game.menu()->isVisible());
        QVERIFY(game.button("Restart")->toolTip().contains("(L)"));
        QTest::keyClick(game.menu(), Qt::Key_L);
        QCOMPARE(game.phase(), Phase::AwaitingInput);
    }
    void aKeyHeldWhilePausedCountsInSteps() {
        Game game;
        game.tap(Qt::Key_W);
        QTest::keyClick(&game.view(), Qt::Key_P);
        QTest::keyPress(&game.view(), Qt::Key_W);
        QTest::keyClick(&game.view(), Qt::Key_O);
        QVERIFY(game.picture()->controls == thrust);
        QTest::keyRelease(&game.view(), Qt::Key_W);
        QTest::keyClick(&game.view(), Qt::Key_O);
        QVERIFY(game.picture()->controls == idle);
    }
    void aKeyHeldFromBeforeThePauseCountsInStepsAndAfterwards() {
        Game game;
        QTest::keyPress(&game.view(), Qt::Key_W);
        game.run(3);
        QTest::keyClick(&game.view(), Qt::Key_P);
        QTest::keyClick(&game.view(), Qt::Key_O);
        QVERIFY(game.picture()->controls == thrust);
        QTest::keyClick(&game.view(), Qt::Key_P);
        game.run(1);
        QVERIFY(game.picture()->controls == thrust);
        QTest::keyRelease(&game.view(), Qt::Key_W);
        game.run(1);
        QVERIFY(game.picture()->controls == idle);
    }
    void aKeyTappedWhilePausedIsForgotten() {
        Game game;
        game.tap(Qt::Key_W);
        QTest::keyClick(&game.view(), Qt::Key_P);
        QTest::keyClick(&game.view(), Qt::Key_Space);
        QTest::keyClick(&game.view(), Qt::Key_W);
        QTest::keyClick(&game.view(), Qt::Key_P);
        game.run(1);
        QVERIFY(game.picture()->controls == idle);
    }
};

SPACETOW_TEST(LivePauseTest)
#include "live_pause_test.moc"
