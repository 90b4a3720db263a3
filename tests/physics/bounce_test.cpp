#include "tests/support/contact_scenes.h"

using namespace spacetow;
using namespace spacetow::test;

namespace {

const char* const bouncy[] = {"edge", "thin edge", "line", "polygon", "circle"};

} // namespace

class BounceTest : public QObject {
    Q_OBJECT

  private slots:
    void aBallBouncesToItsShareOfTheHeight_data() {
        QTest::addColumn<QString>("floor");
        QTest::addColumn<double>("restitution");
        QTest::addColumn<int>("iterations");
        for (const char* floor : bouncy) {
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
        QVERIFY(world.body(id).pose.position.y() > 0.2 - 1e-3);
        const double expected = restitution * restitution;
        QVERIFY2(std::abs(peak - expected) <= 0.01 * expected + 1e-3, qPrintable(QString::number(peak)));
    }

    void anElasticBallKeepsItsEnergyForAMinute_data() {
        QTest::addColumn<QString>("floor");
        QTest::addColumn<int>("iterations");
        for (const char* floor : bouncy) {
            for (const int iterations : iterationCounts) {
                QTest::addRow("%s, %d iterations", floor, iterations) << floor << iterations;
            }
        }
    }
    void anElasticBallKeepsItsEnergyForAMinute() {
        QFETCH(QString, floor);
        QFETCH(int, iterations);
        World world(withIterations(iterations));
        BodyDef ground = floorOf(floor);
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
            QVERIFY(world.body(id).pose.position.y() > 0.2 - 1e-3);
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
