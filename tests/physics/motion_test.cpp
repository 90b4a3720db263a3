#include "core/physics/query/explain.h"
#include "core/physics/world/world.h"
#include "tests/support/bodies.h"
#include "tests/support/scenes.h"
#include "tests/support/test_main.h"

#include <cmath>
#include <numbers>

using namespace spacetow;
using namespace spacetow::test;

namespace {

UpdateParameters parametersFor(int iterations, const Vec2& gravity = {0, 0}) {
    return {.gravity = gravity, .iterations = iterations};
}

void runFor(World& world, double seconds) {
    const int updates = static_cast<int>(std::lround(seconds / world.parameters().seconds));
    for (int i = 0; i < updates; ++i) {
        world.update();
    }
}

double relativeError(double value, double expected) {
    return std::abs(value - expected) / std::abs(expected);
}

void allIterationRows() {
    QTest::addColumn<int>("iterations");
    for (const int iterations : {4, 20, 100}) {
        QTest::addRow("%d iterations", iterations) << iterations;
    }
}

/// The connector between a static body at the origin and a ball of 1 kg at `at`.
struct Spring {
    World world;
    BodyId weight;

    Spring(const UpdateParameters& parameters, const Vec2& at, ConnectorDef connector) : world(parameters) {
        BodyDef anchor = ball({0, 0}, 0.01);
        anchor.kind = BodyKind::Static;
        anchor.filter = {};
        connector.a = add(world, anchor);
        BodyDef load = ball(at, 0.05);
        load.mass = 1;
        weight = add(world, load);
        connector.b = weight;
        QVERIFY(bool(world.addConnector(connector)));
    }
};

} // namespace

class MotionTest : public QObject {
    Q_OBJECT

  private slots:
    void aFreeBodyFollowsTheParabola_data() { allIterationRows(); }
    void aFreeBodyFollowsTheParabola() {
        QFETCH(int, iterations);
        World world(parametersFor(iterations, {0.3, -9.81}));
        BodyDef def = ball({1, 2}, 0.1);
        def.velocity = {3, 40};
        const BodyId id = add(world, def);
        runFor(world, 10);
        const Vec2 expected = def.position + 10 * def.velocity + 50 * Vec2(0.3, -9.81);
        QVERIFY((world.body(id).pose.position - expected).norm() <= 1e-9 * expected.norm());
    }

    void aConstantForceAndTorqueActExactlyOnce_data() { allIterationRows(); }
    void aConstantForceAndTorqueActExactlyOnce() {
        QFETCH(int, iterations);
        World world(parametersFor(iterations));
        BodyDef def = ball({0, 0}, 0.5);
        def.mass = 2;
        const BodyId id = add(world, def);
        for (int i = 0; i < 50; ++i) {
            world.applyForce(id, {4, 0});
            world.applyTorque(id, 0.5);
            world.update();
        }
        const BodyState state = world.body(id);
        QVERIFY(relativeError(state.pose.position.x(), 1) < 1e-9);
        QVERIFY(relativeError(state.velocity.x(), 2) < 1e-9);
        QVERIFY(relativeError(state.angularVelocity, 0.5 / state.inertia) < 1e-9);
        world.update();
        QVERIFY(relativeError(world.body(id).velocity.x(), 2) < 1e-9);
    }

    void aKinematicBodyObeysManualForcesAndNothingElse_data() { allIterationRows(); }
    void aKinematicBodyObeysManualForcesAndNothingElse() {
        QFETCH(int, iterations);
        World world(parametersFor(iterations, {0, -1}));
        BodyDef def = ball({0, 0}, 0.5);
        def.kind = BodyKind::Kinematic;
        def.mass = 2;
        const BodyId id = add(world, def);
        for (int i = 0; i < 50; ++i) {
            world.applyForce(id, {0, 4});
            world.applyForce(id, {7, 0}, ForceSource::Engine);
            world.update();
        }
        QVERIFY(std::abs(world.body(id).velocity.y() - 2) < 1e-12);
        QCOMPARE(world.body(id).velocity.x(), 0.0);
    }

    void dampingIsExponentialAtAnyIterationCount_data() { allIterationRows(); }
    void dampingIsExponentialAtAnyIterationCount() {
        QFETCH(int, iterations);
        World world(parametersFor(iterations));
        BodyDef def = ball({0, 0}, 0.5);
        def.velocity = {3, 0};
        def.angularVelocity = 2;
        def.linearDamping = 0.5;
        def.angularDamping = 1.25;
        const BodyId id = add(world, def);
        runFor(world, 10);
        QVERIFY(relativeError(world.body(id).velocity.x(), 3 * std::exp(-5.0)) < 1e-9);
        QVERIFY(relativeError(world.body(id).angularVelocity, 2 * std::exp(-12.5)) < 1e-9);
        QVERIFY(relativeError(world.body(id).pose.position.x(), 6 * (1 - std::exp(-5.0))) < 1e-9);
    }

    void aBodyWhoseMassIsOffItsOriginFallsWithoutSpinning() {
        World world(parametersFor(4, {0, -9.81}));
        BodyDef def;
        def.shapes = {Polygon{{Vec2(0, 0), Vec2(1, 0), Vec2(1, 1), Vec2(0, 1)}}};
        const BodyId id = add(world, def);
        runFor(world, 1);
        QCOMPARE(world.body(id).angularVelocity, 0.0);
        QVERIFY(std::abs(world.body(id).pose.position.y() + 4.905) < 1e-9);
    }

    void anInactiveBodyNeitherMovesNorFeelsForces() {
        World world(parametersFor(20, {0, -9.81}));
        BodyDef def = ball({1, 1}, 0.5);
        def.active = false;
        const BodyId id = add(world, def);
        world.applyForce(id, {10, 0});
        runFor(world, 1);
        QCOMPARE(world.body(id).pose.position.x(), 1.0);
        QCOMPARE(world.body(id).pose.position.y(), 1.0);
        world.setActive(id, true);
        runFor(world, 1);
        QVERIFY(std::abs(world.body(id).pose.position.y() - (1 - 4.905)) < 1e-9);
    }

    void aSpringSwingsWithItsPeriodAndKeepsItsEnergy_data() { allIterationRows(); }
    void aSpringSwingsWithItsPeriodAndKeepsItsEnergy() {
        QFETCH(int, iterations);
        const double stiffness = 400; // ω = 20 rad/s
        Spring spring(parametersFor(iterations), {1.1, 0}, {.length = 1, .stiffness = stiffness});
        const double start = totals(spring.world).energy();
        int periods = 0;
        double before = 0.1;
        double time = 0;
        double lastCrossing = 0;
        double highest = start;
        double lowest = start;
        while (periods < 1000) {
            spring.world.update();
            time += 0.02;
            const double x = spring.world.body(spring.weight).pose.position.x() - 1;
            if (before < 0 && x >= 0) {
                lastCrossing = time - 0.02 * x / (x - before);
                ++periods;
            }
            before = x;
            highest = std::max(highest, totals(spring.world).energy());
            lowest = std::min(lowest, totals(spring.world).energy());
        }
        const double period = 2 * std::numbers::pi / std::sqrt(stiffness);
        QVERIFY2(relativeError(lastCrossing, 999.75 * period) < 1e-3, qPrintable(QString::number(lastCrossing)));
        QVERIFY2(highest < 1.01 * start && lowest > 0.99 * start,
                 qPrintable(QString("%1 %2 %3").arg(lowest).arg(start).arg(highest)));
    }

    void aDampedSpringDecaysAsItsFormulaSays_data() { allIterationRows(); }
    void aDampedSpringDecaysAsItsFormulaSays() {
        QFETCH(int, iterations);
        const double stiffness = 100;
        const double damping = 0.5; // N s/m; the amplitude falls by e^(−t c/2m)
        Spring spring(parametersFor(iterations), {1.2, 0}, {.length = 1, .stiffness = stiffness, .damping = damping});
        runFor(spring.world, 4);
        const BodyState state = spring.world.body(spring.weight);
        const double rate = 0.5 * damping;
        const double frequency = std::sqrt(stiffness - rate * rate);
        const double x = state.pose.position.x() - 1;
        const double y = (state.velocity.x() + rate * x) / frequency; // x and y are cosine and sine of the same swing
        QVERIFY2(relativeError(std::hypot(x, y), 0.2 * std::hypot(1, rate / frequency) * std::exp(-4 * rate)) < 0.01,
                 qPrintable(QString::number(std::hypot(x, y))));
    }

    void aStiffSpringStaysFiniteAndGainsNoEnergy_data() {
        QTest::addColumn<int>("iterations");
        QTest::addColumn<int>("substeps");
        QTest::newRow("sub-steps of 0.1 ms") << 100 << 2;
        QTest::newRow("sub-steps of 5 ms") << 4 << 1;
    }
    void aStiffSpringStaysFiniteAndGainsNoEnergy() {
        QFETCH(int, iterations);
        QFETCH(int, substeps);
        UpdateParameters parameters = parametersFor(iterations);
        parameters.substeps = substeps;
        Spring spring(parameters, {1.001, 0}, {.length = 1, .stiffness = 1e9});
        double energy = totals(spring.world).energy();
        const double start = energy;
        for (int i = 0; i < 500; ++i) {
            spring.world.update();
            energy = totals(spring.world).energy();
            QVERIFY(std::isfinite(energy) && energy <= start * (1 + 1e-9));
        }
    }

    void aPendulumOnTheTowRopeKeepsItsPeriodAndLength_data() { allIterationRows(); }
    void aPendulumOnTheTowRopeKeepsItsPeriodAndLength() {
        QFETCH(int, iterations);
        const double length = 1.5;
        const double start = 0.05; // rad
        ConnectorDef rope{.length = {},
                          .stiffness = 50000,
                          .damping = 100,
                          .truncation = {TruncationRule::PartialTanh, 150, 0.75, {}}};
        Spring pendulum(parametersFor(iterations, {0, -0.95}), {length * std::sin(start), -length * std::cos(start)},
                        rope);
        double before = start;
        double lastCrossing = 0;
        double stretch = 0;
        int periods = 0;
        for (int i = 1; periods < 10; ++i) {
            pendulum.world.update();
            const Vec2 at = pendulum.world.body(pendulum.weight).pose.position;
            stretch = std::max(stretch, std::abs(at.norm() / length - 1));
            if (before < 0 && at.x() >= 0) {
                lastCrossing = 0.02 * (i - at.x() / (at.x() - before));
                ++periods;
            }
            before = at.x();
            QVERIFY(i < 10000);
        }
        const double period = 2 * std::numbers::pi * std::sqrt(length / 0.95) * (1 + start * start / 16);
        QVERIFY2(relativeError(lastCrossing, 9.75 * period) < 5e-3, qPrintable(QString::number(lastCrossing)));
        QVERIFY2(stretch < 1e-3, qPrintable(QString::number(stretch)));
    }

    void connectedBodiesKeepMomentumAndAngularMomentum() {
        World world(parametersFor(20));
        BodyDef a = box({0, 0}, 0.3, 0.1);
        a.velocity = {-1, 0.2};
        BodyDef b = box({1, 0.2}, 0.1, 0.2);
        b.mass = 0.25;
        b.angularVelocity = 3;
        const BodyId idA = add(world, a);
        const BodyId idB = add(world, b);
        QVERIFY(bool(world.addConnector(
            {.a = idA, .b = idB, .anchorA = {0.3, 0.1}, .anchorB = {-0.1, 0.1}, .stiffness = 500, .damping = 3})));
        const auto momenta = [&] {
            Vec2 momentum(0, 0);
            double angular = 0;
            for (const BodyId id : {idA, idB}) {
                const BodyState s = world.body(id);
                momentum += s.mass * s.velocity;
                angular += s.mass * cross(s.massCenter, s.velocity) + s.inertia * s.angularVelocity;
            }
            return std::pair(momentum, angular);
        };
        const auto [momentum, angular] = momenta();
        runFor(world, 10);
        const auto [momentumAfter, angularAfter] = momenta();
        QVERIFY((momentumAfter - momentum).norm() < 1e-9);
        QVERIFY2(std::abs(angularAfter - angular) < 1e-9, qPrintable(QString::number(angularAfter - angular)));
    }

    void aSlackConnectorPullsAndNeverPushes() {
        Spring spring(parametersFor(20), {0.5, 0}, {.length = 1, .stiffness = 100, .slack = true});
        runFor(spring.world, 1);
        QCOMPARE(spring.world.body(spring.weight).pose.position.x(), 0.5);
        Spring stretched(parametersFor(20), {1.5, 0}, {.length = 1, .stiffness = 100, .slack = true});
        stretched.world.update();
        QVERIFY(stretched.world.body(stretched.weight).velocity.x() < 0);
    }

    void coincidentAnchorsGiveFiniteForces() {
        Spring spring(parametersFor(20), {0, 0}, {.length = 0, .stiffness = 1000, .damping = 10});
        runFor(spring.world, 1);
        QVERIFY(isFinite(spring.world.body(spring.weight).pose.position));
    }

    void removingABodyRemovesItsConnectorsAndIsReported() {
        World world(parametersFor(4, {0, -1}));
        BodyDef def = ball({0, 0}, 0.1);
        def.user = 42;
        const BodyId a = add(world, def);
        const BodyId b = add(world, ball({1, 0}, 0.1));
        const ConnectorId connector = world.addConnector({.a = a, .b = b}).value();
        world.removeBody(a);
        world.update();
        QVERIFY(!world.contains(a) && world.contains(b) && !world.contains(connector));
        QCOMPARE(world.events().removed.size(), std::size_t{1});
        QCOMPARE(world.events().removed.front().body, a);
        QCOMPARE(world.events().removed.front().user, std::uint64_t{42});
        const BodyId next = add(world, ball({5, 5}, 0.1));
        QVERIFY(next != a);
        QVERIFY(!world.contains(a));
    }

    void aWorldRefusesWhatIsNotFinite() {
        World world;
        BodyDef def = ball({0, 0}, 0.1);
        def.velocity.x() = std::numeric_limits<double>::quiet_NaN();
        QCOMPARE(world.addBody(def).error().code.text(), std::string("not-finite"));
        def = ball({0, 0}, 0.1);
        def.mass = 0;
        QCOMPARE(world.addBody(def).error().code.text(), std::string("bad-mass"));
        def.mass = {};
        def.shapes = {Edge{{1, 1}, {1, 1}, 0}};
        QCOMPARE(world.addBody(def).error().code.text(), std::string("bad-shape"));
        const BodyId id = add(world, ball({0, 0}, 0.1));
        QVERIFY(!world.applyForce(id, {std::numeric_limits<double>::infinity(), 0}));
        world.update();
        QVERIFY(isFinite(world.body(id).velocity));
    }

    void whatOverflowsIsSwitchedOffAloneAndReported() {
        World world(parametersFor(4));
        const BodyId good = add(world, ball({0, 0}, 0.1));
        BodyDef def = ball({100, 0}, 0.1);
        def.mass = 1e-300;
        const BodyId bad = add(world, def);
        world.applyForce(bad, {1e300, 0});
        world.update();
        QCOMPARE(world.events().faults.size(), std::size_t{1});
        QCOMPARE(world.events().faults.front().body, bad);
        QVERIFY(!world.body(bad).active);
        QCOMPARE(world.body(good).pose.position.x(), 0.0);
    }

    void aCopiedWorldHasTheSameFuture() {
        World world = worldOf(*makeScene("pyramid", 8));
        for (int i = 0; i < 50; ++i) {
            world.update();
        }
        World copy = world;
        QCOMPARE(copy.hash(), world.hash());
        for (int i = 0; i < 50; ++i) {
            world.update();
            copy.update();
        }
        QCOMPARE(copy.hash(), world.hash());
        world.update();
        QVERIFY(copy.hash() != world.hash());
    }
};

SPACETOW_TEST(MotionTest)
#include "motion_test.moc"
