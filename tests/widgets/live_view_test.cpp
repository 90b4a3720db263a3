#include "tests/support/test_main.h"

#include "tests/support/game_levels.h"
#include "tests/support/game_view.h"

#include <QApplication>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QWheelEvent>

using namespace spacetow;
using namespace spacetow::test;

namespace {

Level ballAlone(double radius) {
    Level level;
    level.gravity = Vec2(0, 0);
    level.rules.background = "none";
    addBall(level, Vec2(0, 0), radius, Vec2(0, 0));
    return level;
}

} // namespace

class LiveViewTest : public QObject {
    Q_OBJECT

  private slots:
    void keysSteer_data() {
        QTest::addColumn<int>("key");
        QTest::addColumn<Controls>("controls");
        QTest::addRow("Left") << int(Qt::Key_Left) << left;
        QTest::addRow("A") << int(Qt::Key_A) << left;
        QTest::addRow("Right") << int(Qt::Key_Right) << right;
        QTest::addRow("D") << int(Qt::Key_D) << right;
        QTest::addRow("Up") << int(Qt::Key_Up) << thrust;
        QTest::addRow("W") << int(Qt::Key_W) << thrust;
        QTest::addRow("Space") << int(Qt::Key_Space) << tow;
    }
    void keysSteer() {
        QFETCH(int, key);
        QFETCH(Controls, controls);
        Game game;
        QTest::keyPress(&game.view(), static_cast<Qt::Key>(key));
        game.run(3);
        QVERIFY(game.picture()->controls == controls);
        QCOMPARE(game.phase(), controls == tow ? Phase::AwaitingInput : Phase::Flying);
        QTest::keyRelease(&game.view(), static_cast<Qt::Key>(key));
        game.run(2);
        QVERIFY(game.picture()->controls == idle);
    }
    void aGameIsLeftWithoutWaitingForItsUpdate() {
        LiveRun run;
        run.start(ballAlone(1));
        QCOMPARE(run.ending(), 0);
        run.stop();
        QVERIFY(!run.isRunning());
        QCOMPARE(run.ending(), 1); // it ends beside
        run.start(ballAlone(2));
        QVERIFY(run.isRunning());
        QTRY_COMPARE(run.ending(), 0);
    }
    void lettingGoOfOneOfTwoKeysKeepsSteering() {
        Game game;
        QTest::keyPress(&game.view(), Qt::Key_Left);
        QTest::keyPress(&game.view(), Qt::Key_A);
        QTest::keyRelease(&game.view(), Qt::Key_Left);
        game.run(2);
        QVERIFY(game.picture()->controls == left);
    }
    void autoRepeatIsNoPress() {
        Game game(spaceWithCeiling());
        QTest::keyPress(&game.view(), Qt::Key_W);
        game.run(200);
        QCOMPARE(game.phase(), Phase::Crashed);
        for (int i = 0; i < 5; ++i) {
            QKeyEvent released(QEvent::KeyRelease, Qt::Key_W, Qt::NoModifier, "w", true);
            QKeyEvent pressed(QEvent::KeyPress, Qt::Key_W, Qt::NoModifier, "w", true);
            QApplication::sendEvent(&game.view(), &released);
            QApplication::sendEvent(&game.view(), &pressed);
            game.run(2);
        }
        QCOMPARE(game.phase(), Phase::Crashed);
        QVERIFY(game.picture()->controls == thrust);
    }
    void anyKeyOrClickTriesAgain_data() {
        QTest::addColumn<int>("key");
        QTest::addRow("a letter") << int(Qt::Key_X);
        QTest::addRow("Enter") << int(Qt::Key_Return);
        QTest::addRow("a direction") << int(Qt::Key_Left);
        QTest::addRow("Space") << int(Qt::Key_Space);
        QTest::addRow("a click") << 0;
    }
    void anyKeyOrClickTriesAgain() {
        QFETCH(int, key);
        Game game(spaceWithCeiling());
        QTest::keyPress(&game.view(), Qt::Key_W);
        game.run(200);
        QTest::keyRelease(&game.view(), Qt::Key_W);
        game.run(2);
        QCOMPARE(game.phase(), Phase::Crashed);
        QTest::keyPress(&game.view(), Qt::Key_Shift); // no key that does anything
        game.run(2);
        QCOMPARE(game.phase(), Phase::Crashed);
        if (key == 0) {
            QTest::mouseClick(&game.view(), Qt::LeftButton);
        } else {
            QTest::keyPress(&game.view(), static_cast<Qt::Key>(key));
        }
        game.run(1);
        QCOMPARE(game.phase(), Phase::AwaitingInput);
        QCOMPARE(game.picture()->hud.lives, 2);
    }
    void spaceFliesAgainAfterTheWin() {
        Game game;
        game.tap(Qt::Key_D);
        game.tap(Qt::Key_Space);
        QCOMPARE(game.phase(), Phase::Towing);
        QTest::keyPress(&game.view(), Qt::Key_W);
        game.run(300);
        QTest::keyRelease(&game.view(), Qt::Key_W);
        QCOMPARE(game.phase(), Phase::Won);
        QTest::keyPress(&game.view(), Qt::Key_Space);
        QCOMPARE(game.phase(), Phase::AwaitingInput);
        QCOMPARE(game.picture()->hud.lives, 3);
    }

    void escapeOpensTheMenuAndClosesItAgain() {
        Game game;
        QSignalSpy paused(&game.live(), &LiveRun::pausedChanged);
        game.tap(Qt::Key_W);
        QTest::keyPress(&game.view(), Qt::Key_W);
        QTest::keyClick(&game.view(), Qt::Key_Escape);
        QVERIFY(game.menu()->isVisible());
        QVERIFY(game.live().isPaused());
        const std::int64_t at = game.picture()->update;
        game.run(50);
        QCOMPARE(game.picture()->update, at);
        QTest::keyClick(game.menu(), Qt::Key_Escape);
        QVERIFY(!game.menu()->isVisible());
        QVERIFY(!game.live().isPaused());
        game.run(2);
        QVERIFY(game.picture()->controls == idle); // what was held is forgotten
        QCOMPARE(game.picture()->update, at + 2);
        QCOMPARE(paused.count(), 2);
    }
    void theMenuRestartsAndLeaves() {
        Game game;
        QSignalSpy finished(&game.scene(), &LiveView::finished);
        game.tap(Qt::Key_W);
        QTest::keyClick(&game.view(), Qt::Key_Escape);
        QTest::mouseClick(game.button("Restart"), Qt::LeftButton);
        QVERIFY(!game.live().isPaused());
        QCOMPARE(game.phase(), Phase::AwaitingInput);
        QCOMPARE(game.picture()->update, std::int64_t(0));
        QCOMPARE(finished.count(), 0);
        QTest::keyClick(&game.view(), Qt::Key_Escape);
        QTest::mouseClick(game.button("Back to the editor"), Qt::LeftButton);
        QCOMPARE(finished.count(), 1);
        QVERIFY(!game.live().isRunning());
        QVERIFY(!game.menu()->isVisible());
        QTest::keyClick(&game.view(), Qt::Key_Escape); // nothing left to pause
        QVERIFY(!game.menu()->isVisible());
    }
    void theMenuWorksWithoutAMouse() {
        Game game;
        QSignalSpy finished(&game.scene(), &LiveView::finished);
        QTest::keyClick(&game.view(), Qt::Key_Escape);
        QTest::keyClick(game.menu(), Qt::Key_Return); // on "Resume"
        QVERIFY(!game.live().isPaused());
        QTest::keyClick(&game.view(), Qt::Key_Escape);
        QTest::keyClick(game.menu(), Qt::Key_Down);
        QTest::keyClick(game.menu(), Qt::Key_Down);
        QTest::keyClick(game.menu()->focusWidget(), Qt::Key_Enter);
        QCOMPARE(finished.count(), 1);
    }
    void theMenuFitsItsWordsAndTheView_data() {
        QTest::addColumn<QSize>("size");
        QTest::addRow("tiny") << QSize(200, 150);
        QTest::addRow("small") << QSize(320, 240);
        QTest::addRow("usual") << QSize(880, 660);
        QTest::addRow("flat") << QSize(1600, 300);
    }
    void theMenuFitsItsWordsAndTheView() {
        QFETCH(QSize, size);
        Game game(openSpace(), size);
        QTest::keyClick(&game.view(), Qt::Key_Escape);
        QVERIFY(game.view().rect().contains(game.menu()->geometry()));
        for (auto* button : game.menu()->findChildren<QPushButton*>()) {
            QVERIFY2(button->width() >= button->sizeHint().width(), qPrintable(button->text()));
            QVERIFY2(button->height() >= button->sizeHint().height(), qPrintable(button->text()));
        }
    }
    void theMenuSaysWhatHasHappened() {
        Game crashed(spaceWithCeiling());
        const auto says = [](Game& game, const QString& title) {
            QTest::keyClick(&game.view(), Qt::Key_Escape);
            for (const auto* label : game.menu()->findChildren<QLabel*>()) {
                if (label->text() == title) {
                    return game.menu()->isVisible();
                }
            }
            return false;
        };
        crashed.tap(Qt::Key_A);
        QVERIFY(says(crashed, "Paused"));
        QTest::keyClick(crashed.menu(), Qt::Key_Escape);
        QTest::keyPress(&crashed.view(), Qt::Key_D);
        QTest::keyPress(&crashed.view(), Qt::Key_W);
        crashed.run(600);
        QVERIFY(crashed.phase() == Phase::Crashed);
        QVERIFY(says(crashed, "Crashed"));
        Game won;
        won.tap(Qt::Key_D);
        won.tap(Qt::Key_Space);
        QTest::keyPress(&won.view(), Qt::Key_W);
        won.run(300);
        QCOMPARE(won.phase(), Phase::Won);
        QVERIFY(says(won, "You made it!"));
        QVERIFY(!won.button("Resume")->isVisible());
        QTest::keyClick(won.menu(), Qt::Key_Return);
        QCOMPARE(won.phase(), Phase::AwaitingInput);
    }
    void gameOverIsSeenThoughAKeyIsHeld() {
        Level level = spaceWithCeiling();
        level.rules.lives = 1;
        Game game(level);
        QTest::keyPress(&game.view(), Qt::Key_W);
        game.run(200);
        QCOMPARE(game.phase(), Phase::GameOver);
        for (const Qt::Key key : {Qt::Key_A, Qt::Key_X, Qt::Key_Space}) {
            game.tap(key);
        }
        QCOMPARE(game.phase(), Phase::GameOver);
        QTest::keyRelease(&game.view(), Qt::Key_W);
        game.run(1);
        game.tap(Qt::Key_X);
        QCOMPARE(game.phase(), Phase::AwaitingInput);
    }
    void restartKeyStartsOver() {
        Game game;
        game.tap(Qt::Key_W);
        game.run(20);
        QTest::keyClick(&game.view(), Qt::Key_R);
        QCOMPARE(game.picture()->update, std::int64_t(0));
    }
    void losingTheFocusPausesAndLetsGo() {
        Game game;
        QTest::keyPress(&game.view(), Qt::Key_W);
        game.run(1);
        QFocusEvent away(QEvent::FocusOut, Qt::ActiveWindowFocusReason);
        QApplication::sendEvent(&game.view(), &away);
        QVERIFY(game.live().isPaused());
        QVERIFY(game.menu()->isVisible());
        QTest::mouseClick(game.button("Resume"), Qt::LeftButton);
        QVERIFY(!game.live().isPaused());
        game.run(2);
        QVERIFY(game.picture()->controls == idle);
    }
    void hidingPausesAndShowingOffersToGoOn() {
        Game game;
        game.view().hide();
        QVERIFY(game.live().isPaused());
        game.view().show();
        QVERIFY(game.menu()->isVisible());
    }
    void letteredShortcutsOfTheWindowStayAsideWhilePlaying() {
        Game game;
        const auto claimed = [&](int key, Qt::KeyboardModifiers modifiers) {
            QKeyEvent override(QEvent::ShortcutOverride, key, modifiers);
            override.ignore();
            QApplication::sendEvent(&game.view(), &override);
            return override.isAccepted();
        };
        QVERIFY(claimed(Qt::Key_A, Qt::NoModifier));
        QVERIFY(claimed(Qt::Key_Space, Qt::NoModifier));
        QVERIFY(claimed(Qt::Key_Escape, Qt::NoModifier));
        QVERIFY(!claimed(Qt::Key_A, Qt::ControlModifier));
        QVERIFY(!claimed(Qt::Key_F5, Qt::NoModifier));
        game.live().stop();
        QVERIFY(!claimed(Qt::Key_A, Qt::NoModifier));
    }

    void circlesStayRoundAndTheClassicViewFits_data() {
        QTest::addColumn<QSize>("size");
        QTest::addRow("wide") << QSize(1600, 600);
        QTest::addRow("tall") << QSize(500, 900);
        QTest::addRow("classic") << QSize(880, 660);
    }
    void circlesStayRoundAndTheClassicViewFits() {
        QFETCH(QSize, size);
        Game game(ballAlone(2), size);
        const Aabb seen = game.viewport().visible();
        QVERIFY(seen.size().x() >= 13.33 - 0.01);
        QVERIFY(seen.size().y() >= 10 - 1e-9);
        game.view().setGridVisible(false);
        const QImage with = game.view().grab().toImage();
        game.start(Level{.gravity = Vec2(0, 0), .rules = {.background = "none"}});
        const QImage without = game.view().grab().toImage();
        QRect changed;
        for (int y = 0; y < with.height(); ++y) {
            for (int x = 0; x < with.width(); ++x) {
                if (with.pixel(x, y) != without.pixel(x, y)) {
                    changed |= QRect(x, y, 1, 1);
                }
            }
        }
        const double expected = 4 * game.viewport().scale;
        QVERIFY2(std::abs(changed.width() - changed.height()) <= 2,
                 qPrintable(QString("%1 x %2").arg(changed.width()).arg(changed.height())));
        QVERIFY(std::abs(changed.width() - expected) < 8);
    }
    void theShipStaysInSightWhereverItFlies() {
        Game game;
        QTest::keyPress(&game.view(), Qt::Key_W);
        for (int i = 0; i < 200; ++i) {
            game.run(5);
            for (const BodyPicture& body : game.picture()->moving) {
                if (body.look->role == BodyRole::Ship) {
                    QVERIFY2(game.viewport().visible().contains(body.pose.position), qPrintable(QString::number(i)));
                }
            }
        }
        QVERIFY(game.picture()->update >= 1000);
    }
    void aLargeSandboxIsShownWhole() {
        Level level = ballAlone(1);
        addBall(level, Vec2(100, 3), 1, Vec2(0, 0));
        Game game(level);
        const Aabb seen = game.viewport().visible();
        QVERIFY(seen.contains(Vec2(-1, 0)) && seen.contains(Vec2(101, 3)));
    }
    void wheelZoomsAndFFollowsAgain() {
        Game game;
        const double scale = game.viewport().scale;
        QWheelEvent wheel({400, 300}, {400, 300}, {}, {0, 120}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
        QApplication::sendEvent(&game.view(), &wheel);
        QVERIFY(game.viewport().scale > 1.1 * scale);
        QTest::mousePress(&game.view(), Qt::RightButton, {}, {100, 100});
        QMouseEvent move(QEvent::MouseMove, QPointF(160, 100), QPointF(160, 100), Qt::NoButton, Qt::RightButton, {});
        QApplication::sendEvent(&game.view(), &move);
        QTest::mouseRelease(&game.view(), Qt::RightButton, {}, {160, 100});
        const double moved = game.viewport().center.x();
        QTest::keyClick(&game.view(), Qt::Key_F);
        QVERIFY(game.viewport().center.x() > moved + 0.5);
        QCOMPARE(game.viewport().scale, scale);
    }
    void aThreadedGameRunsByItself() {
        LiveRun run;
        run.start(openSpace());
        QTRY_VERIFY_WITH_TIMEOUT(run.frame()->now->update >= 3, 10000);
        run.stop();
        QVERIFY(!run.isRunning());
        run.stop(); // twice is once
    }
};

SPACETOW_TEST(LiveViewTest)
#include "live_view_test.moc"
