// Levels that are being drawn: whatever is missing or wrong in them, they can be played.

#include "core/game/session.h"
#include "tests/support/game_levels.h"
#include "tests/support/test_main.h"

#include <limits>

using namespace spacetow;
using namespace spacetow::test;

class UnfinishedTest : public QObject {
    Q_OBJECT

  private slots:
    void withoutAShipThereIsPhysicsAlone() {
        Level level;
        addBall(level, Vec2(0, 0), 0.5, Vec2(1, 0));
        Session session(level);
        QCOMPARE(session.phase(), Phase::Sandbox);
        hold(session, {.left = true, .thrust = true, .tow = true}, 50);
        QCOMPARE(session.phase(), Phase::Sandbox);
        QCOMPARE(session.fuel(), 0.0);
        const Vec2 at = session.snapshot()->moving.at(0).pose.position;
        QVERIFY(std::abs(at.x() - 1) < 1e-6);
        QVERIFY(std::abs(at.y() + 0.5 * 0.95) < 1e-6);
    }

    void unfinishedLevelsCanBePlayed_data() {
        QTest::addColumn<int>("missing");
        QTest::addRow("no payload") << 1;
        QTest::addRow("no finish") << 2;
        QTest::addRow("no payload and no finish") << 3;
        QTest::addRow("nothing at all") << 4;
        QTest::addRow("no life") << 5;
        QTest::addRow("a finish without length") << 6;
        QTest::addRow("a payload without radius") << 7;
        QTest::addRow("a ship nowhere") << 8;
        QTest::addRow("numbers out of range") << 9;
        QTest::addRow("numbers that are none") << 10;
    }
    void unfinishedLevelsCanBePlayed() {
        QFETCH(int, missing);
        Level level = missing == 4 ? Level{} : openSpace();
        if (missing == 2 || missing == 3) {
            level.objects.erase(2);
        }
        if (missing == 1 || missing == 3) {
            level.objects.erase(1);
        }
        if (missing == 5) {
            level.rules.lives = -4;
        }
        if (missing == 6) {
            level.objects.replace(2, {finishKey, "", FinishObject{Vec2(1, 1), Vec2(1, 1)}, {}});
        }
        if (missing == 7) {
            level.objects.replace(1, {payloadKey, "", PayloadObject{Vec2(0, -1), 0}, {}});
        }
        if (missing == 8) {
            const double nowhere = std::numeric_limits<double>::quiet_NaN();
            level.objects.replace(0, {shipKey, "", ShipObject{Vec2(nowhere, 0)}, {}});
        }
        const double none = std::numeric_limits<double>::quiet_NaN();
        if (missing == 9) {
            level.iterations = -3;
            level.substeps = 0;
            level.updateSeconds = 0;
            level.rules.towRange = -1;
        }
        if (missing == 10) {
            level.gravity = Vec2(none, 0);
            level.updateSeconds = none;
            level.rules.towRange = none;
            level.objects.replace(1, {payloadKey, "", PayloadObject{Vec2(0, none), none, none}, {}});
            level.objects.replace(2, {finishKey, "", FinishObject{Vec2(none, 0), Vec2(0, 0)}, {}});
        }
        Session session(level);
        press(session, thrust);
        press(session, tow);
        hold(session, thrust, 100);
        QCOMPARE(session.phase() == Phase::Sandbox, missing == 4 || missing == 8);
        QVERIFY(session.snapshot() != nullptr);
        QVERIFY(session.lives() >= 1 || session.phase() == Phase::Sandbox);
    }
};

SPACETOW_TEST(UnfinishedTest)
#include "unfinished_test.moc"
