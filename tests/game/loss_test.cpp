// What a session knows of why an attempt was lost.

#include "tests/support/game_levels.h"
#include "tests/support/test_main.h"

using namespace spacetow;
using namespace spacetow::test;

class LossTest : public QObject {
    Q_OBJECT

  private slots:
    void aShipThatHitsAWallKnowsWhichOne() {
        const Level level = spaceWithCeiling();
        Session session(level);
        QVERIFY(!session.loss());
        QVERIFY(holdUntil(session, thrust, Phase::Crashed));
        QVERIFY(session.loss().has_value());
        QVERIFY(session.loss()->ship && !session.loss()->payload);
        QCOMPARE(session.loss()->who, BodyRole::Ship);
        QCOMPARE(session.loss()->what, level.objects[3].key);
        QCOMPARE(session.loss()->tags, TagMask::bit(wallTag).bits);
        QVERIFY(session.snapshot()->loss == session.loss());
        hold(session, idle, 1);
        session.step(tow);
        QCOMPARE(session.phase(), Phase::AwaitingInput);
        QVERIFY(!session.loss() && !session.snapshot()->loss);
    }
    void aPayloadThatHitsAWallWhileTowedIsToBlame() {
        Level level = openSpace();
        level.gravity = Vec2(0, -1);
        addWall(level, Vec2(-5, -2.5), Vec2(5, -2.5));
        Session session = towing(level);
        QVERIFY(holdUntil(session, idle, Phase::Crashed));
        QVERIFY(session.loss()->payload && !session.loss()->ship);
        QCOMPARE(session.loss()->who, BodyRole::Payload);
        QCOMPARE(session.loss()->what, level.objects[3].key);
    }
    void aShipThatRunsIntoItsPayloadKnowsThat() {
        Level level = openSpaceWithPayloadAt(Vec2(0, 3));
        Session session(level);
        QVERIFY(holdUntil(session, thrust, Phase::Crashed));
        QVERIFY(session.loss()->ship);
        QCOMPARE(session.loss()->what, payloadKey);
        QCOMPARE(session.loss()->whom, BodyRole::Payload);
    }
};

SPACETOW_TEST(LossTest)
#include "loss_test.moc"
