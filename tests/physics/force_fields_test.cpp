// Forces that are computed anew before every sub-step, against closed formulas.

#include "core/physics/world/world.h"
#include "tests/support/bodies.h"
#include "tests/support/rows.h"
#include "tests/support/test_main.h"

#include <cmath>
#include <limits>
#include <numbers>

using namespace spacetow;
using namespace spacetow::test;

namespace {

UpdateParameters weightless(int iterations) {
    return {.gravity = {0, 0}, .iterations = iterations};
}

/// Of 1 kg, away from everything else.
BodyDef probe(const Vec2& at, const Vec2& velocity = {0, 0}) {
    BodyDef def = ball(at, 0.1);
    def.mass = 1;
    def.velocity = velocity;
    return def;
}

ForceFieldDef springTo(const Vec2& point, double stiffness) {
    return {.force = [point, stiffness](const FieldSample& s) {
        return FieldForce{Vec2(stiffness * (point - s.massCenter)), 0};
    }};
}

ForceFieldDef drag(double c, double ofTurning = 0) {
    return {.force = [c, ofTurning](const FieldSample& s) {
        return FieldForce{Vec2(-c * s.velocity), -ofTurning * s.angularVelocity};
    }};
}

ForceFieldDef constant(const Vec2& force) {
    return {.force = [force](const FieldSample&) { return FieldForce{force, 0}; }};
}

FieldId fieldIn(World& world, ForceFieldDef def) {
    const Result<FieldId> field = world.addField(std::move(def));
    EXPECTS(bool(field));
    return field.value();
}

void runUpdates(World& world, int updates) {
    for (int i = 0; i < updates; ++i) {
        world.update();
    }
}

double relativeErrorOf(double value, double expected) {
    return std::abs(value / expected - 1);
}

} // namespace

class ForceFieldsTest : public QObject {
    Q_OBJECT

  private slots:
    void aSpringToAPointSwingsWithItsPeriodAndKeepsItsEnergy_data() { iterationRows(); }
    void aSpringToAPointSwingsWithItsPeriodAndKeepsItsEnergy() {
        QFETCH(int, iterations);
        constexpr double stiffness = 400; // ω = 20 rad/s
        World world(weightless(iterations));
        const BodyId id = test::add(world, probe({0.1, 0}));
        fieldIn(world, springTo({0, 0}, stiffness));
        const auto energy = [&] {
            const BodyState state = world.body(id);
            return 0.5 * state.velocity.squaredNorm() + 0.5 * stiffness * state.massCenter.squaredNorm();
        };
        const double start = energy();
        double highest = start;
        double lowest = start;
        double before = 0.1;
        double time = 0;
        double lastCrossing = 0;
        for (int periods = 0; periods < 1000;) {
            world.update();
            time += 0.02;
            const double x = world.body(id).massCenter.x();
            if (before < 0 && x >= 0) {
                lastCrossing = time - 0.02 * x / (x - before);
                ++periods;
            }
            before = x;
            highest = std::max(highest, energy());
            lowest = std::min(lowest, energy());
        }
        const double period = 2 * std::numbers::pi / std::sqrt(stiffness);
        QVERIFY2(relativeErrorOf(lastCrossing, 999.75 * period) < 1e-3, qPrintable(QString::number(lastCrossing)));
        QVERIFY2(highest < 1.01 * start && lowest > 0.99 * start,
                 qPrintable(QString("%1 %2 %3").arg(lowest).arg(start).arg(highest)));
    }

    void dragSlowsABodyDownExponentially_data() { iterationRows(); }
    void dragSlowsABodyDownExponentially() {
        QFETCH(int, iterations);
        World world(weightless(iterations));
        const BodyId id = test::add(world, [] {
            BodyDef def = probe({0, 0}, {3, -4});
            def.angularVelocity = 2;
            return def;
        }());
        const double inertia = world.body(id).inertia;
        fieldIn(world, drag(0.7, 1.1 * inertia));
        for (int second = 1; second <= 10; ++second) {
            runUpdates(world, 50);
            const BodyState state = world.body(id);
            QVERIFY(relativeErrorOf(state.velocity.x(), 3 * std::exp(-0.7 * second)) < 1e-3);
            QVERIFY(relativeErrorOf(state.velocity.y(), -4 * std::exp(-0.7 * second)) < 1e-3);
            QVERIFY(relativeErrorOf(state.angularVelocity, 2 * std::exp(-1.1 * second)) < 1e-3);
            QVERIFY(relativeErrorOf(state.massCenter.x(), 3 / 0.7 * (1 - std::exp(-0.7 * second))) < 1e-3);
        }
    }

    void aForceAcrossTheVelocityBendsThePathIntoACircle_data() { iterationRows(); }
    void aForceAcrossTheVelocityBendsThePathIntoACircle() {
        QFETCH(int, iterations);
        World world(weightless(iterations));
        const BodyId id = test::add(world, probe({0, 0}, {6, 0}));
        fieldIn(world, {.force = [](const FieldSample& s) { return FieldForce{Vec2(3 * leftOf(s.velocity)), 0}; }});
        for (int i = 0; i < 500; ++i) {
            world.update();
            QVERIFY(std::abs((world.body(id).massCenter - Vec2(0, 2)).norm() - 2) < 0.01);
            QVERIFY(relativeErrorOf(world.body(id).velocity.norm(), 6) < 1e-3);
        }
    }

    void aPlanetsOrbitKeepsEnergyAndAngularMomentum() {
        World world(weightless(20));
        const BodyId id = test::add(world, probe({1, 0}, {0, 1.2}));
        fieldIn(world, {.force = [](const FieldSample& s) {
                    const double r = s.massCenter.norm();
                    return FieldForce{Vec2(s.massCenter * (-1 / (r * r * r))), 0};
                }});
        for (int i = 0; i < fullOrQuick(50000, 5000); ++i) {
            world.update();
            const BodyState s = world.body(id);
            QVERIFY(relativeErrorOf(0.5 * s.velocity.squaredNorm() - 1 / s.massCenter.norm(), 0.72 - 1) < 1e-3);
            QVERIFY(relativeErrorOf(cross(s.massCenter, s.velocity), 1.2) < 1e-9);
        }
    }

    void aConstantFieldActsExactlyOnceAKick_data() { iterationRows(); }
    void aConstantFieldActsExactlyOnceAKick() {
        QFETCH(int, iterations);
        for (const int substeps : {1, 2, 3, 7}) {
            UpdateParameters parameters = weightless(iterations);
            parameters.substeps = substeps;
            World world(parameters);
            const BodyId id = test::add(world, probe({1, 2}, {0.5, 1}));
            fieldIn(world, constant({2, -5}));
            fieldIn(world, constant({1, 2}));
            runUpdates(world, 500);
            const BodyState state = world.body(id);
            QVERIFY(relativeErrorOf(state.velocity.x(), 0.5 + 3 * 10) < 1e-9);
            QVERIFY(relativeErrorOf(state.velocity.y(), 1 - 3 * 10) < 1e-9);
            QVERIFY(relativeErrorOf(state.massCenter.x(), 1 + 0.5 * 10 + 1.5 * 100) < 1e-9);
            QVERIFY(relativeErrorOf(state.massCenter.y(), 2 + 1 * 10 - 1.5 * 100) < 1e-9);
        }
    }

    void aFieldPressesABodyOnTheFloorAsGravityDoes() {
        World world(weightless(20));
        test::add(world, edgeBody({-5, 0}, {5, 0}));
        const BodyId id = test::add(world, probe({0, 0.3}));
        fieldIn(world, constant({0, -9.81}));
        runUpdates(world, 200);
        QVERIFY(std::abs(world.body(id).massCenter.y() - 0.1) < 0.005);
        QVERIFY(world.body(id).velocity.norm() < 1e-3);
    }

    void aFieldAndAConnectorActOnOneBodyInEitherOrder() {
        std::uint64_t hashes[2];
        for (const bool fieldFirst : {false, true}) {
            World world(weightless(20));
            const BodyId a = test::add(world, probe({0, 0}));
            const BodyId b = test::add(world, probe({1, 0}));
            if (fieldFirst) {
                fieldIn(world, constant({1, 2}));
            }
            QVERIFY(bool(world.addConnector({.a = a, .b = b, .length = 0.8, .stiffness = 100})));
            if (!fieldFirst) {
                fieldIn(world, constant({1, 2}));
            }
            runUpdates(world, 50);
            hashes[fieldFirst ? 1 : 0] = world.hash();
            QVERIFY(relativeErrorOf(world.body(a).velocity.x() + world.body(b).velocity.x(), 2) < 1e-9);
        }
        QCOMPARE(hashes[0], hashes[1]);
    }

    void onlyBodiesWithItsTagsFeelAField() {
        World world(weightless(4));
        BodyDef def = probe({0, 0});
        def.filter.tags = TagMask::bit(3);
        const BodyId with = test::add(world, def);
        def.position = {5, 0};
        def.filter.tags = TagMask::bit(2);
        const BodyId without = test::add(world, def);
        ForceFieldDef field = constant({1, 0});
        field.tags = TagMask::bit(3) | TagMask::bit(7);
        fieldIn(world, field);
        runUpdates(world, 50);
        QVERIFY(relativeErrorOf(world.body(with).velocity.x(), 1) < 1e-9);
        QCOMPARE(world.body(without).velocity.x(), 0.0);
        world.setFilter(without, {.tags = TagMask::bit(7)});
        world.setFilter(with, {.tags = TagMask::bit(2)});
        runUpdates(world, 50);
        QVERIFY(relativeErrorOf(world.body(with).velocity.x(), 1) < 1e-9);
        QVERIFY(relativeErrorOf(world.body(without).velocity.x(), 1) < 1e-9);
    }

    void aBodyAddedAfterAFieldFeelsIt() {
        World world(weightless(4));
        fieldIn(world, constant({1, 0}));
        const BodyId id = test::add(world, probe({0, 0}));
        runUpdates(world, 50);
        QVERIFY(relativeErrorOf(world.body(id).velocity.x(), 1) < 1e-9);
    }

    void kinematicBodiesFeelManualFieldsOnlyAndStaticBodiesNone() {
        for (const ForceSource source : {ForceSource::Engine, ForceSource::Manual}) {
            World world(weightless(4));
            std::vector<BodyId> ids;
            for (const BodyKind kind : {BodyKind::Static, BodyKind::Kinematic, BodyKind::Dynamic}) {
                BodyDef def = probe({5.0 * static_cast<int>(kind), 0});
                def.kind = kind;
                ids.push_back(test::add(world, def));
            }
            ForceFieldDef field = constant({1, 0});
            field.source = source;
            fieldIn(world, field);
            runUpdates(world, 50);
            QCOMPARE(world.body(ids[0]).velocity.x(), 0.0);
            QVERIFY(std::abs(world.body(ids[1]).velocity.x() - (source == ForceSource::Manual ? 1 : 0)) < 1e-9);
            QVERIFY(relativeErrorOf(world.body(ids[2]).velocity.x(), 1) < 1e-9);
        }
    }

    void frozenAndInactiveBodiesFeelNothing() {
        World world(weightless(4));
        BodyDef def = probe({0, 0});
        def.positionFrozen = true;
        const BodyId frozen = test::add(world, def);
        def = probe({5, 0});
        def.active = false;
        const BodyId inactive = test::add(world, def);
        fieldIn(world, {.force = [](const FieldSample&) { return FieldForce{Vec2(1, 1), 0.01}; }});
        runUpdates(world, 50);
        QCOMPARE(world.body(frozen).velocity, Vec2(0, 0));
        QVERIFY(world.body(frozen).angularVelocity > 0);
        QCOMPARE(world.body(inactive).velocity, Vec2(0, 0));
        world.setActive(inactive, true);
        runUpdates(world, 50);
        QVERIFY(relativeErrorOf(world.body(inactive).velocity.x(), 1) < 1e-9);
    }

    void aRemovedFieldActsNoMore() {
        World world(weightless(4));
        const BodyId id = test::add(world, probe({0, 0}));
        const FieldId field = fieldIn(world, constant({1, 0}));
        QVERIFY(world.contains(field));
        runUpdates(world, 50);
        world.removeField(field);
        QVERIFY(!world.contains(field));
        const Vec2 velocity = world.body(id).velocity;
        runUpdates(world, 50);
        QCOMPARE(world.body(id).velocity, velocity);
        const FieldId next = fieldIn(world, constant({0, 1}));
        QVERIFY(next != field && !world.contains(field));
    }

    void aFieldOfOneBodyIsFeltByItAloneAndRemovedWithIt() {
        World world(weightless(4));
        const BodyId id = test::add(world, probe({0, 0}));
        const BodyId other = test::add(world, probe({5, 0}));
        ForceFieldDef def = constant({1, 0});
        def.body = id;
        const FieldId field = fieldIn(world, def);
        runUpdates(world, 50);
        QVERIFY(relativeErrorOf(world.body(id).velocity.x(), 1) < 1e-9);
        QCOMPARE(world.body(other).velocity.x(), 0.0);
        world.removeBody(id);
        world.update();
        QVERIFY(!world.contains(field));
        const BodyId inItsPlace = test::add(world, probe({0, 0}));
        QCOMPARE(inItsPlace.index, id.index);
        runUpdates(world, 50);
        QCOMPARE(world.body(inItsPlace).velocity.x(), 0.0);
        const Result<FieldId> refused = world.addField(def);
        QVERIFY(!refused);
        QCOMPARE(refused.error().code, std::string("no-such-body"));
    }

    void aFieldWithoutAFunctionIsRefused() {
        World world;
        const Result<FieldId> refused = world.addField({});
        QVERIFY(!refused);
        QCOMPARE(refused.error().code, std::string("no-force"));
    }

    void whatIsNotFiniteDoesNotActAndIsReportedOnceAnUpdate() {
        World world(weightless(4));
        const BodyId id = test::add(world, probe({0, 0}));
        const BodyId far = test::add(world, probe({5, 0}));
        fieldIn(world, constant({1, 0}));
        const FieldId bad = fieldIn(world, {.force = [](const FieldSample& s) {
                                        constexpr double nan = std::numeric_limits<double>::quiet_NaN();
                                        return FieldForce{{s.massCenter.x() < 4 ? nan : 1, 0}, 0};
                                    }});
        for (int i = 0; i < 50; ++i) {
            world.update();
            QCOMPARE(world.events().fieldFaults.size(), std::size_t{1});
            QVERIFY(world.events().fieldFaults[0].field == bad);
            QVERIFY(world.events().fieldFaults[0].body == id);
            QCOMPARE(world.events().fieldFaults[0].iteration, 0);
            QVERIFY(world.events().faults.empty());
        }
        QVERIFY(relativeErrorOf(world.body(id).velocity.x(), 1) < 1e-9);
        QVERIFY(relativeErrorOf(world.body(far).velocity.x(), 2) < 1e-9);
    }

    void aCopyOfAWorldGoesOnEqually() {
        World world(weightless(20));
        test::add(world, edgeBody({-5, 0}, {5, 0}));
        test::add(world, probe({0, 1}, {0.3, 0}));
        const FieldId field = fieldIn(world, springTo({0, -1}, 30));
        fieldIn(world, drag(0.2));
        runUpdates(world, 20);
        World copy = world;
        runUpdates(world, 50);
        runUpdates(copy, 50);
        QCOMPARE(copy.hash(), world.hash());
        copy.removeField(field);
        QVERIFY(world.contains(field));
        QVERIFY(copy.hash() != world.hash());
    }

    void aBodyThatNoFieldTouchesMovesAsWithoutAny() {
        World with;
        World without;
        ForceFieldDef field = constant({5, 5});
        field.tags = TagMask::bit(9);
        fieldIn(with, field);
        for (World* world : {&with, &without}) {
            test::add(*world, edgeBody({-5, 0}, {5, 0}));
            test::add(*world, probe({0, 1}, {0.3, 0}));
            runUpdates(*world, 100);
        }
        QCOMPARE(with.body(with.bodies()[1]).massCenter, without.body(without.bodies()[1]).massCenter);
        QCOMPARE(with.body(with.bodies()[1]).velocity, without.body(without.bodies()[1]).velocity);
    }
};

SPACETOW_TEST(ForceFieldsTest)
#include "force_fields_test.moc"
