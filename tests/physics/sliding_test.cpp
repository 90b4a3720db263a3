#include "tests/support/contact_scenes.h"

using namespace spacetow;
using namespace spacetow::test;

class SlidingTest : public QObject {
    Q_OBJECT

  private slots:
    void aBallOnASlopeRolls_data() {
        QTest::addColumn<int>("iterations");
        for (const int iterations : iterationCounts) {
            QTest::addRow("%d iterations", iterations) << iterations;
        }
    }
    void aBallOnASlopeRolls() {
        QFETCH(int, iterations);
        const double slope = 20 * pi / 180;
        World world(withIterations(iterations));
        const Rot turn = Rot::fromAngle(-slope);
        BodyDef ground = edgeBody(turn * Vec2(-5, 0), turn * Vec2(100, 0));
        ground.friction = 1;
        add(world, ground);
        BodyDef def = ball(turn * Vec2(0, 0.2), 0.2);
        def.friction = 1;
        const BodyId id = add(world, def);
        run(world, 2);
        const BodyState state = world.body(id);
        const double speed = state.velocity.norm();
        QVERIFY(std::abs(speed / (2 * 9.81 * std::sin(slope) / 1.5) - 1) < 0.01);
        QVERIFY(std::abs(-state.angularVelocity * 0.2 / speed - 1) < 0.01);
    }

    void aBoxOnASlopeHoldsOrSlidesAsFrictionSays_data() {
        QTest::addColumn<double>("friction");
        QTest::addColumn<int>("iterations");
        for (const double friction : {0.0, 0.1, 0.3, 0.5}) {
            for (const int iterations : iterationCounts) {
                QTest::addRow("friction %g, %d iterations", friction, iterations) << friction << iterations;
            }
        }
    }
    void aBoxOnASlopeHoldsOrSlidesAsFrictionSays() {
        QFETCH(double, friction);
        QFETCH(int, iterations);
        const double slope = 20 * pi / 180; // tan = 0.364
        World world(withIterations(iterations));
        const Rot turn = Rot::fromAngle(-slope);
        BodyDef ground = edgeBody(turn * Vec2(-5, 0), turn * Vec2(100, 0));
        ground.friction = friction;
        add(world, ground);
        BodyDef def = box(turn * Vec2(0, 0.2), 0.4, 0.2);
        def.angle = -slope;
        def.friction = friction;
        const BodyId id = add(world, def);
        run(world, 2);
        const double speed = world.body(id).velocity.norm();
        const double expected = 2 * 9.81 * std::max(std::sin(slope) - friction * std::cos(slope), 0.0);
        QVERIFY2(std::abs(speed - expected) <= 0.02 * expected + 0.01,
                 qPrintable(QString("%1, expected %2").arg(speed).arg(expected)));
    }

    void aBallRollsOverJointsAsOverOneWall_data() {
        QTest::addColumn<QString>("walls");
        for (const char* walls : {"edges", "lines", "boxes"}) {
            QTest::newRow(walls) << walls;
        }
    }
    void aBallRollsOverJointsAsOverOneWall() {
        QFETCH(QString, walls);
        for (const bool round : {true, false}) {
            double speeds[2];
            for (const int pieces : {1, 1000}) {
                World world(withIterations(4));
                for (int i = 0; i < pieces; ++i) {
                    const Vec2 a(-5 + 100.0 * i / pieces, 0);
                    const Vec2 b(-5 + 100.0 * (i + 1) / pieces, 0);
                    BodyDef piece = walls == "edges" ? edgeBody(a, b) : lineBody(a, b);
                    if (walls == "boxes") {
                        piece.shapes = {Polygon{{a, a - Vec2(0, 1), b - Vec2(0, 1), b}}};
                    }
                    piece.friction = 0;
                    add(world, piece);
                }
                BodyDef def = round ? ball({0, 0.2}, 0.2) : box({0, 0.2}, 0.2, 0.2);
                def.velocity = {5, 0};
                const BodyId id = add(world, def);
                double hop = 0;
                for (int i = 0; i < 500; ++i) {
                    world.update();
                    hop = std::max(hop, std::abs(world.body(id).velocity.y()));
                }
                QVERIFY2(hop < 1e-3, qPrintable(QString("%1 pieces: hop %2").arg(pieces).arg(hop)));
                speeds[pieces == 1 ? 0 : 1] = world.body(id).velocity.x();
            }
            QVERIFY2(std::abs(speeds[1] / speeds[0] - 1) < 1e-3, qPrintable(QString::number(speeds[1] / speeds[0])));
        }
    }

    void aRisingPlatformCarriesABall() {
        World world(withIterations(20));
        BodyDef platform = floorOf("edge");
        platform.kind = BodyKind::Kinematic;
        platform.velocity = {0, 0.5};
        const BodyId base = add(world, platform);
        const BodyId id = add(world, ball({0, 0.2}, 0.2));
        run(world, 2);
        QVERIFY(std::abs(world.body(base).pose.position.y() - 1) < 1e-9);
        QVERIFY(std::abs(world.body(id).massCenter.y() - 1.2) < 0.005);
    }
};

SPACETOW_TEST(SlidingTest)
#include "sliding_test.moc"
