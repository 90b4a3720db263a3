#include "core/game/session.h"
#include "core/game/ship.h"
#include "core/physics/state/world_data.h"
#include "tests/support/game_levels.h"
#include "tests/support/test_main.h"

using namespace spacetow;
using namespace spacetow::test;

namespace {

/// A wall beside the payload's way up, too far from the ship's to be touched by it.
Level spaceWithLedgeForPayload() {
    Level level = openSpaceWithPayloadAt(Vec2(0.9, -0.9));
    addWall(level, Vec2(2, -0.5), Vec2(0.75, -0.5));
    return level;
}

} // namespace

class SessionTest : public QObject {
    Q_OBJECT

  private slots:
    void theShipIsFrozenUntilADirectionIsPressed_data() {
        QTest::addColumn<Controls>("controls");
        QTest::addColumn<bool>("starts");
        QTest::addRow("left") << left << true;
        QTest::addRow("right") << right << true;
        QTest::addRow("thrust") << thrust << true;
        QTest::addRow("tow") << tow << false;
    }
    void theShipIsFrozenUntilADirectionIsPressed() {
        QFETCH(Controls, controls);
        QFETCH(bool, starts);
        Level level = openSpace();
        level.gravity = Vec2(0, -0.95);
        Session session(level);
        hold(session, idle, 50);
        QCOMPARE(session.phase(), Phase::AwaitingInput);
        QVERIFY(session.ship()->pose.position == Vec2(0, 0));
        QCOMPARE(session.time(), 0.0);
        session.step(controls);
        QCOMPARE(session.phase() == Phase::Flying, starts);
        QCOMPARE(heard(session, Sound::Start), starts);
        hold(session, controls, 10);
        QCOMPARE(session.ship()->pose.position != Vec2(0, 0), starts);
        QVERIFY(session.payload()->pose.position == Vec2(0, -1)); // it waits, whatever gravity says
    }

    void steeringTurnsAndThrustPushesAlongTheNose() {
        Session session(openSpace());
        hold(session, left, 5);
        QVERIFY(session.ship()->angle > 0);
        Session other(openSpace());
        hold(other, right, 5);
        QCOMPARE(other.ship()->angle, -session.ship()->angle);
        Session both(openSpace());
        hold(both, {.left = true, .right = true}, 5);
        QCOMPARE(both.ship()->angle, 0.0);
        Session up(openSpace());
        hold(up, thrust, 10);
        // v' = thrust / mass − damping · v, from rest.
        const Rules rules;
        const double d = rules.shipLinearDamping;
        const double expected = rules.thrust / rules.shipMass / d * (1 - std::exp(-d * 0.2));
        QVERIFY(std::abs(up.ship()->velocity.y() - expected) < 1e-6);
        QCOMPARE(up.ship()->velocity.x(), 0.0);
    }

    void theShipFliesByTheRulesOfItsLevel() {
        Level level = openSpace();
        level.rules.thrust = 6;
        level.rules.shipMass = 2;
        level.rules.shipLinearDamping = 0;
        level.rules.steering = 1.5;
        level.rules.shipAngularDamping = 0;
        Session up(level);
        hold(up, thrust, 10);
        QVERIFY(std::abs(up.ship()->velocity.y() - 6.0 / 2 * 0.2) < 1e-9);
        QCOMPARE(up.ship()->mass, 2.0);
        Session around(level);
        hold(around, left, 10);
        QVERIFY(std::abs(around.ship()->angularVelocity - 1.5 * 0.2) < 1e-9);
    }

    void payloadAndRopeAreAsTheLevelHasThem() {
        Level level = openSpace();
        level.rules.rope = {20, 0, TruncationRule::Clamp, 1, 0.5};
        Session session = towing(level);
        const BodyDef payload = payloadBody(PayloadObject{Vec2(0, -1), 0.2, 0.25, 0.125, 0.75});
        QCOMPARE(payload.restitution, 0.125);
        QCOMPARE(payload.linearDamping, 0.75);
        Rules bouncy;
        bouncy.shipRestitution = 0.75;
        QCOMPARE(shipBody(Vec2(0, 0), 0, bouncy).restitution, 0.75);
        const double length = session.snapshot()->connectors.front().length;
        double stretch = 0, tension = 0;
        for (int i = 0; i < 50; ++i) { // long before the finish
            session.step(thrust);
            const ConnectorPicture rope = session.snapshot()->connectors.front();
            stretch = std::max(stretch, (rope.a - rope.b).norm() - length);
            tension = std::max(tension, rope.tension);
        }
        QVERIFY2(stretch > 0.02,
                 qPrintable(QString::number(stretch))); // the game's own gives by a tenth of a millimetre
        QVERIFY2(tension > 0.3 && tension <= 1 + 1e-9, qPrintable(QString::number(tension)));
    }

    void theLevelSaysWhetherBodiesSleep() {
        for (const bool sleeping : {true, false}) {
            Level level;
            level.sleeping = sleeping;
            addWall(level, Vec2(-3, 0), Vec2(3, 0));
            addBall(level, Vec2(0, 0.3), 0.3, Vec2(0, 0));
            Session session(level);
            hold(session, idle, 100);
            QCOMPARE(session.world().data().sleep.allowed, sleeping);
            QCOMPARE(session.world().body(session.world().bodies().back()).asleep, sleeping);
        }
    }

    void theRopeIsAttachedWithinItsRangeOnly_data() {
        QTest::addColumn<double>("distance");
        QTest::addColumn<bool>("attaches");
        QTest::addRow("well inside") << 1.0 << true;
        QTest::addRow("just inside") << 1.4999 << true;
        QTest::addRow("at the limit") << 1.5 << false;
        QTest::addRow("just outside") << 1.5001 << false;
    }
    void theRopeIsAttachedWithinItsRangeOnly() {
        QFETCH(double, distance);
        QFETCH(bool, attaches);
        Session session(openSpaceWithPayloadAt(Vec2(distance, 0)));
        QVERIFY(!session.hud().towInRange); // not before the start
        session.step({.left = true, .right = true});
        QCOMPARE(session.hud().towInRange, attaches);
        session.step(tow);
        QCOMPARE(session.phase(), attaches ? Phase::Towing : Phase::Flying);
        QCOMPARE(session.world().connectors().size(), attaches ? std::size_t(1) : std::size_t(0));
        QCOMPARE(heard(session, Sound::TowAttached), attaches);
        if (attaches) {
            const Vec2 anchor = shipNotch();
            const double length = session.world().connector(session.world().connectors()[0]).length;
            QVERIFY(std::abs(length - (Vec2(distance, 0) - anchor).norm()) < 1e-9);
        }
    }

    void theTowKeyHasToBePressedAfresh() {
        Session session(openSpace());
        session.step({.right = true, .tow = true});
        hold(session, tow, 20);
        QCOMPARE(session.phase(), Phase::Flying);
        press(session, tow);
        QCOMPARE(session.phase(), Phase::Towing);
    }

    void theTowedPayloadFollowsTheShip() {
        Session session = towing(openSpace());
        hold(session, thrust, 40);
        QVERIFY(session.ship()->pose.position.y() > 0.3);
        const Vec2 gap = session.ship()->pose.toWorld(shipNotch()) - session.payload()->pose.position;
        QVERIFY(std::abs(gap.norm() - (1 + shipNotch().y())) < 0.01);
        QVERIFY(!session.payload()->positionFrozen);
    }

    void theRopedPayloadMayTouchItsShip() {
        Session session = towing(openSpaceWithPayloadAt(Vec2(0, -0.6)));
        bool met = false;
        for (int i = 0; i < 400 && !met; ++i) { // turn over and fly into the ball on the short rope
            session.step({.left = i < 60, .thrust = i % 2 == 0});
            const Vec2 gap = session.ship()->massCenter - session.payload()->massCenter;
            met = gap.norm() < 0.25;
        }
        QCOMPARE(session.phase(), Phase::Towing);
    }

    void thePayloadWinsByBeingTowedThroughTheFinish_data() {
        QTest::addColumn<bool>("upwards");
        QTest::addRow("upwards") << true;
        QTest::addRow("downwards") << false;
    }
    void thePayloadWinsByBeingTowedThroughTheFinish() {
        QFETCH(bool, upwards);
        Level level = openSpace();
        if (!upwards) {
            level.objects.replace(0, {shipKey, "", ShipObject{Vec2(0, 3), 3.14159265358979}, {}});
            level.objects.replace(1, {payloadKey, "", PayloadObject{Vec2(0, 4)}, {}});
        }
        Session session = towing(level);
        int wins = 0;
        for (int i = 0; i < 600; ++i) {
            session.step(thrust);
            wins += heard(session, Sound::Won) ? 1 : 0;
        }
        QCOMPARE(session.phase(), Phase::Won);
        QCOMPARE(wins, 1);
        QCOMPARE(session.payloadState(), PayloadState::Delivered);
        QCOMPARE(session.lives(), 3);
        QVERIFY(session.world().connectors().empty());
    }

    void onlyATowedPayloadNoticesTheFinish() {
        Session session(openSpace());
        hold(session, thrust, 200); // the ship alone goes through
        QVERIFY(session.ship()->pose.position.y() > 2.5);
        QCOMPARE(session.phase(), Phase::Flying);

        Session waiting(openSpaceWithPayloadAt(Vec2(1, 2))); // the payload waits on the line
        hold(waiting, left, 20);
        QCOMPARE(waiting.phase(), Phase::Flying);
    }

    void afterTheWinShipAndPayloadStayAndControlsDoNothing() {
        Session session = towing(openSpace());
        QVERIFY(holdUntil(session, thrust, Phase::Won));
        const double fuel = session.fuel();
        const double time = session.time();
        const Vec2 payload = session.payload()->pose.position;
        const Vec2 ship = session.ship()->pose.position;
        hold(session, thrust, 10);
        QCOMPARE(session.fuel(), fuel);
        QCOMPARE(session.time(), time);
        press(session, tow);
        press(session, left);
        QCOMPARE(session.phase(), Phase::Won);
        QVERIFY(session.payload()->pose.position == payload);
        QVERIFY(session.ship()->pose.position == ship);
    }

    void afterTheWinNothingIsLost_data() {
        QTest::addColumn<Vec2>("gravity");
        QTest::newRow("a wall ahead") << Vec2(0, 0);
        QTest::newRow("a long fall") << Vec2(0, -0.1);
    }
    void afterTheWinNothingIsLost() {
        QFETCH(Vec2, gravity);
        Level level = openSpace();
        level.gravity = gravity;
        addWall(level, Vec2(10, 4.2), Vec2(-10, 4.2));
        if (gravity.isZero()) {
            addBall(level, Vec2(0, 3.5), 0.2, Vec2(0, -0.1)); // comes down on the ship
        }
        Session session = towing(level);
        QVERIFY(holdUntil(session, thrust, Phase::Won));
        hold(session, idle, 600);
        QCOMPARE(session.phase(), Phase::Won);
        QCOMPARE(session.lives(), 3);
        QVERIFY(session.ship().has_value());
        QVERIFY(session.payload().has_value());
        QCOMPARE(session.payloadState(), PayloadState::Delivered);
    }

    void theTowKeyLetsGoAndTakesInTowAgain() {
        Session session = towing(openSpace());
        const auto payload = [&] { return *session.payload(); };
        hold(session, thrust, 30);
        const Vec2 speed = payload().velocity;
        QVERIFY(speed.y() > 0.05);
        press(session, tow);
        QCOMPARE(session.phase(), Phase::Flying);
        QVERIFY(heard(session, Sound::TowBroken));
        QCOMPARE(session.payloadState(), PayloadState::Dropped);
        QVERIFY(session.world().connectors().empty());
        hold(session, idle, 5);
        QVERIFY(payload().velocity.y() > 0.5 * speed.y()); // it flies on
        QVERIFY(session.hud().towInRange);
        press(session, tow);
        QCOMPARE(session.phase(), Phase::Towing);
        QVERIFY(payload().velocity.y() > 0.4 * speed.y());
    }

    void gravityTurnsOverOnceHoweverOftenThePayloadIsTowed() {
        Level level = openSpace();
        level.gravity = Vec2(0, -0.1);
        level.rules.flipGravityOnTow = true;
        Session session = towing(level);
        press(session, tow);
        press(session, tow);
        QCOMPARE(session.phase(), Phase::Towing);
        QVERIFY(session.world().parameters().gravity == Vec2(0, 0.1));
    }

    void aWallEndsTheShipAndCostsOneLife() {
        Session session(spaceWithCeiling());
        QVERIFY(holdUntil(session, thrust, Phase::Crashed));
        QCOMPARE(session.lives(), 2);
        QVERIFY(!session.ship().has_value());
        QCOMPARE(count(session, BodyRole::Ship), std::size_t(0));
        const std::size_t pieces = count(session, BodyRole::Debris);
        QVERIFY(pieces >= 2 && pieces <= 6);
        QVERIFY(heard(session, Sound::ShipLost));
        QVERIFY(session.payload().has_value());
        QVERIFY(session.payload()->positionFrozen); // nobody touched it
        hold(session, thrust, 300);
        QCOMPARE(session.lives(), 2);
        QCOMPARE(session.phase(), Phase::Crashed);
        QCOMPARE(count(session, BodyRole::Debris), std::size_t(0)); // gone after five seconds
    }

    void touchingTheWaitingPayloadEndsTheShipAndFreesThePayload() {
        Session session(openSpaceWithPayloadAt(Vec2(0, 1)));
        QVERIFY(holdUntil(session, thrust, Phase::Crashed));
        QCOMPARE(session.payloadState(), PayloadState::Dropped);
        QCOMPARE(session.lives(), 2);
        hold(session, idle, 2);
        QVERIFY(!session.payload()->positionFrozen);
    }

    void aTowedPayloadThatHitsAWallCostsOneLifeAndOnePressTriesAgain() {
        Session session = towing(spaceWithLedgeForPayload());
        QVERIFY(holdUntil(session, thrust, Phase::Crashed));
        QCOMPARE(session.payloadState(), PayloadState::Lost);
        QVERIFY(!session.payload().has_value());
        QVERIFY(session.ship().has_value()); // falls without control
        QVERIFY(heard(session, Sound::PayloadLost));
        QVERIFY(heard(session, Sound::TowBroken));
        const std::size_t pieces = count(session, BodyRole::Debris);
        QVERIFY(pieces >= 3 && pieces <= 7);
        const double angle = session.ship()->angularVelocity;
        hold(session, thrust, 5);
        QVERIFY(std::abs(session.ship()->angularVelocity) <= std::abs(angle) + 1e-12);
        QCOMPARE(session.lives(), 2);
        press(session, left);
        QCOMPARE(session.phase(), Phase::AwaitingInput);
        QVERIFY(session.ship()->pose.position == Vec2(0, 0));
        QVERIFY(session.payload()->pose.position == Vec2(0.9, -0.9));
        QCOMPARE(count(session, BodyRole::Ship), std::size_t(1));
        QCOMPARE(count(session, BodyRole::Payload), std::size_t(1));
        hold(session, left, 3);
        QCOMPARE(session.phase(), Phase::AwaitingInput); // a held direction is no fresh one
        press(session, left);
        QCOMPARE(session.phase(), Phase::Flying);
    }

    void anAttemptCostsOneLifeEvenWhenShipAndPayloadAreBothLost() {
        Level level = spaceWithLedgeForPayload();
        addWall(level, Vec2(10, 3), Vec2(-10, 3));
        addWall(level, Vec2(4, -10), Vec2(4, 10));
        addWall(level, Vec2(-4, 10), Vec2(-4, -10));
        addWall(level, Vec2(-10, -4), Vec2(10, -4));
        Session session = towing(level);
        QVERIFY(holdUntil(session, thrust, Phase::Crashed));
        for (int i = 0; i < 1500 && session.ship(); ++i) {
            session.step(idle);
        }
        QVERIFY(!session.ship() && !session.payload());
        QCOMPARE(session.lives(), 2);
        press(session, tow);
        QCOMPARE(session.phase(), Phase::AwaitingInput);
    }

    void aDroppedPayloadThatFallsOntoTheFloorIsLostWithoutCostingAnotherLife() {
        Level level = openSpace();
        level.gravity = Vec2(0, -0.95);
        addWall(level, Vec2(10, 0.9), Vec2(-10, 0.9));
        addWall(level, Vec2(-10, -2), Vec2(10, -2));
        Session session = towing(level);
        QVERIFY(holdUntil(session, thrust, Phase::Crashed));
        QCOMPARE(session.payloadState(), PayloadState::Dropped);
        hold(session, idle, 400);
        QCOMPARE(session.payloadState(), PayloadState::Lost);
        QCOMPARE(session.lives(), 2);
    }
};

SPACETOW_TEST(SessionTest)
#include "session_test.moc"
