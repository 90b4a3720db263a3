#include "tests/support/contact_scenes.h"

#include <algorithm>

using namespace spacetow;
using namespace spacetow::test;

class WallsTest : public QObject {
    Q_OBJECT

  private slots:
    void nothingFallsThroughAWedge_data() {
        QTest::addColumn<QString>("what");
        QTest::addColumn<double>("restitution");
        QTest::addColumn<QString>("walls");
        for (const char* what : {"ball", "box", "ship"}) {
            for (const double e : {0.0, 0.5, 1.0}) {
                for (const char* walls : {"edges", "lines", "polygons"}) {
                    QTest::addRow("%s, e %g, %s", what, e, walls) << what << e << walls;
                }
            }
        }
    }
    void nothingFallsThroughAWedge() {
        QFETCH(QString, what);
        QFETCH(double, restitution);
        QFETCH(QString, walls);
        for (int opening = 10; opening <= 170; opening += 20) {
            for (const double shot : {0.0, 50.0}) {
                World world(withIterations(4));
                const double half = opening * pi / 360;
                const Vec2 left(-20 * std::sin(half), 20 * std::cos(half));
                const Vec2 right(20 * std::sin(half), 20 * std::cos(half));
                BodyDef wedge{.kind = BodyKind::Static};
                if (walls == "edges") {
                    wedge.shapes = {Edge{left, {0, 0}}, Edge{{0, 0}, right}};
                } else if (walls == "lines") {
                    wedge.shapes = {Line{left, {0, 0}}, Line{{0, 0}, right}};
                } else {
                    wedge.shapes = {Polygon{{left, left + Vec2(-1, -1), Vec2(0, -1), Vec2(0, 0)}},
                                    Polygon{{Vec2(0, 0), Vec2(0, -1), right + Vec2(1, -1), right}}};
                }
                wedge.restitution = restitution;
                add(world, wedge);
                BodyDef def = dropped(what, {0.02, 6});
                def.restitution = restitution;
                def.velocity = {0, -shot};
                const BodyId id = add(world, def);
                for (int i = 0; i < 500; ++i) {
                    world.update();
                    const Vec2 at = world.body(id).massCenter;
                    const bool inside = at.y() > std::abs(at.x()) / std::tan(half) - 0.1 || at.norm() > 19;
                    QVERIFY2(inside, qPrintable(QString("opening %1°, shot %2 m/s, update %3: at (%4, %5)")
                                                    .arg(opening)
                                                    .arg(shot)
                                                    .arg(i)
                                                    .arg(at.x())
                                                    .arg(at.y())));
                    if (at.norm() > 19) {
                        break;
                    }
                }
            }
        }
    }

    void bulletsNeverPassThrough_data() {
        QTest::addColumn<QString>("target");
        for (const char* target : {"edge without depth", "line", "thin polygon", "circle"}) {
            QTest::newRow(target) << target;
        }
    }
    void bulletsNeverPassThrough() {
        QFETCH(QString, target);
        for (const double speed : {1.0, 10.0, 100.0, 1000.0}) {
            for (int k = 0; k < 40; ++k) {
                World world(withIterations(k % 2 == 0 ? 4 : 20, {0, 0}));
                BodyDef wall = edgeBody({-3, 0}, {3, 0}, 0);
                if (target == "line") {
                    wall = lineBody({-3, 0}, {3, 0});
                } else if (target == "thin polygon") {
                    wall = box({0, -0.005}, 3, 0.005);
                } else if (target == "circle") {
                    wall = ball({0, -1}, 1);
                }
                wall.kind = BodyKind::Static;
                add(world, wall);
                BodyDef bullet = ball({0, 0.3 + 0.037 * k}, 0.05);
                bullet.velocity = {0.02 * speed, -speed};
                bullet.restitution = 0.5;
                const BodyId id = add(world, bullet);
                run(world, 2 / speed + 0.04);
                QVERIFY2(
                    world.body(id).massCenter.y() > 0,
                    qPrintable(QString("%1 m/s, shot %2: y %3").arg(speed).arg(k).arg(world.body(id).massCenter.y())));
                QVERIFY(world.body(id).velocity.y() > -0.5 * speed);
            }
        }
    }

    void anEdgeIsOneWay() {
        // From behind it lets pass; from the front it stops.
        World world(withIterations(20, {0, 0}));
        add(world, edgeBody({-5, 0}, {5, 0}, 0.1));
        BodyDef rising = ball({-2, -1}, 0.2);
        rising.velocity = {0, 2};
        BodyDef falling = ball({2, 1}, 0.2);
        falling.velocity = {0, -2};
        const BodyId up = add(world, rising);
        const BodyId down = add(world, falling);
        run(world, 2);
        QVERIFY2(world.body(up).massCenter.y() > 2.5, qPrintable(QString::number(world.body(up).massCenter.y())));
        QVERIFY(world.body(down).massCenter.y() > 0.19);
    }

    void aFreeEndStopsABall_data() {
        QTest::addColumn<Vec2>("start");
        QTest::newRow("at a") << Vec2(-3, 0);
        QTest::newRow("at b") << Vec2(3, 0);
    }
    void aFreeEndStopsABall() {
        QFETCH(Vec2, start);
        World world(withIterations(20, {0, 0}));
        add(world, edgeBody({-1, 0}, {1, 0}, 0.1));
        BodyDef def = ball(start, 0.2);
        def.velocity = -start;
        def.restitution = 1;
        const BodyId id = add(world, def);
        run(world, 1);
        QVERIFY(world.body(id).velocity.x() * start.x() >= 0);
        QVERIFY(std::abs(world.body(id).massCenter.x()) > 1.19);
    }

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
