#include "core/physics/query/explain.h"
#include "tests/support/contact_scenes.h"
#include "tests/support/odd_numbers.h"
#include "tests/support/rows.h"

#include <functional>
#include <limits>

using namespace spacetow;
using namespace spacetow::test;

namespace {

const double huge = std::numeric_limits<double>::max();

/// What makes the state of one body, made of finite numbers, overflow.
struct Overflow {
    const char* name;
    std::function<void(BodyDef&)> define;
    std::function<void(World&, BodyId)> push;
};

void leave(BodyDef&) {}
void wait(World&, BodyId) {}
void makeLight(BodyDef& def) {
    def.mass = 1e-300;
}

const Overflow overflows[] = {
    {"a force on next to no mass", makeLight,
     [](World& w, BodyId id) {
         w.applyForce(id, {1e300, 0});
     }},
    {"two forces together", leave,
     [](World& w, BodyId id) {
         w.applyForce(id, {0, huge});
         w.applyForce(id, {0, huge});
     }},
    {"two torques together", leave,
     [](World& w, BodyId id) {
         w.applyTorque(id, huge);
         w.applyTorque(id, huge);
     }},
    {"a force with a lever", leave,
     [](World& w, BodyId id) {
         w.applyForceAt(id, {0, 1e200}, {1e200, 0});
     }},
    {"an impulse on next to no mass", makeLight,
     [](World& w, BodyId id) {
         w.applyImpulseAt(id, {0, 1e300}, w.body(id).massCenter);
     }},
    {"an angular impulse", makeLight, [](World& w, BodyId id) { w.applyAngularImpulse(id, 1e300); }},
    {"a speed beyond what can be swept",
     [](BodyDef& d) {
         d.velocity = {0, huge};
     },
     wait},
    {"a spin beyond what can be swept", [](BodyDef& d) { d.angularVelocity = huge; }, wait},
    {"a circle of infinite mass",
     [](BodyDef& d) {
         d.shapes = {Circle{{0, 0}, 1e200}};
     },
     wait},
    {"a polygon of infinite mass",
     [](BodyDef& d) {
         d.shapes = {Polygon{{Vec2(0, 0), Vec2(1e200, 0), Vec2(0, 1e200)}}};
     },
     wait},
    {"a rod of infinite inertia",
     [](BodyDef& d) {
         d.shapes = {Line{{0, 0}, {1e200, 0}}};
     },
     wait},
    {"a density that makes the mass infinite",
     [](BodyDef& d) {
         d.shapes = {Circle{{0, 0}, 10}};
         d.density = 1e308;
     },
     wait},
};

/// Balls and boxes in a room, some on ropes, some at rest and some in flight.
World company(int iterations) {
    World world(withIterations(iterations));
    add(world, floorOf("edge"));
    BodyId before;
    for (int i = 0; i < 8; ++i) {
        BodyDef def = dropped(i % 2 == 0 ? "ball" : "box", {i - 4.0, 0.3 + 0.4 * i});
        def.restitution = 0.5;
        const BodyId id = add(world, def);
        if (i > 1 && i % 3 == 0) {
            static_cast<void>(world.addConnector({.a = before, .b = id, .stiffness = 50, .damping = 1}).value());
        }
        before = id;
    }
    return world;
}

bool isSameState(const BodyState& a, const BodyState& b) {
    return a.massCenter == b.massCenter && a.pose.rotation == b.pose.rotation && a.velocity == b.velocity &&
           a.angularVelocity == b.angularVelocity && a.active == b.active;
}

} // namespace

class FaultsTest : public QObject {
    Q_OBJECT

  private slots:
    void whatOverflowsIsRefusedOrSwitchedOffAloneAndReported_data() {
        QTest::addColumn<int>("index");
        QTest::addColumn<BodyKind>("kind");
        QTest::addColumn<int>("iterations");
        for (int i = 0; i < static_cast<int>(std::size(overflows)); ++i) {
            for (const int iterations : iterationCounts) {
                QTest::addRow("%s, %d iterations", overflows[i].name, iterations)
                    << i << BodyKind::Dynamic << iterations;
                QTest::addRow("%s, kinematic, %d iterations", overflows[i].name, iterations)
                    << i << BodyKind::Kinematic << iterations;
            }
        }
    }
    void whatOverflowsIsRefusedOrSwitchedOffAloneAndReported() {
        QFETCH(int, index);
        QFETCH(BodyKind, kind);
        QFETCH(int, iterations);
        World world = company(iterations);
        run(world, 0.1);
        World without = world;
        BodyDef def = ball({1000, 1000}, 0.2);
        def.kind = kind;
        overflows[index].define(def);
        const auto made = world.addBody(def);
        int faults = 0;
        if (made) {
            overflows[index].push(world, made.value());
        } else {
            QCOMPARE(made.error().code.text(), std::string("bad-mass"));
        }
        for (int i = 0; i < 100; ++i) {
            world.update();
            without.update();
            for (const FaultEvent& event : world.events().faults) {
                QVERIFY(made && event.body == made.value());
                ++faults;
            }
            for (const BodyId id : without.bodies()) {
                QVERIFY2(isSameState(world.body(id), without.body(id)), qPrintable(QString("update %1").arg(i)));
            }
        }
        QCOMPARE(faults, made ? 1 : 0);
        QVERIFY(!made || !world.body(made.value()).active);
        QVERIFY(std::isfinite(totals(world).energy()));
    }

    void aBodyThatOverflowsAmongOthersHarmsNone_data() { iterationRows(); }
    void aBodyThatOverflowsAmongOthersHarmsNone() {
        QFETCH(int, iterations);
        World world = company(iterations);
        run(world, 1);
        const BodyId bad = world.bodies()[2]; // on no rope
        world.applyForce(bad, {huge, 0});
        world.applyForce(bad, {huge, 0});
        run(world, 1);
        for (const BodyId id : world.bodies()) {
            const BodyState state = world.body(id);
            QCOMPARE(state.active, id != bad);
            QVERIFY(isFinite(state.massCenter) && isFinite(state.velocity));
            QVERIFY(state.massCenter.norm() < 100);
        }
        world.setVelocity(bad, {0, 0}, 0); // it may be used again
        world.setActive(bad, true);
        run(world, 1);
        QVERIFY(world.body(bad).active && isFinite(world.body(bad).massCenter));
    }

    void whatOverflowsOnARopeLeavesItsOtherEndAlone_data() { iterationRows(); }
    void whatOverflowsOnARopeLeavesItsOtherEndAlone() {
        QFETCH(int, iterations);
        World world(withIterations(iterations));
        const BodyId bad = add(world, ball({0, 0}, 0.1));
        const BodyId good = add(world, ball({1, 0}, 0.1));
        static_cast<void>(world.addConnector({.a = bad, .b = good}).value());
        world.applyForce(bad, {huge, 0});
        world.applyForce(bad, {huge, 0});
        int faults = 0;
        for (int i = 0; i < 10; ++i) {
            world.update();
            for (const FaultEvent& event : world.events().faults) {
                QVERIFY(event.body == bad);
                ++faults;
            }
        }
        QCOMPARE(faults, 1);
        QVERIFY(!world.body(bad).active && world.body(good).active);
        const double fallen = -9.81 * 0.2 * 0.2 / 2; // by itself
        QVERIFY((world.body(good).massCenter - Vec2(1, fallen)).norm() < 1e-9);
    }

    void aFunctionOfTheUsersThatGivesNoNumberStopsNothingButItsBodies_data() {
        QTest::addColumn<double>("value");
        QTest::newRow("not a number") << notANumber;
        QTest::newRow("infinite") << std::numeric_limits<double>::infinity();
        QTest::newRow("as large as numbers get") << huge;
    }
    void aFunctionOfTheUsersThatGivesNoNumberStopsNothingButItsBodies() {
        QFETCH(double, value);
        World world = company(20);
        run(world, 0.1);
        World without = world;
        BodyDef def = ball({1000, 1000}, 0.2);
        const BodyId a = add(world, def);
        def.position.x() += 1;
        const BodyId b = add(world, def);
        static_cast<void>(
            world
                .addConnector({.a = a,
                               .b = b,
                               .length = 0.5,
                               .truncation = {TruncationRule::Custom, 0, 0, [value](double) { return value; }}})
                .value());
        for (int i = 0; i < 50; ++i) {
            world.update();
            without.update();
            for (const FaultEvent& event : world.events().faults) {
                QVERIFY(event.body == a || event.body == b);
            }
            for (const BodyId id : without.bodies()) {
                QVERIFY(isSameState(world.body(id), without.body(id)));
            }
            QVERIFY(isFinite(world.body(a).velocity) && isFinite(world.body(b).velocity));
        }
    }

    void aNumberThatIsNoneDoesNotPersist() {
        // A spin that cannot be is taken back, and the body may go on.
        World world(withIterations(20, {0, 0}));
        const BodyId id = add(world, box({0, 0}, 0.5, 0.5));
        QVERIFY(!world.applyAngularImpulse(id, notANumber));
        QVERIFY(!world.applyTorque(id, notANumber));
        world.update();
        QCOMPARE(world.body(id).angularVelocity, 0.0);
        QVERIFY(world.applyAngularImpulse(id, huge) && world.applyAngularImpulse(id, huge));
        world.update();
        QCOMPARE(world.events().faults.size(), std::size_t{1});
        QCOMPARE(world.body(id).angularVelocity, 0.0);
        world.setActive(id, true);
        world.setVelocity(id, {1, 0}, 2);
        run(world, 1);
        QVERIFY((world.body(id).massCenter - Vec2(1, 0)).norm() < 1e-9);
        QVERIFY(std::abs(world.body(id).angle - 2) < 1e-9);
    }
};

SPACETOW_TEST(FaultsTest)
#include "faults_test.moc"
