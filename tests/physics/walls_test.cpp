#include "tests/support/contact_scenes.h"
#include "tests/support/gaps.h"

#include <algorithm>

using namespace spacetow;
using namespace spacetow::test;

class WallsTest : public QObject {
    Q_OBJECT

  private slots:
    void staticBodiesMayBeMovedAndRemoved() {
        World world(withIterations(20));
        const BodyId ground = add(world, floorOf("edge"));
        const BodyId id = add(world, ball({0, 0.2}, 0.2));
        run(world, 1);
        world.setPose(ground, {0, -1}, 0);
        run(world, 2);
        QVERIFY(std::abs(world.body(id).massCenter.y() + 0.8) < 0.005);
        world.removeBody(ground);
        run(world, 1);
        QVERIFY(world.body(id).massCenter.y() < -4);
        QCOMPARE(world.bodyCount(), 1);
    }

    void aRodThatIsSetSpinningDuringAnUpdateStopsAtWhatIsInItsWay() {
        World world({.gravity = {0, 0}});
        BodyDef rod = box({0, 0}, 5, 0.05);
        rod.mass = 1;
        const BodyId id = add(world, rod);
        for (const double side : {-1.0, 1.0}) {
            BodyDef hammer = ball({4.7 * side, -0.27 * side}, 0.2);
            hammer.velocity = {0, 100 * side};
            hammer.mass = 50;
            add(world, hammer);
        }
        BodyDef peg = ball({3, 0.75}, 0.05);
        peg.kind = BodyKind::Static;
        add(world, peg);
        bool touched = false;
        for (int i = 0; i < 10 && !touched; ++i) {
            world.update();
            touched = std::any_of(world.events().began.begin(), world.events().began.end(), [&](const TouchEvent& e) {
                return e.a == id && world.body(e.b).kind == BodyKind::Static;
            });
        }
        QVERIFY(touched);
    }

    void whatTurnsRoundOnItsWayMeetsTheWallWithItsFarEnd() {
        World world({.gravity = {0, 0}, .iterations = 4});
        add(world, lineBody({-20, -20}, {20, 20}));
        const Vec2 away = Vec2(-1, 1).normalized();
        const BodyId id = add(world, {.shapes = {shipHull()},
                                      .position = 2 * away,
                                      .velocity = -0.390625 * away,
                                      .angularVelocity = 6.71117}); // five turns and a half
        for (int i = 0; i < 300; ++i) {
            world.update();
            const double gap = lowestAlong(world.shapes(id).front(), world.body(id).pose, {0, 0}, away);
            QVERIFY2(gap > -0.005, qPrintable(QString("update %1: %2").arg(i).arg(gap)));
        }
    }

    void aBounceDoesNotDependOnWhatHappensFarAway() {
        double heights[2];
        for (const bool disturbed : {false, true}) {
            World world({.gravity = {0, 0}, .iterations = 1, .substeps = 1});
            BodyDef wall = lineBody({-3, 0}, {3, 0});
            wall.restitution = 1;
            add(world, wall);
            BodyDef bouncing = ball({0, 0.25}, 0.2);
            bouncing.velocity = {0, -50};
            bouncing.restitution = 1;
            const BodyId id = add(world, bouncing);
            if (disturbed) {
                add(world, ball({20, 0}, 0.2));
                BodyDef other = ball({19.58, 0}, 0.2);
                other.velocity = {50, 0};
                other.mass = 50;
                add(world, other);
            }
            for (int i = 0; i < 3; ++i) {
                world.update();
            }
            heights[disturbed ? 1 : 0] = world.body(id).massCenter.y();
        }
        QVERIFY2(heights[0] > 0.5, qPrintable(QString::number(heights[0])));
        QCOMPARE(heights[1], heights[0]);
    }
};

SPACETOW_TEST(WallsTest)
#include "walls_test.moc"
