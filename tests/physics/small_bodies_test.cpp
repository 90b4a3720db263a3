#include "core/physics/query/explain.h"
#include "tests/support/contact_scenes.h"
#include "tests/support/random_shapes.h"
#include "tests/support/rows.h"

using namespace spacetow;
using namespace spacetow::test;

class SmallBodiesTest : public QObject {
    Q_OBJECT

  private slots:
    /// Boxes, flat ones and others of a few centimetres come down turning, on two-way line and thin plate: they turn a
    /// good deal in an iteration when one corner has hit, and the other is to bounce as well.
    void aSmallBodyThatTurnsStaysAboveTheFloor_data() {
        QTest::addColumn<bool>("line");
        QTest::addColumn<double>("restitution");
        QTest::addColumn<int>("iterations");
        for (const bool line : {true, false}) {
            for (const double restitution : {0.0, 0.005, 0.02, 0.5, 1.0}) {
                for (const int iterations : {1, 2, 4, 20}) {
                    QTest::addRow("%s, e %g, %d iterations", line ? "line" : "plate", restitution, iterations)
                        << line << restitution << iterations;
                }
            }
        }
    }
    void aSmallBodyThatTurnsStaysAboveTheFloor() {
        QFETCH(bool, line);
        QFETCH(double, restitution);
        QFETCH(int, iterations);
        for (std::uint64_t seed = 1; seed <= fullOrQuick(20000U, usualOrThin(60U, 20U)); ++seed) {
            Random random(seed);
            World world(withIterations(iterations));
            BodyDef floor = line ? lineBody({-50, 0}, {50, 0}) : box({0, -0.001}, 50, 0.001);
            floor.kind = BodyKind::Static;
            floor.restitution = restitution;
            add(world, floor);
            const double size = random.uniform(0.01, 0.05);
            const std::uint32_t kind = random.below(3);
            BodyDef def = box({0, 0}, kind == 0 ? 0.02 : size, kind == 0 ? 0.01 : 0.1 * size);
            if (kind == 2) {
                def.shapes = {smallConvex(random, size)};
            }
            def.restitution = restitution;
            def.angle = random.uniform(-pi, pi);
            def.velocity = {random.uniform(-2, 2), random.uniform(-5, 0)};
            def.angularVelocity = random.uniform(-20, 20);
            def.position = {0, 1};
            World measured = world;
            def.position.y() -= lowestPoint(measured, add(measured, def)) - random.uniform(0, 0.02);
            const BodyId id = add(world, def);
            const double energy = totals(world).energy();
            for (int i = 0; i < 25; ++i) {
                world.update();
                QVERIFY2(world.body(id).massCenter.y() > 0, seedText(seed));
                QVERIFY2(restitution == 1 || totals(world).energy() <= energy + 1e-6 * std::abs(energy),
                         seedText(seed));
            }
        }
    }

    /// The first that was seen to fall through.
    void aFlatBoxThatLandsOnOneCornerDoesNotTurnThroughALine() {
        for (const int iterations : {1, 2, 4, 8, 20, 100}) {
            World world(withIterations(iterations));
            add(world, lineBody({-50, 0}, {50, 0}));
            BodyDef def = box({0, 0.021008}, 0.02, 0.01);
            def.velocity = {-0.826, -3.947};
            def.angle = 0.1239;
            def.angularVelocity = -16.45;
            def.restitution = 0.02;
            const BodyId id = add(world, def);
            for (int i = 0; i < 50; ++i) {
                world.update();
                QVERIFY2(world.body(id).massCenter.y() > 0, qPrintable(QString("update %1").arg(i)));
            }
            QVERIFY(std::abs(world.body(id).massCenter.y() - 0.01) < 0.001);
        }
    }
};

SPACETOW_TEST(SmallBodiesTest)
#include "small_bodies_test.moc"
