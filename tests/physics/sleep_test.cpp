// Who rests falls asleep, costs nothing, and goes on as if nothing had been.

#include "core/base/random.h"
#include "core/physics/query/explain.h"
#include "core/physics/state/world_data.h"
#include "core/physics/world/world.h"
#include "tests/support/allocation_count.h"
#include "tests/support/rows.h"
#include "tests/support/scenes.h"
#include "tests/support/sleepers.h"
#include "tests/support/test_main.h"

using namespace spacetow;
using namespace spacetow::test;

class SleepTest : public QObject {
    Q_OBJECT

  private slots:
    void aBodyAtRestFallsAsleepAfterHalfASecond() {
        World world = sleepyWorld();
        add(world, edgeBody({-5, 0}, {5, 0}));
        const BodyId id = add(world, ball({0, 0.2}, 0.2));
        for (int i = 0; i < 24; ++i) {
            world.update();
            QVERIFY(!world.body(id).asleep);
        }
        int fell = 0;
        for (int i = 0; i < 10; ++i) {
            world.update();
            fell += static_cast<int>(world.events().fellAsleep.size());
            QVERIFY(world.events().ended.empty());
        }
        QCOMPARE(fell, 1);
        const BodyState state = world.body(id);
        QVERIFY(state.asleep);
        QCOMPARE(state.velocity, Vec2(0, 0));
        QCOMPARE(state.angularVelocity, 0.0);
        QVERIFY(state.touchedTags.bits != 0);
    }

    void nobodySleepsUnlessAllowed() {
        World world;
        QVERIFY(!world.data().sleep.allowed);
        add(world, edgeBody({-5, 0}, {5, 0}));
        const BodyId id = add(world, ball({0, 0.2}, 0.2));
        runUpdates(world, 200);
        QVERIFY(!world.body(id).asleep);
    }

    void aMovingBodyStaysAwake() {
        World world = sleepyWorld();
        add(world, edgeBody({-50, 0}, {50, 0}));
        BodyDef def = ball({-5, 0.2}, 0.2);
        def.velocity = {0.05, 0};
        def.angularVelocity = -0.25;
        const BodyId rolling = add(world, def);
        def = ball({0, 3}, 0.2);
        def.kind = BodyKind::Kinematic;
        def.velocity = {0.001, 0};
        const BodyId creeping = add(world, def);
        runUpdates(world, 200);
        QVERIFY(!world.body(rolling).asleep);
        QVERIFY(!world.body(creeping).asleep);
        QVERIFY(std::abs(world.body(creeping).massCenter.x() - 0.004) < 1e-9);
    }

    void aBodyThatOnlyTurnsStaysAwake() {
        World world = sleepyWorld();
        world.setParameters({.gravity = {0, 0}});
        BodyDef def = ball({0, 0}, 0.2);
        def.angularVelocity = 0.1; // its rim goes 2 cm/s
        const BodyId id = add(world, def);
        runUpdates(world, 200);
        QVERIFY(!world.body(id).asleep);
    }

    void whoIsDisturbedStaysAwakeForHalfASecondMore() {
        World world = sleepyWorld();
        world.setParameters({.gravity = {0, 0}});
        const BodyId id = add(world, ball({0, 0}, 0.2));
        for (int i = 0; i < 10; ++i) {
            runUpdates(world, 20);
            world.setVelocity(id, {0, 0}, 0);
            QVERIFY(!world.body(id).asleep);
        }
        runUpdates(world, 20);
        world.setSleeping(false); // what was still while it was forbidden does not count
        world.update();
        world.setSleeping(true);
        runUpdates(world, 20);
        QVERIFY(!world.body(id).asleep);
        runUpdates(world, 10);
        QVERIFY(world.body(id).asleep);
    }

    void whoIsWokenByItsIslandStaysAwakeForHalfASecond() {
        World world = sleepyWorld();
        add(world, edgeBody({-5, 0}, {5, 0}));
        const BodyId lower = add(world, box({0, 0.2}, 0.2, 0.2));
        const BodyId upper = add(world, box({0, 0.6}, 0.2, 0.2));
        QVERIFY(runUntilAsleep(world, 2));
        world.setVelocity(upper, {0, 0}, 0);
        for (int i = 0; i < 24; ++i) {
            world.update();
            QVERIFY(!world.body(lower).asleep && !world.body(upper).asleep);
        }
        QVERIFY(runUntilAsleep(world, 2, 1));
    }

    void aBodyOnAMovingPlatformStaysAwake() {
        World world = sleepyWorld();
        BodyDef def = box({0, 0}, 1, 0.1);
        def.kind = BodyKind::Kinematic;
        def.velocity = {0.005, 0};
        add(world, def);
        const BodyId id = add(world, box({0, 0.2}, 0.1, 0.1));
        runUpdates(world, 200);
        QVERIFY(!world.body(id).asleep);
        QVERIFY(std::abs(world.body(id).massCenter.x() - 0.02) < 0.002);
    }

    void aBallHitsASleeperAsItHitsAnyBody_data() { iterationRows(); }
    void aBallHitsASleeperAsItHitsAnyBody() {
        QFETCH(int, iterations);
        for (const double speed : {1.0, 50.0, 400.0}) {
            std::vector<BodyState> after;
            for (const bool sleeping : {false, true}) {
                World world({.gravity = {0, 0}, .iterations = iterations});
                world.setSleeping(sleeping);
                BodyDef def = ball({0, 0}, 0.2);
                def.restitution = 1;
                const BodyId still = add(world, def);
                runUpdates(world, 50);
                QCOMPARE(world.body(still).asleep, sleeping);
                def.position = {-3, 0.1};
                def.velocity = {speed, 0};
                const BodyId hitting = add(world, def);
                runUpdates(world, 200);
                after.push_back(world.body(still));
                after.push_back(world.body(hitting));
            }
            QVERIFY(after[0].velocity.x() > 0.3 * speed);
            for (const std::size_t i : {0, 1}) {
                QCOMPARE(after[i + 2].massCenter, after[i].massCenter);
                QCOMPARE(after[i + 2].velocity, after[i].velocity);
                QCOMPARE(after[i + 2].angularVelocity, after[i].angularVelocity);
            }
        }
    }

    void aPileFallsAsleepAndCostsNothing_data() { iterationRows(); }
    void aPileFallsAsleepAndCostsNothing() {
        QFETCH(int, iterations);
        Scene scene = *makeScene("balls", 200);
        scene.parameters.iterations = iterations;
        World world = worldOf(scene);
        world.setSleeping(true);
        QVERIFY2(runUntilAsleep(world, 200, 40), qPrintable(QString::number(sleepers(world))));
        world.update();
        const std::uint64_t hash = world.hash();
        for (int i = 0; i < 20; ++i) {
            const std::uint64_t before = allocationCount();
            world.update();
            QCOMPARE(allocationCount() - before, std::uint64_t{0});
            QCOMPARE(world.data().contacts.table.size(), std::size_t{0});
            QVERIFY(world.data().bodies.moving.empty());
            QVERIFY(world.events().began.empty() && world.events().ended.empty());
        }
        QCOMPARE(world.hash(), hash);
    }

    void wakingRaisesNoEnergy_data() { iterationRows(); }
    void wakingRaisesNoEnergy() {
        QFETCH(int, iterations);
        Scene scene = *makeScene("balls", 200);
        scene.parameters.iterations = iterations;
        World world = worldOf(scene);
        world.setSleeping(true);
        QVERIFY(runUntilAsleep(world, 200, 40));
        const double asleep = totals(world).energy();
        for (int round = 0; round < 3; ++round) {
            world.setVelocity(world.bodies()[50], {0, 0}, 0);
            for (int i = 0; i < 50; ++i) {
                world.update();
                QVERIFY2(totals(world).energy() <= asleep * (1 + 1e-6),
                         qPrintable(QString("%1 of %2").arg(totals(world).energy() - asleep).arg(asleep)));
            }
            QVERIFY(runUntilAsleep(world, 200, 40));
        }
    }

    void connectedBodiesSleepAndWakeTogether() {
        World world = sleepyWorld();
        BodyDef def = box({0, 5}, 0.1, 0.1);
        def.kind = BodyKind::Static;
        const BodyId hook = add(world, def);
        def = ball({0, 4}, 0.1);
        def.mass = 1;
        def.linearDamping = 2;
        const BodyId first = add(world, def);
        def.position = {0, 3};
        const BodyId second = add(world, def);
        const ConnectorId rope = world.addConnector({.a = hook, .b = first, .stiffness = 200, .damping = 5}).value();
        QVERIFY(bool(world.addConnector({.a = first, .b = second, .stiffness = 200, .damping = 5})));
        QVERIFY(runUntilAsleep(world, 2));
        runUpdates(world, 50);
        QVERIFY(std::abs(world.connector(rope).tension - 2 * 9.81) < 0.1);
        const Vec2 place = world.body(second).massCenter;
        world.setVelocity(first, {0, 0}, 0);
        runUpdates(world, 5);
        QVERIFY(!world.body(second).asleep);
        QVERIFY((world.body(second).massCenter - place).norm() < 0.01);
        QVERIFY(runUntilAsleep(world, 2));
        world.removeConnector(rope);
        runUpdates(world, 50);
        QVERIFY(world.body(second).massCenter.y() < place.y() - 2);
    }

    void aSleeperThatReportsTouchesGoesOnReporting() {
        World world = sleepyWorld();
        BodyDef floor = edgeBody({-5, 0}, {5, 0});
        floor.filter.tags = TagMask::bit(7);
        const BodyId ground = add(world, floor);
        BodyDef def = ball({0, 0.2}, 0.2);
        def.reportsTouches = true;
        def.filter.tags = TagMask::bit(3);
        const BodyId id = add(world, def);
        QVERIFY(runUntilAsleep(world, 1));
        for (int i = 0; i < 5; ++i) {
            world.update();
            QCOMPARE(world.events().tagsTouched.size(), std::size_t{20});
            QCOMPARE(world.events().tagsTouched[7].tags.bits, TagMask::bit(7).bits);
            QCOMPARE(world.body(id).touchedTags.bits, TagMask::bit(7).bits);
            QCOMPARE(world.body(ground).touchedTags.bits, TagMask::bit(3).bits);
        }
        world.setPose(id, {0, 3}, 0);
        world.update();
        QCOMPARE(world.events().ended.size(), std::size_t{1});
        QCOMPARE(world.body(ground).touchedTags.bits, 0u);
    }

    void aCopiedWorldSleepsAndWakesEqually() {
        Random random(41);
        World world = worldOf(*makeScene("balls", 60));
        world.setSleeping(true);
        int slept = 0;
        for (int round = 0; round < 40; ++round) {
            World copy = world;
            const std::vector<BodyId> ids = world.bodies();
            const BodyId id = ids[ids.size() - 60 + random.below(60)];
            const Vec2 kick(random.uniform(-0.02, 0.02), 0.05);
            for (World* w : {&world, &copy}) {
                if (round % 2 != 0) {
                    w->applyImpulseAt(id, kick, w->body(id).massCenter);
                }
                runUpdates(*w, 30);
            }
            QCOMPARE(copy.hash(), world.hash());
            slept += sleepers(world);
        }
        QVERIFY(slept > 0);
    }

    void aLonelySleeperHasADifferentHashThanOneAwake() {
        World world = sleepyWorld();
        world.setParameters({.gravity = {0, 0}});
        add(world, ball({0, 0}, 0.2));
        World other = world;
        QVERIFY(runUntilAsleep(world, 1));
        QVERIFY(world.hash() != other.hash());
    }
};

SPACETOW_TEST(SleepTest)
#include "sleep_test.moc"
