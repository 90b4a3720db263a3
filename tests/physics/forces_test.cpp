#include "core/physics/query/explain.h"
#include "tests/support/contact_scenes.h"
#include "tests/support/known_values.h"
#include "tests/support/rows.h"

using namespace spacetow;
using namespace spacetow::test;

namespace {

const Vec2 nothing(0, 0);

/// A ball of the given mass in empty space.
struct Lone {
    World world;
    BodyId id;

    explicit Lone(double mass, const Vec2& gravity = nothing, int iterations = 20, double damping = 0)
        : world(withIterations(iterations, gravity)) {
        BodyDef def = ball({0, 0}, 0.5);
        def.mass = mass;
        def.linearDamping = damping;
        id = add(world, def);
    }
    BodyState state() const { return world.body(id); }
};

/// Speed after one update of 20 ms under one force of 4 N to the right.
double speedAfterOnePush(ForceSource source, bool atPoint) {
    Lone lone(2);
    if (atPoint) {
        lone.world.applyForceAt(lone.id, {4, 0}, {0, 0}, source);
    } else {
        lone.world.applyForce(lone.id, {4, 0}, source);
    }
    lone.world.update();
    return lone.state().velocity.x();
}

double speedAfterASecond(int iterations, double damping) {
    Lone lone(1, nothing, iterations, damping);
    lone.world.setVelocity(lone.id, {3, 0}, 0);
    run(lone.world, 1);
    return lone.state().velocity.x();
}

BodyState fallenFor(double seconds, const BodyDef& def, const Vec2& gravity) {
    World world(withIterations(20, gravity));
    const BodyId id = add(world, def);
    run(world, seconds);
    return world.body(id);
}

BodyDef offCenterSquare() {
    return {.shapes = {Polygon{{Vec2(0, 0), Vec2(1, 0), Vec2(1, 1), Vec2(0, 1)}}}};
}

double highestEnergyOfADefaultBall() {
    World world(withIterations(20));
    add(world, floorOf("edge"));
    add(world, ball({0, 1}, 0.2));
    const double start = totals(world).energy();
    double highest = 0;
    for (int i = 0; i < 200; ++i) {
        world.update();
        highest = std::max(highest, totals(world).energy() / start);
    }
    return highest;
}

void gravityRows() {
    const BodyState fallen = fallenFor(1, ball({0, 0}, 0.2), {0, -1.9});
    known("gravity acts once: after a second at 1.9 m/s² a body falls at 1.9 m/s", fallen.velocity.y(), -1.9);
    known("gravity acts once: in a second at 1.9 m/s² a body falls 0.95 m", fallen.pose.position.y(), -0.95);
    const BodyState turning = fallenFor(1, offCenterSquare(), {0, -9.81});
    known("a body whose mass lies beside its origin does not start to spin in free fall", turning.angularVelocity, 0,
          0);
    known("a body whose mass lies beside its origin falls as every other", turning.pose.position.y(), -4.905, 1e-9);
}

void engineRows() {
    known("an engine force of 4 N gives 2 kg a speed of 0.04 m/s in 20 ms, once",
          speedAfterOnePush(ForceSource::Engine, false), 0.04);
    known("an engine force at a point counts once too", speedAfterOnePush(ForceSource::Engine, true), 0.04);
    known("a manual force is divided by the mass once", speedAfterOnePush(ForceSource::Manual, false), 0.04);
    known("a manual force at a point counts once too", speedAfterOnePush(ForceSource::Manual, true), 0.04);
    Lone struck(2);
    struck.world.applyImpulseAt(struck.id, {3, 0}, {0, 0.5});
    known("an impulse of 3 N s changes the velocity of 2 kg by 1.5 m/s", struck.state().velocity.x(), 1.5);
    known("an impulse half a metre above the middle turns clockwise by r j / I", struck.state().angularVelocity,
          -1.5 / struck.state().inertia);
}

void dampingRows() {
    known("damping is a rate a second, at 50 iterations", speedAfterASecond(50, 0.5), 3 * std::exp(-0.5));
    known("damping is a rate a second, at 200 iterations", speedAfterASecond(200, 0.5), 3 * std::exp(-0.5));
    known("a damping of 5 a second leaves e⁻⁵", speedAfterASecond(4, 5), 3 * std::exp(-5.0));
    known("a damping that is hardly any is not lost in rounding", speedAfterASecond(4, 1e-6), 3 * std::exp(-1e-6));
    known("a damping beyond every iteration stops without overshooting", speedAfterASecond(1, 1e4), 0, 1e-12);
    known("a body made without saying more keeps its speed", speedAfterASecond(20, BodyDef{}.linearDamping), 3);
    known("a body made without saying more never gains energy in a bounce", highestEnergyOfADefaultBall(), 1, 1e-9);
    Lone sinking(2, {0, -9.81}, 20, 0.5);
    run(sinking.world, 60);
    known("a damped body falls at last with g / damping", sinking.state().velocity.y(), -9.81 / 0.5, 1e-9);
}

} // namespace

class ForcesTest : public QObject {
    Q_OBJECT

  private slots:
    void everyNumberIsWhatItsSentenceSays_data() {
        knownValueColumns();
        gravityRows();
        engineRows();
        dampingRows();
    }
    void everyNumberIsWhatItsSentenceSays() { checkKnownValue(); }

    void aBodyStaysOnItsParabola_data() {
        QTest::addColumn<Vec2>("velocity");
        QTest::addColumn<Vec2>("gravity");
        QTest::addColumn<int>("iterations");
        for (const int iterations : iterationCounts) {
            QTest::addRow("free fall, %d iterations", iterations) << Vec2(0, 0) << Vec2(0, -9.81) << iterations;
            QTest::addRow("projectile, %d iterations", iterations) << Vec2(30, 40) << Vec2(0, -9.81) << iterations;
            QTest::addRow("sideways gravity, %d iterations", iterations) << Vec2(-3, 4) << Vec2(1.5, 0.7) << iterations;
            QTest::addRow("none, %d iterations", iterations) << Vec2(1000, -2000) << Vec2(0, 0) << iterations;
        }
    }
    void aBodyStaysOnItsParabola() {
        QFETCH(Vec2, velocity);
        QFETCH(Vec2, gravity);
        QFETCH(int, iterations);
        World world(withIterations(iterations, gravity));
        BodyDef def = offCenterSquare();
        def.velocity = velocity;
        def.angularVelocity = 3;
        const BodyId id = add(world, def);
        for (int i = 1; i <= 500; ++i) {
            world.update();
            const double t = 0.02 * i;
            const Vec2 way = t * velocity + 0.5 * t * t * gravity;
            const BodyState state = world.body(id);
            QVERIFY2((state.massCenter - Vec2(0.5, 0.5) - way).norm() <= 1e-9 * std::max(way.norm(), 1.0),
                     qPrintable(QString("update %1").arg(i)));
            QVERIFY((state.velocity - velocity - t * gravity).norm() <= 1e-9 * std::max(velocity.norm(), 1.0));
            QVERIFY(std::abs(std::remainder(state.angle - 3 * t, 2 * pi)) < 1e-9);
        }
    }

    void aRopeThatIsNotPulledChangesNoParabola_data() { iterationRows(); }
    void aRopeThatIsNotPulledChangesNoParabola() {
        QFETCH(int, iterations);
        World world(withIterations(iterations));
        BodyDef def = ball({0, 0}, 0.1);
        def.velocity = {3, 4};
        const BodyId a = add(world, def);
        def.position = {1, 0.5};
        def.mass = 7;
        const BodyId b = add(world, def);
        QVERIFY(bool(world.addConnector({.a = a, .b = b, .stiffness = 500, .damping = 3})));
        run(world, 10);
        const Vec2 way = 10 * Vec2(3, 4) + 50 * Vec2(0, -9.81);
        QVERIFY((world.body(a).massCenter - way).norm() <= 1e-9 * way.norm());
        QVERIFY((world.body(b).massCenter - Vec2(1, 0.5) - way).norm() <= 1e-9 * way.norm());
    }

    void dampingTakesTheSameShareAtAnyIterationCount_data() {
        QTest::addColumn<double>("damping");
        QTest::addColumn<int>("iterations");
        for (const double damping : {1e-3, 0.5, 1.25, 5.0}) {
            for (const int iterations : iterationCounts) {
                QTest::addRow("%g a second, %d iterations", damping, iterations) << damping << iterations;
            }
        }
    }
    void dampingTakesTheSameShareAtAnyIterationCount() {
        QFETCH(double, damping);
        QFETCH(int, iterations);
        World world(withIterations(iterations, {0, 0}));
        BodyDef def = box({0, 0}, 0.3, 0.2);
        def.velocity = {3, -4};
        def.angularVelocity = 2;
        def.linearDamping = damping;
        def.angularDamping = 0.5 * damping;
        const BodyId id = add(world, def);
        for (int second = 1; second <= 10; ++second) {
            run(world, 1);
            const BodyState state = world.body(id);
            const double left = std::exp(-damping * second);
            QVERIFY((state.velocity - left * def.velocity).norm() <= 1e-9 * left * 5);
            QVERIFY((state.massCenter - (1 - left) / damping * def.velocity).norm() <= 1e-9 * 50);
            const double spinLeft = std::exp(-0.5 * damping * second);
            QVERIFY(std::abs(state.angularVelocity - 2 * spinLeft) <= 1e-9 * spinLeft);
        }
    }
};

SPACETOW_TEST(ForcesTest)
#include "forces_test.moc"
