// What an attempt costs, what the next one finds again.
#include "core/game/session.h"
#include "core/game/ship.h"
#include "tests/support/game_levels.h"
#include "tests/support/test_main.h"

using namespace spacetow;
using namespace spacetow::test;

class AttemptsTest : public QObject {
    Q_OBJECT

  private slots:
    void theLevelIsOverWhenNoLifeIsLeftAndAPressStartsItOver() {
        Session session(spaceWithCeiling());
        for (int lives = 2; lives >= 0; --lives) {
            press(session, thrust);
            QVERIFY(holdUntil(session, thrust, lives > 0 ? Phase::Crashed : Phase::GameOver));
            QCOMPARE(session.lives(), lives);
            if (lives > 0) {
                press(session, tow);
            }
        }
        QVERIFY(session.fuel() > 0);
        hold(session, thrust, 20); // held since the crash: no fresh press
        QCOMPARE(session.phase(), Phase::GameOver);
        press(session, right);
        QCOMPARE(session.phase(), Phase::AwaitingInput);
        QCOMPARE(session.lives(), 3);
        QCOMPARE(session.fuel(), 0.0);
        QCOMPARE(count(session, BodyRole::Debris), std::size_t(0));
    }

    void fuelAndTimeAreThoseOfTheAttempt() {
        Session session(spaceWithCeiling());
        hold(session, left, 10);
        hold(session, idle, 10);
        QCOMPARE(session.fuel(), 0.0);
        hold(session, thrust, 5);
        QVERIFY(std::abs(session.fuel() - 0.1) < 1e-12);
        QVERIFY(std::abs(session.time() - 0.5) < 1e-12);
        while (session.phase() == Phase::Flying && session.updates() < 5000) {
            session.step(session.updates() % 2 == 0 ? thrust : left);
        }
        const double spent = session.fuel();
        const double time = session.time();
        QVERIFY(spent > 0.1);
        hold(session, thrust, 20);
        QCOMPARE(session.fuel(), spent); // both stand still, to be read
        QCOMPARE(session.time(), time);
        press(session, left);
        QCOMPARE(session.fuel(), 0.0);
        QCOMPARE(session.time(), 0.0);
        press(session, thrust);
        QVERIFY(std::abs(session.fuel() - 0.02) < 1e-12);
        QVERIFY(std::abs(session.time() - 0.02) < 1e-12);
    }

    void whatIsHeldThroughACrashStartsNoLife_data() {
        QTest::addColumn<int>("lives");
        QTest::newRow("crashed") << 3;
        QTest::newRow("game over") << 1;
    }
    void whatIsHeldThroughACrashStartsNoLife() {
        QFETCH(int, lives);
        Level level = spaceWithCeiling();
        level.rules.lives = lives;
        const Phase over = lives > 1 ? Phase::Crashed : Phase::GameOver;
        Session session(level);
        QVERIFY(holdUntil(session, thrust, over));
        hold(session, thrust, 50);
        QCOMPARE(session.phase(), over);
        for (int i = 0; i < 10; ++i) { // steering on with the other hand is no wish to start
            session.step({.left = true, .thrust = true});
            session.step(thrust);
        }
        QCOMPARE(session.phase(), over);
        hold(session, idle, 1);
        session.step(left);
        QCOMPARE(session.phase(), Phase::AwaitingInput);
    }

    void gravityTurnsOverWithTheTowUntilTheNextAttempt() {
        Level level = openSpace();
        level.gravity = Vec2(0.1, -0.95);
        level.rules.flipGravityOnTow = true;
        Session session = towing(level);
        QVERIFY(session.world().parameters().gravity == Vec2(-0.1, 0.95));
        QVERIFY(heard(session, Sound::GravityFlip));
        QVERIFY(session.hud().gravityFlippedFor > 0 && session.hud().gravityFlippedFor < 0.05);
        hold(session, idle, 50);
        QVERIFY(session.hud().gravityFlippedFor > 1);
        QVERIFY(session.payload()->velocity.y() > 0);
        QVERIFY(holdUntil(session, idle, Phase::Won)); // both fall upwards
        QVERIFY(session.world().parameters().gravity == Vec2(-0.1, 0.95));
    }
    void aNewAttemptTurnsGravityBack() {
        Level level = spaceWithCeiling();
        level.gravity = Vec2(0.1, -0.95);
        level.rules.flipGravityOnTow = true;
        Session session = towing(level);
        QVERIFY(holdUntil(session, idle, Phase::Crashed));
        QVERIFY(session.world().parameters().gravity == Vec2(-0.1, 0.95));
        press(session, tow);
        QVERIFY(session.world().parameters().gravity == Vec2(0.1, -0.95));
        QVERIFY(session.hud().gravityFlippedFor < 0);
        QCOMPARE(session.phase(), Phase::AwaitingInput);
    }

    void aNewAttemptFindsTheLevelAsItWasDrawn() {
        Level level = spaceWithCeiling();
        addBall(level, Vec2(5, 0), 0.3, Vec2(0.5, 0));
        const auto ballAt = [](const Session& session) {
            const std::shared_ptr<const Snapshot> picture = session.snapshot();
            for (const BodyPicture& body : picture->moving) {
                if (body.look->kind == BodyKind::Dynamic && body.look->role == BodyRole::Object) {
                    return body.pose.position;
                }
            }
            return Vec2(0, 0);
        };
        Session session(level);
        QVERIFY(holdUntil(session, thrust, Phase::Crashed));
        const Vec2 moved = ballAt(session);
        QVERIFY(moved.x() > 5.1);
        press(session, tow);
        const Vec2 again = ballAt(session);
        QVERIFY(again.x() < 5.02);
        QVERIFY(count(session, BodyRole::Debris) > 0); // the wreck is still there to be seen
    }

    void theCameraFollowsTheShipThenWhatIsLeft() {
        Session session(spaceWithCeiling());
        QVERIFY(session.camera().position() == Vec2(0, 0));
        QVERIFY(holdUntil(session, thrust, Phase::Crashed));
        press(session, tow);
        QVERIFY(session.camera().position() == Vec2(0, 0));

        Session towed = towing(openSpace());
        QVERIFY(holdUntil(towed, thrust, Phase::Won));
        hold(towed, idle, 200);
        const Vec2 gap = towed.ship()->massCenter - towed.camera().position();
        QVERIFY(gap.norm() < 2.5);
    }
};

SPACETOW_TEST(AttemptsTest)
#include "attempts_test.moc"
