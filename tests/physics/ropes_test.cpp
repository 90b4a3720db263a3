#include "core/physics/query/explain.h"
#include "tests/support/contact_scenes.h"
#include "tests/support/rows.h"

#include "core/base/random.h"

using namespace spacetow;
using namespace spacetow::test;

namespace {

struct RopeMomenta {
    Vec2 linear{0, 0};
    double angular = 0;
    double size = 0; // of the terms that make up both
};

RopeMomenta ropeMomentaOf(const World& world) {
    RopeMomenta sum;
    for (const BodyId id : world.bodies()) {
        const BodyState s = world.body(id);
        if (s.kind != BodyKind::Dynamic) {
            continue;
        }
        sum.linear += s.mass * s.velocity;
        sum.angular += s.mass * cross(s.massCenter, s.velocity) + s.inertia * s.angularVelocity;
        sum.size += s.mass * s.velocity.norm() * (1 + s.massCenter.norm()) + s.inertia * std::abs(s.angularVelocity);
    }
    return sum;
}

ConnectorDef ropeNamed(const QString& name) {
    ConnectorDef rope{.anchorA = {0.3, 0.1}, .anchorB = {-0.1, 0.2}, .stiffness = 500, .damping = 3};
    if (name == "at the centres") {
        rope.anchorA = rope.anchorB = {0, 0};
    } else if (name == "slack") {
        rope.slack = true;
        rope.length = 0.8;
    } else if (name == "of length zero") {
        rope.length = 0;
    } else if (name == "of length zero, at the centres") {
        rope.length = 0;
        rope.anchorA = rope.anchorB = {0, 0};
    } else if (name == "without damping") {
        rope.damping = 0;
    } else if (name == "clamped") {
        rope.truncation = {TruncationRule::Clamp, 20, 0.5, {}};
    } else if (name == "partial tanh") {
        rope.truncation = {TruncationRule::PartialTanh, 30, 0.75, {}};
    } else if (name == "a function of one's own") {
        rope.truncation = {TruncationRule::Custom, 0, 0, [](double x) { return x / (1 + std::abs(x) / 50); }};
    } else if (name == "tow rope") {
        rope.stiffness = 50000;
        rope.damping = 100;
        rope.truncation = {TruncationRule::PartialTanh, 150, 0.75, {}};
    } else if (name == "very stiff") {
        rope.stiffness = 1e9;
    }
    return rope;
}

const char* const ropes[] = {
    "off the centres", "at the centres", "slack",        "of length zero",          "of length zero, at the centres",
    "without damping", "clamped",        "partial tanh", "a function of one's own", "tow rope",
    "very stiff"};

/// Two spinning bodies of unlike mass, a metre or so apart, on a connector; nothing else.
World pairOn(ConnectorDef rope, Random& random, int iterations) {
    World world(withIterations(iterations, {0, 0}));
    BodyDef a = box({0, 0}, 0.3, 0.1);
    a.mass = random.uniform(0.5, 2);
    BodyDef b = dropped(random.below(2) == 0 ? "hexagon" : "ship", {1, 0.2});
    b.mass = random.uniform(0.1, 1);
    for (BodyDef* def : {&a, &b}) {
        def->angle = random.uniform(-3, 3);
        def->velocity = {random.uniform(-2, 2), random.uniform(-2, 2)};
        def->angularVelocity = random.uniform(-5, 5);
    }
    rope.a = add(world, a);
    rope.b = add(world, b);
    static_cast<void>(world.addConnector(rope).value());
    return world;
}

void ropeRows() {
    QTest::addColumn<QString>("rope");
    QTest::addColumn<int>("iterations");
    for (const char* rope : ropes) {
        for (const int iterations : iterationCounts) {
            QTest::addRow("%s, %d iterations", rope, iterations) << rope << iterations;
        }
    }
}

std::uint64_t seedCount() {
    return isFullRun() ? 100 : 5;
}

} // namespace

class RopesTest : public QObject {
    Q_OBJECT

  private slots:
    void twoFreeBodiesKeepTheirMomenta_data() { ropeRows(); }
    void twoFreeBodiesKeepTheirMomenta() {
        QFETCH(QString, rope);
        QFETCH(int, iterations);
        for (std::uint64_t seed = 1; seed <= seedCount(); ++seed) {
            Random random(seed);
            World world = pairOn(ropeNamed(rope), random, iterations);
            const RopeMomenta start = ropeMomentaOf(world);
            bool pulled = false;
            for (int i = 0; i < 500; ++i) {
                world.update();
                pulled |= world.connector(world.connectors().front()).tension != 0;
                const RopeMomenta now = ropeMomentaOf(world);
                const double linear = (now.linear - start.linear).norm() / start.size;
                const double angular = std::abs(now.angular - start.angular) / start.size;
                QVERIFY2(linear <= 1e-9 && angular <= 1e-9,
                         qPrintable(QString("seed %1, update %2: %3 %4").arg(seed).arg(i).arg(linear).arg(angular)));
            }
            QVERIFY2(pulled, seedText(seed));
        }
    }

    /// Springs that swing many times within a sub-step are another matter: see the tests of stiff ones.
    void aDampedRopeTakesEnergyAndGivesNone_data() {
        QTest::addColumn<QString>("rope");
        QTest::addColumn<int>("iterations");
        for (const char* rope : ropes) {
            for (const int iterations : iterationCounts) {
                const double substep = 0.02 / iterations / 2;
                if (ropeNamed(rope).stiffness * substep * substep < 0.25) { // per kilogram
                    QTest::addRow("%s, %d iterations", rope, iterations) << rope << iterations;
                }
            }
        }
    }
    void aDampedRopeTakesEnergyAndGivesNone() {
        QFETCH(QString, rope);
        QFETCH(int, iterations);
        ConnectorDef def = ropeNamed(rope);
        def.damping = std::max(def.damping, 10.0);
        def.truncation = {};
        double lost = 0;
        for (std::uint64_t seed = 1; seed <= seedCount(); ++seed) {
            Random random(seed);
            World world = pairOn(def, random, iterations);
            const double start = totals(world).energy();
            for (int i = 0; i < 500; ++i) {
                world.update();
                QVERIFY2(totals(world).energy() <= start * (1 + 1e-9),
                         qPrintable(QString("seed %1, update %2: %3 of %4")
                                        .arg(seed)
                                        .arg(i)
                                        .arg(totals(world).energy())
                                        .arg(start)));
            }
            lost = std::max(lost, 1 - totals(world).energy() / start);
        }
        QVERIFY2(lost > 0.1, qPrintable(QString::number(lost)));
    }

    void aStiffSpringStaysFiniteAndGainsNoEnergyHoweverItIsPulled_data() {
        QTest::addColumn<int>("iterations");
        QTest::addColumn<int>("substeps");
        QTest::addColumn<Vec2>("velocity");
        QTest::addColumn<double>("stretch");
        QTest::addColumn<double>("damping");
        const std::pair<const char*, std::pair<int, int>> steps[] = {{"0.1 ms", {100, 2}}, {"5 ms", {4, 1}}};
        for (const auto& [name, counts] : steps) {
            const auto [iterations, substeps] = counts;
            QTest::addRow("sub-steps of %s, stretched", name) << iterations << substeps << Vec2(0, 0) << 1e-3 << 0.0;
            QTest::addRow("sub-steps of %s, pressed", name) << iterations << substeps << Vec2(0, 0) << -1e-3 << 0.0;
            QTest::addRow("sub-steps of %s, shot along it", name) << iterations << substeps << Vec2(1, 0) << 0.0 << 0.0;
            QTest::addRow("sub-steps of %s, damped", name) << iterations << substeps << Vec2(1, 1) << 1e-3 << 100.0;
            QTest::addRow("sub-steps of %s, overdamped", name) << iterations << substeps << Vec2(1, 1) << 1e-3 << 1e6;
        }
    }
    void aStiffSpringStaysFiniteAndGainsNoEnergyHoweverItIsPulled() {
        QFETCH(int, iterations);
        QFETCH(int, substeps);
        QFETCH(Vec2, velocity);
        QFETCH(double, stretch);
        QFETCH(double, damping);
        World world({.gravity = {0, 0}, .iterations = iterations, .substeps = substeps});
        BodyDef post = ball({0, 0}, 0.01);
        post.kind = BodyKind::Static;
        BodyDef load = ball({1 + stretch, 0}, 0.05);
        load.mass = 1;
        load.velocity = velocity;
        const BodyId a = add(world, post);
        const BodyId b = add(world, load);
        static_cast<void>(
            world.addConnector({.a = a, .b = b, .length = 1, .stiffness = 1e9, .damping = damping}).value());
        const double start = totals(world).energy();
        for (int i = 0; i < 500; ++i) {
            world.update();
            QVERIFY2(totals(world).energy() <= start * (1 + 1e-9),
                     qPrintable(QString("update %1: %2 of %3").arg(i).arg(totals(world).energy()).arg(start)));
            QVERIFY(isFinite(world.body(b).massCenter));
        }
    }

    void aWeightSwungRoundOnAStiffSpringGetsNoFasterAndNoFarther_data() {
        QTest::addColumn<int>("iterations");
        QTest::addColumn<int>("substeps");
        QTest::addColumn<double>("speed");
        for (const double speed : {1.0, 10.0}) {
            QTest::addRow("sub-steps of 0.1 ms, %g m/s", speed) << 100 << 2 << speed;
            QTest::addRow("sub-steps of 5 ms, %g m/s", speed) << 4 << 1 << speed;
        }
    }
    void aWeightSwungRoundOnAStiffSpringGetsNoFasterAndNoFarther() {
        QFETCH(int, iterations);
        QFETCH(int, substeps);
        QFETCH(double, speed);
        World world({.gravity = {0, 0}, .iterations = iterations, .substeps = substeps});
        BodyDef post = ball({0, 0}, 0.01);
        post.kind = BodyKind::Static;
        BodyDef load = ball({1, 0}, 0.05);
        load.mass = 1;
        load.velocity = {0, speed};
        const BodyId a = add(world, post);
        const BodyId b = add(world, load);
        static_cast<void>(world.addConnector({.a = a, .b = b, .length = 1, .stiffness = 1e9}).value());
        const double step = speed * 0.02 / iterations / substeps; // m
        double stretch = 0;
        for (int i = 0; i < 500; ++i) {
            world.update();
            const double now = std::abs(world.body(b).massCenter.norm() - 1);
            QVERIFY2(world.body(b).velocity.norm() <= speed * (1 + 1e-9), qPrintable(QString("update %1").arg(i)));
            QVERIFY2(now <= step * step, qPrintable(QString("update %1: stretched by %2 m").arg(i).arg(now)));
            stretch = i < 100 ? std::max(stretch, now) : stretch;
            QVERIFY2(now <= stretch * (1 + 1e-6), qPrintable(QString("update %1: stretched by %2 m").arg(i).arg(now)));
        }
    }

    void aDampedSpringFollowsItsFormula_data() {
        QTest::addColumn<double>("ratio"); // of the damping to the critical one
        QTest::addColumn<int>("iterations");
        for (const double ratio : {0.01, 0.1, 0.5, 1.0, 2.0}) {
            for (const int iterations : iterationCounts) {
                QTest::addRow("%g of the critical damping, %d iterations", ratio, iterations) << ratio << iterations;
            }
        }
    }
    /// Two free bodies on a spring of 100 N/m: their distance obeys the equation of a single one of the reduced mass.
    void aDampedSpringFollowsItsFormula() {
        QFETCH(double, ratio);
        QFETCH(int, iterations);
        const double reduced = 0.2; // kg, of 1 and 0.25
        const double omega = std::sqrt(100 / reduced);
        World world(withIterations(iterations, {0, 0}));
        BodyDef def = ball({0, 0}, 0.1);
        def.mass = 1;
        const BodyId a = add(world, def);
        def = ball({1.2, 0}, 0.1);
        def.mass = 0.25;
        const BodyId b = add(world, def);
        static_cast<void>(
            world.addConnector({.a = a, .b = b, .length = 1, .stiffness = 100, .damping = 2 * ratio * omega * reduced})
                .value());
        for (int i = 1; i <= 50; ++i) {
            world.update();
            const double t = 0.02 * i;
            const double decay = std::exp(-ratio * omega * t);
            double expected = 0.2 * decay * (1 + omega * t);
            if (ratio < 1) {
                const double f = omega * std::sqrt(1 - ratio * ratio);
                expected = 0.2 * decay * (std::cos(f * t) + ratio * omega / f * std::sin(f * t));
            } else if (ratio > 1) {
                const double f = omega * std::sqrt(ratio * ratio - 1);
                expected = 0.2 * decay * (std::cosh(f * t) + ratio * omega / f * std::sinh(f * t));
            }
            const double found = world.body(b).massCenter.x() - world.body(a).massCenter.x() - 1;
            QVERIFY2(std::abs(found - expected) <= 0.01 * 0.2,
                     qPrintable(QString("after %1 s: %2, expected %3").arg(t).arg(found).arg(expected)));
        }
    }
};

SPACETOW_TEST(RopesTest)
#include "ropes_test.moc"
