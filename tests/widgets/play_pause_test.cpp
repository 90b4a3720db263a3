// A game that stands still: what its keys do meanwhile.
#include "tests/support/game_view.h"
#include "tests/support/test_main.h"

using namespace spacetow;
using namespace spacetow::test;

class PlayPauseTest : public QObject {
    Q_OBJECT

  private slots:
    void pauseKeepsTheSceneInSightAndStepsSingly() {
        Game game;
        game.tap(Qt::Key_W);
        const std::int64_t at = game.picture()->update;
        QTest::keyClick(&game.view(), Qt::Key_P);
        QVERIFY(game.view().isPaused());
        QVERIFY(!game.menu()->isVisible());
        game.run(5);
        QTest::keyClick(&game.view(), Qt::Key_O);
        QTest::keyClick(&game.view(), Qt::Key_O);
        QCOMPARE(game.picture()->update, at + 2);
        QTest::keyClick(&game.view(), Qt::Key_P);
        QVERIFY(!game.view().isPaused());
        game.run(1);
        QCOMPARE(game.picture()->update, at + 3);
    }
    void otherKeysThanTheUsualOnesPlayAndAreNamed() {
        Game game;
        PlayKeys keys;
        keys.set(PlayKey::Thrust, {QKeySequence("I")});
        keys.set(PlayKey::Pause, {QKeySequence("K")});
        keys.set(PlayKey::Restart, {QKeySequence("L")});
        game.view().setKeys(keys);
        game.tap(Qt::Key_W); // nobody's now
        QCOMPARE(game.phase(), Phase::AwaitingInput);
        game.tap(Qt::Key_I);
        QCOMPARE(game.phase(), Phase::Flying);
        QTest::keyClick(&game.view(), Qt::Key_K);
        QVERIFY(game.view().isPaused());
        QTest::keyClick(&game.view(), Qt::Key_K);
        QVERIFY(!game.view().isPaused());
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

SPACETOW_TEST(PlayPauseTest)
#include "play_pause_test.moc"
