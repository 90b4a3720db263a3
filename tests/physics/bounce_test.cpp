#include "tests/support/contact_scenes.h"

using namespace spacetow;
using namespace spacetow::test;

class BounceTest : public QObject {
    Q_OBJECT

  private slots:
    void aBallBouncesToItsShareOfTheHeight_data() {
        QTest::addColumn<QString>("floor");
        QTest::addColumn<double>("restitution");
        QTest::addColumn<int>("iterations");
        for (const char* floor : floors) {
            for (const double e : {0.0, 0.25, 0.5, 0.75, 1.0}) {
                for (const int iterations : iterationCounts) {
                    QTest::addRow("%s, e %g, %d iterations", floor, e, iterations) << floor << e << iterations;
                }
            }
        }
    }
    void aBallBouncesToItsShareOfTheHeight() {
        QFETCH(QString, floor);
        QFETCH(double, restitution);
        QFETCH(int, iterations);
        World world(withIterations(iterations));
        BodyDef ground = floorOf(floor);
        ground.restitution = restitution;
        add(world, ground);
        BodyDef def = ball({0, 1.2}, 0.2);
        def.restitution = restitution;
        const BodyId id = add(world, def);
        double before = 0;
        double peak = 0;
        bool rising = false;
        bool bounced = false;
        for (int i = 0; i < 200; ++i) {
            world.update();
            const double speed = world.body(id).velocity.y();
            rising = speed > 0;
            bounced |= rising && before <= 0;
            if (bounced && !rising) {
                break;
            }
            // The peak lies between two updates; v²/2g from here is exact in free flight.
            peak = rising ? world.body(id).pose.position.y() - 0.2 + speed * speed / (2 * 9.81) : peak;
            before = speed;
        }
        const double expected = restitution * restitution;
        QVERIFY2(std::abs(peak - expected) <= 0.01 * expected + 1e-3, qPrintable(QString::number(peak)));
    }

    void anElasticBallKeepsItsEnergyForAMinute_data() {
        QTest::addColumn<int>("iterations");
        for (const int iterations : iterationCounts) {
            QTest::addRow("%d iterations", iterations) << iterations;
        }
    }
    void anElasticBallKeepsItsEnergyForAMinute() {
        QFETCH(int, iterations);
        World world(withIterations(iterations));
        BodyDef ground = floorOf("edge");
        ground.restitution = 1;
        add(world, ground);
        BodyDef def = ball({0, 1.2}, 0.2);
        def.restitution = 1;
        const BodyId id = add(world, def);
        const auto energy = [&] {
            return 0.5 * world.body(id).velocity.squaredNorm() + 9.81 * (world.body(id).pose.position.y() - 0.2);
        };
        const double start = energy();
        for (int i = 0; i < 3000; ++i) {
            world.update();
            QVERIFY2(std::abs(energy() / start - 1) < 0.01, qPrintable(QString::number(energy() / start)));
        }
    }

    void circlesCollideElasticallyFromEveryAngle_data() {
        QTest::addColumn<double>("speed");
        QTest::addColumn<double>("offset");
        for (const double speed : {0.1, 1.0, 10.0, 100.0}) {
            for (const double offset : {0.0, 0.3, 0.6, 0.9}) {
                QTest::addRow("%g m/s, offset %g", speed, offset) << speed << offset;
            }
        }
    }
    void circlesCollideElasticallyFromEveryAngle() {
        QFETCH(double, speed);
        QFETCH(double, offset);
        for (int degrees = 0; degrees < 360; degrees += 5) {
            World world(withIterations(4, {0, 0}));
            const Rot turn = Rot::fromAngle(degrees * pi / 180);
            BodyDef a = ball(turn * Vec2(-1.5, offset * 0.5), 0.2);
            a.velocity = turn * Vec2(speed, 0);
            a.restitution = 1;
            a.friction = 0;
            BodyDef b = ball({0, 0}, 0.3);
            b.restitution = 1;
            b.friction = 0;
            const BodyId idA = add(world, a);
            const BodyId idB = add(world, b);
            const double massA = world.body(idA).mass;
            const double massB = world.body(idB).mass;
            run(world, 3 / speed < 0.02 ? 0.06 : 3 / speed);
            const BodyState sa = world.body(idA);
            const BodyState sb = world.body(idB);
            const QString where = QString("%1°").arg(degrees);
            QVERIFY2(sb.velocity.norm() > 0.01 * speed, qPrintable(where + " missed"));
            const Vec2 momentum = massA * sa.velocity + massB * sb.velocity;
            QVERIFY2((momentum - massA * a.velocity).norm() < 1e-9 * massA * speed, qPrintable(where));
            const double energy = massA * sa.velocity.squaredNorm() + massB * sb.velocity.squaredNorm();
            QVERIFY2(std::abs(energy / (massA * speed * speed) - 1) < 1e-6,
                     qPrintable(where + QString(" %1").arg(energy / (massA * speed * speed))));
            const double angular =
                massA * cross(sa.massCenter, sa.velocity) + massB * cross(sb.massCenter, sb.velocity);
            const double expected = massA * cross(a.position, a.velocity);
            QVERIFY2(std::abs(angular - expected) < 1e-9 * massA * speed,
                     qPrintable(where + QString(" %1").arg(angular - expected)));
        }
    }

    void aKinematicCircleSendsAStillBallOffAtTwiceItsSpeed() {
        for (const double mass : {0.5, 5.0, 500.0}) {
            World world(withIterations(20, {0, 0}));
            BodyDef hammer = ball({-1, 0}, 0.2);
            hammer.kind = BodyKind::Kinematic;
            hammer.mass = mass;
            hammer.velocity = {1, 0};
            hammer.restitution = 1;
            add(world, hammer);
            BodyDef def = ball({0, 0}, 0.2);
            def.restitution = 1;
            const BodyId id = add(world, def);
            run(world, 1);
            QVERIFY(std::abs(world.body(id).velocity.x() - 2) < 1e-9);
        }
    }

    void aFrozenBodyIsAWallToWhatHitsIt() {
        World world(withIterations(20, {0, 0}));
        BodyDef still = ball({0, 0}, 0.2);
        still.positionFrozen = still.rotationFrozen = true;
        still.restitution = 1;
        const BodyId frozen = add(world, still);
        BodyDef def = ball({-1, 0}, 0.2);
        def.velocity = {2, 0};
        def.restitution = 1;
        const BodyId id = add(world, def);
        run(world, 1);
        QVERIFY(std::abs(world.body(id).velocity.x() + 2) < 1e-9);
        QCOMPARE(world.body(frozen).massCenter.x(), 0.0);
        world.setFrozen(frozen, false);
        world.setVelocity(frozen, {0, 1}, 0);
        run(world, 0.1);
        QVERIFY(world.body(frozen).velocity.y() == 0); // the velocity was set while it was still frozen
        world.setVelocity(frozen, {0, 1}, 0);
        run(world, 0.1);
        QVERIFY(world.body(frozen).massCenter.y() > 0.09);
    }
};

SPACETOW_TEST(BounceTest)
#include "bounce_test.moc"
