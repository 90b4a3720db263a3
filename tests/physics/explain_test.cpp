#include "tests/support/contact_scenes.h"
#include "tests/support/rows.h"
#include "tests/support/scenes.h"

#include "core/base/random.h"
#include "core/physics/def/stage_times.h"
#include "core/physics/query/explain.h"

#include <algorithm>
#include <numeric>

using namespace spacetow;
using namespace spacetow::test;

namespace {

/// Balls, boxes and hexagons of many masses that fall into a trough, some of them joined; or that fly about in a box.
World explainedScene(Random& random, double restitution) {
    World world(withIterations(static_cast<int>(1 + random.below(8)), {random.uniform(-3, 3), random.uniform(-10, 0)}));
    add(world, edgeBody({-2, 0}, {2, 0}));
    add(world, edgeBody({2, 0}, {3, 8}));
    add(world, edgeBody({-3, 8}, {-2, 0}));
    add(world, edgeBody({3, 8}, {-3, 8}));
    std::vector<BodyId> all;
    for (int i = 0; i < 8; ++i) {
        BodyDef def = dropped(QStringList{"ball", "box", "hexagon"}[static_cast<int>(random.below(3))],
                              {-1.5 + (i % 4), 1 + 1.2 * (i / 4) + random.uniform(0, 0.2)});
        def.velocity = {random.uniform(-2, 2), random.uniform(-2, 2)};
        def.angularVelocity = random.uniform(-3, 3);
        def.restitution = restitution;
        def.mass = random.uniform(0.5, 3);
        all.push_back(add(world, def));
    }
    world.setRecordsImpulses(true);
    return world;
}

double biggest(const WorldReading& reading) {
    return std::abs(reading.kinetic) + std::abs(reading.potential) + std::abs(reading.elastic);
}

/// A ball that hangs on a spring.
struct SpringScene {
    World world;
    BodyId ball;
    ConnectorId spring;

    explicit SpringScene(double below) {
        BodyDef hook = test::ball({0, 0}, 0.1);
        hook.kind = BodyKind::Static;
        const BodyId a = add(world, hook);
        BodyDef def = test::ball({0, -1 - below}, 0.2);
        def.mass = 2;
        ball = add(world, def);
        spring = world.addConnector({.a = a, .b = ball, .length = 1, .stiffness = 50, .damping = 2}).value();
    }
};

} // namespace

class ExplainTest : public QObject {
    Q_OBJECT

  private slots:
    // Within a thousandth, and what gravity gives in an iteration: a body that is stopped where it meets something
    // loses the rest of that one. What is pressed into a corner may be held back a little more.
    void forcesAddUpToTheChangeOfMomentum_data() {
        QTest::addColumn<double>("restitution");
        for (const double restitution : {0.0, 0.7}) {
            QTest::addRow("restitution %.1f", restitution) << restitution;
        }
    }
    void forcesAddUpToTheChangeOfMomentum() {
        QFETCH(double, restitution);
        int judged = 0;
        int wrong = 0;
        for (std::uint64_t seed = 1; seed <= usualOrThin<std::uint64_t>(40, 8); ++seed) {
            Random random(seed);
            World world = explainedScene(random, restitution);
            for (int update = 0; update < 60; ++update) {
                const World before = world;
                world.update();
                const double dt = world.parameters().seconds;
                for (const BodyId id : world.bodies()) {
                    const BodyState state = world.body(id);
                    if (state.kind != BodyKind::Dynamic) {
                        continue;
                    }
                    const BodyReading reading = explained(world, id);
                    const Vec2 change = reading.momentum - explained(before, id).momentum;
                    const Vec2 missing = change - dt * reading.forces.sum().force;
                    const double falls = dt * reading.forces.gravity.force.norm();
                    const double lost = falls / world.parameters().iterations;
                    ++judged;
                    wrong += missing.norm() > 1e-3 * (change.norm() + falls) + 1.5 * lost ? 1 : 0;
                }
            }
        }
        qInfo("%d of %d", wrong, judged);
        QVERIFY2(wrong <= judged / 200, qPrintable(QStringLiteral("%1 of %2").arg(wrong).arg(judged)));
    }

    void turnsAddUpToTheChangeOfSpin() {
        World world(withIterations(4));
        add(world, edgeBody({-5, 0}, {5, 0}));
        BodyDef def = ball({0, 0.2}, 0.2);
        def.velocity = {2, 0}; // slides, and begins to roll
        const BodyId id = add(world, def);
        world.setRecordsImpulses(true);
        for (int i = 0; i < 20; ++i) {
            const double before = explained(world, id).spin;
            world.update();
            const BodyReading reading = explained(world, id);
            QVERIFY(std::abs(reading.spin - before - 0.02 * reading.forces.sum().torque) < 1e-9);
        }
        QVERIFY(explained(world, id).spin < 0);
    }

    void aRopeThatGivesHoldsWhatItTookToStretchIt() {
        for (const TruncationRule rule : {TruncationRule::Clamp, TruncationRule::Tanh, TruncationRule::PartialTanh}) {
            World world(withIterations(50, {0, 0}));
            BodyDef hook = ball({0, 0}, 0.1);
            hook.kind = BodyKind::Static;
            const BodyId a = add(world, hook);
            BodyDef def = ball({0, -1}, 0.2);
            def.mass = 2;
            def.velocity = {0, -5}; // 25 J, for which the limit lets the rope go out by more than a metre
            const BodyId b = add(world, def);
            const Truncation limit{.rule = rule, .limit = 20, .custom = {}};
            const ConnectorId rope =
                world.addConnector({.a = a, .b = b, .length = 1, .stiffness = 2000, .slack = true, .truncation = limit})
                    .value();
            double most = 0;
            for (int i = 0; i < 100; ++i) {
                world.update();
                const WorldReading sum = totals(world);
                QVERIFY2(std::abs(sum.energy() - 25) < 0.25, qPrintable(QString::number(sum.energy())));
                QCOMPARE(explained(world, rope).energy, sum.elastic);
                most = std::max(most, sum.elastic);
            }
            QVERIFY(most > 24); // it has stood still at the end of the rope
        }
    }

    void totalsAndCountersKnowWhatHasBeenAddedSinceTheLastUpdate() {
        Random random(3);
        World world = explainedScene(random, 0.5);
        const auto areRight = [&world] {
            const WorldReading sum = totals(world);
            const WorldCounters count = counters(world);
            double parts = 0;
            int statics = 0, dynamics = 0;
            for (const BodyId id : world.bodies()) {
                const BodyReading one = explained(world, id);
                parts += one.energy.kinetic + one.energy.potential;
                ++(world.body(id).kind == BodyKind::Static ? statics : dynamics);
            }
            return std::abs(parts - sum.energy()) <= 1e-12 * (1 + biggest(sum)) && count.statics == statics &&
                   count.dynamics == dynamics;
        };
        QVERIFY(areRight()); // before the first update
        world.update();
        world.removeBody(world.bodies()[6]);
        world.removeBody(world.bodies()[2]);
        QVERIFY(areRight()); // they are still there
        world.update();
        QVERIFY(areRight());
        for (int i = 0; i < 4; ++i) { // in the places of those, and in others
            add(world, dropped(QStringLiteral("ball"), {-1.0 + 0.5 * i, 5}));
            add(world, edgeBody({-1.0 * i, -3}, {1, -3}));
            QVERIFY(areRight());
        }
        world.update();
        QVERIFY(areRight());
    }

    void energyIsThatOfTheWorld() {
        for (std::uint64_t seed = 1; seed <= 20; ++seed) {
            Random random(seed);
            World world = explainedScene(random, 0.5);
            const std::vector<BodyId> bodies = world.bodies();
            world.addConnector({.a = bodies[5], .b = bodies[6], .length = 0.3, .slack = true}).value();
            world.addConnector({.a = bodies[0], .b = bodies[7], .length = 2}).value();
            for (int update = 0; update < 10; ++update) {
                world.update();
                const WorldReading sum = totals(world);
                double parts = 0;
                Vec2 momentum(0, 0);
                double around = 0;
                for (const BodyId id : world.bodies()) {
                    const BodyReading one = explained(world, id);
                    parts += one.energy.kinetic + one.energy.potential;
                    momentum += one.momentum;
                    around += one.angularMomentum;
                }
                for (const ConnectorId id : world.connectors()) {
                    parts += explained(world, id).energy;
                }
                QVERIFY(std::abs(parts - sum.energy()) <= 1e-12 * (1 + biggest(sum)));
                QVERIFY((momentum - sum.momentum).norm() < 1e-9);
                QVERIFY2(
                    std::abs(around - sum.angularMomentum) < 1e-9,
                    qPrintable(
                        QStringLiteral("%1, not %2").arg(around, 0, 'g', 17).arg(sum.angularMomentum, 0, 'g', 17)));
            }
        }
    }

    void motionAddsUpWhereMomentaCancel() {
        World world(withIterations(4, {0, 0}));
        BodyDef def = ball({0, 0}, 0.2);
        def.mass = 2;
        def.velocity = {3, 0};
        add(world, def);
        world.update();
        def.position = {5, 0};
        def.velocity = {-3, 0};
        add(world, def); // counts before its first update
        QVERIFY(totals(world).momentum.norm() < 1e-12);
        QVERIFY(std::abs(totals(world).motion - 12) < 1e-12);
        QVERIFY(std::abs(totals(world).kinetic - 18) < 1e-12);
    }

    void whatHangsStillIsHeldByItsWeight() {
        SpringScene hanging(2 * 9.81 / 50);
        run(hanging.world, 20);
        const ConnectorReading spring = explained(hanging.world, hanging.spring);
        QVERIFY(std::abs(spring.tension - 2 * 9.81) < 1e-6);
        QVERIFY(std::abs(spring.distance - 1 - 2 * 9.81 / 50) < 1e-6);
        QVERIFY(std::abs(spring.energy - 25 * std::pow(spring.distance - 1, 2)) < 1e-12);
        const BodyForces forces = explained(hanging.world, hanging.ball).forces;
        QVERIFY(std::abs(forces.connectors.force.y() - 2 * 9.81) < 1e-6);
        QVERIFY(forces.sum().force.norm() < 1e-6);
    }

    void eachSourceIsToldApart() {
        World world(withIterations(4));
        BodyDef def = ball({0, 5}, 0.2);
        def.mass = 2;
        def.linearDamping = 0.5;
        def.velocity = {4, 0};
        const BodyId id = add(world, def);
        world.applyForce(id, {0, 7});
        world.applyTorque(id, -0.5);
        world.update();
        const BodyForces forces = explained(world, id).forces;
        QVERIFY((forces.gravity.force - Vec2(0, -2 * 9.81)).norm() < 1e-9);
        QVERIFY((forces.applied.force - Vec2(0, 7)).norm() < 1e-9);
        QVERIFY(std::abs(forces.applied.torque + 0.5) < 1e-12);
        QVERIFY((forces.damping.force + 0.5 * 2 * world.body(id).velocity).norm() < 1e-9);
        QVERIFY(forces.contacts.force.norm() == 0);
        world.update(); // applied for one update only
        QVERIFY(explained(world, id).forces.applied.force.norm() < 1e-9);
    }

    void aContactSaysWhereAndHowMuch_data() {
        QTest::addColumn<bool>("records");
        QTest::newRow("all impulses") << true;
        QTest::newRow("the last iteration") << false;
    }
    void aContactSaysWhereAndHowMuch() {
        QFETCH(bool, records);
        World world(withIterations(4));
        const BodyId floor = add(world, edgeBody({-5, 0}, {5, 0}));
        BodyDef def = ball({1, 0.2}, 0.2);
        def.mass = 3;
        const BodyId id = add(world, def);
        world.setRecordsImpulses(records);
        run(world, 2);
        const std::vector<ContactReading> contacts = contactsOf(world, id);
        QCOMPARE(contacts.size(), std::size_t(1));
        const ContactReading& contact = contacts.front();
        QCOMPARE(contact.a, floor);
        QCOMPARE(contact.b, id);
        QVERIFY(contact.touching && contact.solid);
        QVERIFY((contact.normal - Vec2(0, 1)).norm() < 1e-9);
        QVERIFY((contact.point - Vec2(1, 0)).norm() < 1e-3);
        QVERIFY(std::abs(contact.normalImpulse - 3 * 9.81 * 0.02) < 1e-6);
        QVERIFY(contactsOf(world, floor).size() == 1);
    }

    void aSensorThatIsPassedWithinAnIterationIsToldAsNoLongerTouched() {
        World world(withIterations(1, {0, 0}));
        BodyDef zone = box({0, 0}, 0.1, 1);
        zone.kind = BodyKind::Static;
        zone.tangible = false;
        const BodyId sensor = add(world, zone);
        BodyDef def = ball({-1, 0}, 0.1);
        def.velocity = {100, 0};
        const BodyId id = add(world, def);
        world.update();
        const std::vector<ContactReading> contacts = contactsOf(world, id);
        QCOMPARE(contacts.size(), std::size_t(1));
        QVERIFY(contacts.front().a == sensor && contacts.front().b == id);
        QVERIFY(!contacts.front().solid && !contacts.front().touching);
    }

    void anImpactWithinAnUpdateIsToldAfterwards() {
        World world(withIterations(100));
        BodyDef floor = edgeBody({-5, 0}, {5, 0});
        floor.restitution = 1;
        add(world, floor);
        BodyDef def = ball({0, 0.25}, 0.2);
        def.mass = 1;
        def.restitution = 1;
        def.velocity = {0, -5};
        const BodyId id = add(world, def);
        world.setRecordsImpulses(true);
        world.update();
        QVERIFY(world.body(id).velocity.y() > 4);
        const std::vector<ContactReading> contacts = contactsOf(world, id);
        QCOMPARE(contacts.size(), std::size_t(1));
        QVERIFY(!contacts.front().touching);
        QVERIFY(std::abs(contacts.front().normalImpulse - 10.2) < 0.05);
        QVERIFY(std::abs(contacts.front().point.y()) < 1e-2);
        world.update();
        QVERIFY(contactsOf(world, id).empty());
    }

    void recordingAndTimingChangeNothing() {
        for (const char* name : {"pyramid", "balls", "mesh"}) {
            const std::optional<Scene> scene = makeScene(name, 8);
            QVERIFY2(scene.has_value(), name);
            World plain = worldOf(*scene);
            World watched = plain;
            watched.setRecordsImpulses(true);
            StageTimes times{.clock = [now = std::int64_t(0)]() mutable { return now += 1; }};
            for (int i = 0; i < 40; ++i) {
                plain.update();
                watched.update(watched.parameters(), times);
                QCOMPARE(watched.hash(), plain.hash());
            }
        }
    }

    void allTimeBelongsToStages() {
        World world(withIterations(4));
        add(world, edgeBody({-5, 0}, {5, 0}));
        for (int i = 0; i < 5; ++i) {
            add(world, box({0, 0.3 + 0.5 * i}, 0.2, 0.2));
        }
        std::int64_t now = 0;
        StageTimes times{.clock = [&now] { return now += 5; }};
        for (int i = 0; i < 50; ++i) {
            const std::int64_t before = std::accumulate(times.spent.begin(), times.spent.end(), std::int64_t(0));
            const std::int64_t begin = now;
            world.update(world.parameters(), times);
            const std::int64_t after = std::accumulate(times.spent.begin(), times.spent.end(), std::int64_t(0));
            QCOMPARE(after - before, now - begin - 5); // but for the look at the clock that begins
        }
        for (const StepStage stage : {StepStage::Changes, StepStage::Motion, StepStage::Pairs, StepStage::Contacts,
                                      StepStage::Solver, StepStage::Touches, StepStage::Sleep}) {
            QVERIFY2(times.spent[static_cast<std::size_t>(stage)] > 0, QByteArray::number(int(stage)));
        }
        const std::int64_t end = now;
        world.update();
        QCOMPARE(now, end); // nobody asks any more
    }

    void everythingIsCounted() {
        World world(withIterations(4));
        add(world, edgeBody({-5, 0}, {5, 0}));
        BodyDef lift = box({3, 3}, 0.5, 0.1);
        lift.kind = BodyKind::Kinematic;
        const BodyId kinematic = add(world, lift);
        const BodyId low = add(world, box({0, 0.2}, 0.2, 0.2));
        add(world, box({0, 0.6}, 0.2, 0.2));
        const BodyId far = add(world, ball({3, 2}, 0.2));
        world.addConnector({.a = kinematic, .b = far}).value();
        run(world, 1);
        WorldCounters count = counters(world);
        QCOMPARE(count.statics, 1);
        QCOMPARE(count.kinematics, 1);
        QCOMPARE(count.dynamics, 3);
        QCOMPARE(count.awake, 4);
        QCOMPARE(count.asleep, 0);
        QCOMPARE(count.connectors, 1);
        QCOMPARE(count.contacts, 2);
        QVERIFY(count.pairs >= 2 && count.treeCells >= 2);
        QCOMPARE(count.islands, 3); // the pile, the lift, the ball
        const int pairs = count.pairs;
        world.setSleeping(true);
        run(world, 3);
        count = counters(world);
        QVERIFY(count.asleep >= 2);
        QCOMPARE(count.contacts, 2);
        QCOMPARE(count.pairs, pairs);
        const ForceReading held = explained(world, low).forces.contacts;
        QVERIFY(std::abs(held.force.y() - 9.81 * world.body(low).mass) < 0.1);
    }
};

SPACETOW_TEST(ExplainTest)
#include "explain_test.moc"
