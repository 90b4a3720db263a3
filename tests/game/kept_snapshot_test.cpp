#include "core/game/session.h"
#include "tests/support/game_levels.h"
#include "tests/support/test_main.h"

using namespace spacetow;
using namespace spacetow::test;

namespace {

struct Reading {
    Transform pose;
    Vec2 velocity;
    double angularVelocity;
    std::vector<Shape> shapes;
};

std::vector<Reading> readingsOf(const Snapshot& snapshot) {
    std::vector<Reading> readings;
    for (const BodyPicture& body : allBodies(snapshot)) {
        readings.push_back({body.pose, body.velocity, body.angularVelocity, body.look->shapes});
    }
    return readings;
}

bool isSame(const Reading& a, const Reading& b) {
    return a.pose.position == b.pose.position && a.pose.rotation == b.pose.rotation && a.velocity == b.velocity &&
           a.angularVelocity == b.angularVelocity && a.shapes == b.shapes;
}

} // namespace

class KeptSnapshotTest : public QObject {
    Q_OBJECT

  private slots:
    void aSnapshotStaysAsItWasWhileTheGameGoesOn_data() {
        QTest::addColumn<int>("updates");
        QTest::newRow("one update later no velocity in it has changed") << 1;
        QTest::newRow("a hundred updates later neither has anything else") << 100;
    }
    void aSnapshotStaysAsItWasWhileTheGameGoesOn() {
        QFETCH(int, updates);
        Session session = towing(openSpace());
        const auto kept = session.snapshot();
        const std::vector<Reading> before = readingsOf(*kept);
        const Vec2 ropeEnd = kept->connectors.front().a;
        for (int i = 0; i < updates; ++i) {
            session.step({.left = true, .thrust = true});
        }
        const std::vector<Reading> after = readingsOf(*kept);
        const std::vector<Reading> live = readingsOf(*session.snapshot());
        bool moved = false;
        for (std::size_t i = 0; i < before.size(); ++i) {
            QVERIFY(isSame(before[i], after[i]));
            moved |= !isSame(before[i], live[i]);
        }
        QVERIFY(moved);
        QCOMPARE(kept->connectors.front().a, ropeEnd);
    }
};

SPACETOW_TEST(KeptSnapshotTest)
#include "kept_snapshot_test.moc"
