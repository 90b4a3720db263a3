#include "tests/support/contact_scenes.h"
#include "tests/support/rows.h"

using namespace spacetow;
using namespace spacetow::test;

namespace {

constexpr double weight = 9.81; // N, of 1 kg

/// 1 kg on a connector of 1 m.
struct Hanging {
    World world;
    BodyId load;
    ConnectorId connector;

    Hanging(int iterations, int substeps, double stiffness, double damping)
        : world({.iterations = iterations, .substeps = substeps}) {
        BodyDef hook = ball({0, 0}, 0.05);
        hook.kind = BodyKind::Static;
        const BodyId top = add(world, hook);
        BodyDef def = ball({0, -1 - weight / stiffness}, 0.2);
        def.mass = 1;
        load = add(world, def);
        connector =
            world.addConnector({.a = top, .b = load, .length = 1, .stiffness = stiffness, .damping = damping}).value();
    }
    /// m
    double stretch() const { return -1 - world.body(load).massCenter.y(); }
};

} // namespace

class HangingTest : public QObject {
    Q_OBJECT

  private slots:
    void whatHangsAtRestReadsItsWeightAndSleeps_data() {
        QTest::addColumn<double>("stiffness");
        QTest::addColumn<double>("damping");
        QTest::addColumn<int>("iterations");
        QTest::addColumn<int>("substeps");
        for (const double stiffness : {200.0, 5e4, 1e6, 1e9}) {
            for (const double damping : {0.0, 50.0, 2000.0}) {
                for (const int iterations : {1, 2, 4, 5, 20, 100}) {
                    for (const int substeps : {1, 2, 3}) {
                        QTest::addRow("k %g, c %g, %d iterations of %d", stiffness, damping, iterations, substeps)
                            << stiffness << damping << iterations << substeps;
                    }
                }
            }
        }
    }
    void whatHangsAtRestReadsItsWeightAndSleeps() {
        QFETCH(double, stiffness);
        QFETCH(double, damping);
        QFETCH(int, iterations);
        QFETCH(int, substeps);
        Hanging scene(iterations, substeps, stiffness, damping);
        scene.world.setSleeping(true);
        for (int i = 0; i < 40; ++i) {
            scene.world.update();
            QVERIFY(scene.world.body(scene.load).velocity.norm() < 1e-9);
            QVERIFY(std::abs(scene.world.connector(scene.connector).tension - weight) < 1e-6 * weight);
            QVERIFY(std::abs(scene.stretch() - weight / stiffness) < 1e-12);
        }
        QVERIFY(scene.world.body(scene.load).asleep);
    }

    /// From elsewhere, damping brings it to the same place, and no longer to one that depends on the iterations.
    void whatSwingsOutComesToRestAtItsWeight_data() { iterationRows(); }
    void whatSwingsOutComesToRestAtItsWeight() {
        QFETCH(int, iterations);
        for (const double stiffness : {200.0, 5e4}) {
            Hanging scene(iterations, 2, stiffness, 20);
            scene.world.setPose(scene.load, {0, -1 - 3 * weight / stiffness}, 0);
            run(scene.world, 8);
            QVERIFY2(std::abs(scene.stretch() - weight / stiffness) < 1e-6 * weight / stiffness,
                     qPrintable(QString::number(scene.stretch())));
            QVERIFY(std::abs(scene.world.connector(scene.connector).tension - weight) < 1e-5 * weight);
        }
    }

    void aFallBeforeTheRopeIsTautIsExact_data() { iterationRows(); }
    void aFallBeforeTheRopeIsTautIsExact() {
        QFETCH(int, iterations);
        World world(withIterations(iterations));
        BodyDef hook = ball({0, 0}, 0.05);
        hook.kind = BodyKind::Static;
        const BodyId top = add(world, hook);
        const BodyId load = add(world, ball({0.5, 0}, 0.1));
        const ConnectorDef rope{.a = top, .b = load, .length = 50, .stiffness = 100, .slack = true};
        QVERIFY(static_cast<bool>(world.addConnector(rope)));
        world.setVelocity(load, {1, 2}, 0);
        run(world, 1);
        const Vec2 expected(0.5 + 1, 2 - 0.5 * weight);
        QVERIFY2((world.body(load).massCenter - expected).norm() < 1e-9,
                 qPrintable(QString::number((world.body(load).massCenter - expected).norm())));
    }
};

SPACETOW_TEST(HangingTest)
#include "hanging_test.moc"
