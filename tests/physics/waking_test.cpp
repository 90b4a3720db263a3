// Sleepers wake, as a whole island and nobody else, for every reason there is.

#include "core/base/contract.h"
#include "core/base/random.h"
#include "core/physics/world/world.h"
#include "tests/support/rows.h"
#include "tests/support/sleepers.h"
#include "tests/support/test_main.h"

#include <functional>

using namespace spacetow;
using namespace spacetow::test;

namespace {

/// Two boxes on one another on a kinematic platform, beside them one on a static floor; far away one more on the floor.
struct Sleepers {
    World world = sleepyWorld();
    BodyId floor, block, platform, lower, upper, beside, far;

    Sleepers() {
        floor = add(world, edgeBody({-20, 0}, {20, 0}));
        BodyDef def = box({0, 0.25}, 1, 0.25);
        def.kind = BodyKind::Kinematic;
        platform = add(world, def);
        lower = add(world, box({0, 0.6}, 0.1, 0.1));
        upper = add(world, box({0, 0.8}, 0.1, 0.1));
        def = box({5, 0.25}, 1, 0.25);
        def.kind = BodyKind::Static;
        block = add(world, def);
        beside = add(world, box({5, 0.6}, 0.1, 0.1));
        far = add(world, box({15, 0.1}, 0.1, 0.1));
        EXPECTS(runUntilAsleep(world, 5));
    }

    bool sleeps(BodyId id) const { return world.body(id).asleep; }
};

struct Reason {
    const char* name;
    std::function<void(Sleepers&)> act;
    int updates = 1;                                      // until it shows
    bool stack = false, beside = false, platform = false; // who wakes
};

const std::vector<Reason>& reasons() {
    static const std::vector<Reason> all = {
        {"nothing", [](Sleepers&) {}, 100},
        {"a force of zero",
         [](Sleepers& s) {
             s.world.applyForce(s.upper, {0, 0});
         },
         10},
        {"a force",
         [](Sleepers& s) {
             s.world.applyForce(s.upper, {0.01, 0});
         },
         1, true},
        {"a torque", [](Sleepers& s) { s.world.applyTorque(s.lower, 0.01); }, 1, true},
        {"an impulse",
         [](Sleepers& s) {
             s.world.applyImpulseAt(s.upper, {0.01, 0}, {0, 0.8});
         },
         1, true},
        {"an angular impulse", [](Sleepers& s) { s.world.applyAngularImpulse(s.lower, 0.001); }, 1, true},
        {"setVelocity",
         [](Sleepers& s) {
             s.world.setVelocity(s.lower, {0, 1}, 0);
         },
         1, true},
        {"setPose",
         [](Sleepers& s) {
             s.world.setPose(s.upper, {3, 3}, 1);
         },
         1, true},
        {"setFilter", [](Sleepers& s) { s.world.setFilter(s.lower, {}); }, 1, true},
        {"setMaterial", [](Sleepers& s) { EXPECTS(s.world.setMaterial(s.upper, {.friction = 0.4}).value()); }, 1, true},
        {"setMaterial with what it was", [](Sleepers& s) { EXPECTS(!s.world.setMaterial(s.upper, {}).value()); }, 10},
        {"another friction of the static body below",
         [](Sleepers& s) { EXPECTS(s.world.setMaterial(s.block, {.friction = 0.4}).value()); }, 1, false, true},
        {"setTangible", [](Sleepers& s) { s.world.setTangible(s.lower, false); }, 1, true},
        {"setFrozen", [](Sleepers& s) { s.world.setFrozen(s.upper, true); }, 1, true},
        {"setActive", [](Sleepers& s) { s.world.setActive(s.upper, false); }, 1, true},
        {"removal of a body", [](Sleepers& s) { s.world.removeBody(s.upper); }, 1, true},
        {"a new connector", [](Sleepers& s) { EXPECTS(bool(s.world.addConnector({.a = s.lower, .b = s.floor}))); }, 1,
         true},
        {"a connector of two islands",
         [](Sleepers& s) { EXPECTS(bool(s.world.addConnector({.a = s.lower, .b = s.beside}))); }, 1, true, true},
        {"removal of the static body below", [](Sleepers& s) { s.world.removeBody(s.block); }, 1, false, true},
        {"switching off the static body below", [](Sleepers& s) { s.world.setActive(s.block, false); }, 1, false, true},
        {"a static body below made intangible", [](Sleepers& s) { s.world.setTangible(s.block, false); }, 1, false,
         true},
        {"another filter of the static body below",
         [](Sleepers& s) { s.world.setFilter(s.block, {.tags = TagMask::bit(4)}); }, 1, false, true},
        {"the static body below moves away",
         [](Sleepers& s) {
             s.world.setPose(s.block, {8, 0}, 0);
         },
         1, false, true},
        {"a static body moves near",
         [](Sleepers& s) {
             s.world.setPose(s.block, {0, 0.7}, 0);
         },
         1, true, true, true},
        {"a new static body near",
         [](Sleepers& s) {
             BodyDef def = box({5, 0.81}, 0.1, 0.1);
             def.kind = BodyKind::Static;
             add(s.world, def);
         },
         1, false, true},
        {"a new static body far away",
         [](Sleepers& s) {
             add(s.world, lineBody({-5, 9}, {5, 9}));
         },
         10},
        {"the platform starts to move",
         [](Sleepers& s) {
             s.world.setVelocity(s.platform, {0.001, 0}, 0);
         },
         1, true, false, true},
        {"the platform is set elsewhere",
         [](Sleepers& s) {
             s.world.setPose(s.platform, {0, 0.2}, 0);
         },
         1, true, false, true},
        {"the platform is removed", [](Sleepers& s) { s.world.removeBody(s.platform); }, 1, true, false, true},
        {"a body falls on them",
         [](Sleepers& s) {
             add(s.world, ball({0, 1.3}, 0.1));
         },
         30, true},
        {"a body falls down far away",
         [](Sleepers& s) {
             add(s.world, ball({10, 1.5}, 0.1));
         },
         100},
        {"a bullet",
         [](Sleepers& s) {
             BodyDef def = ball({-10, 0.8}, 0.02);
             def.velocity = {300, 0};
             add(s.world, def);
         },
         3, true},
        {"a kinematic body comes along",
         [](Sleepers& s) {
             BodyDef def = ball({-0.5, 0.8}, 0.1);
             def.kind = BodyKind::Kinematic;
             def.velocity = {1, 0};
             add(s.world, def);
         },
         30, true},
        {"an intangible body comes along",
         [](Sleepers& s) {
             BodyDef def = ball({0, 1.2}, 0.1);
             def.tangible = false;
             add(s.world, def);
         },
         50},
        {"gravity changes for one update",
         [](Sleepers& s) {
             s.world.update({.gravity = {0, -9}, .iterations = 20});
         },
         0, true, true, true},
        {"sleep is forbidden", [](Sleepers& s) { s.world.setSleeping(false); }, 1, true, true, true},
    };
    return all;
}

} // namespace

class WakingTest : public QObject {
    Q_OBJECT

  private slots:
    void anIslandWakesAsAWholeAndForEveryReason_data() {
        QTest::addColumn<int>("index");
        for (std::size_t i = 0; i < reasons().size(); ++i) {
            QTest::newRow(reasons()[i].name) << static_cast<int>(i);
        }
    }
    void anIslandWakesAsAWholeAndForEveryReason() {
        QFETCH(int, index);
        const Reason& reason = reasons()[static_cast<std::size_t>(index)];
        Sleepers s;
        reason.act(s);
        bool stack = !s.sleeps(s.lower);
        bool beside = !s.sleeps(s.beside);
        bool platform = !s.sleeps(s.platform);
        const bool far = reason.stack && reason.beside && reason.platform;
        for (int i = 0; i < reason.updates; ++i) {
            s.world.update();
            stack |= !s.sleeps(s.lower);
            beside |= !s.sleeps(s.beside);
            platform |= s.world.contains(s.platform) ? !s.sleeps(s.platform) : true;
            if (s.world.contains(s.upper) && s.world.body(s.upper).active) {
                QCOMPARE(s.sleeps(s.upper), s.sleeps(s.lower));
            }
            if (!far) {
                QVERIFY(s.sleeps(s.far));
            }
        }
        QCOMPARE(stack, reason.stack);
        QCOMPARE(beside, reason.beside);
        QCOMPARE(platform, reason.platform);
    }

    void aBodyFallsWhenWhatItSleptOnGoes() {
        Sleepers s;
        s.world.removeBody(s.block);
        s.world.removeBody(s.platform);
        runUpdates(s.world, 100);
        QVERIFY(std::abs(s.world.body(s.beside).massCenter.y() - 0.1) < 0.01);
        QVERIFY(std::abs(s.world.body(s.lower).massCenter.y() - 0.1) < 0.01);
    }

    void worldsThatAreChangedAtRandomWhileTheySleepStaySound() {
        const std::uint64_t seed = 77;
        Random random(seed);
        for (int round = 0; round < fullOrQuick(200, 10); ++round) {
            World world = sleepyWorld(4);
            std::vector<BodyId> walls = {add(world, edgeBody({-3, 0}, {3, 0})), add(world, lineBody({-3, 0}, {-3, 9})),
                                         add(world, lineBody({3, 0}, {3, 9}))};
            std::vector<BodyId> bodies;
            for (int i = 0; i < 25; ++i) {
                const Vec2 at(-2 + i % 5, 0.5 + i / 5);
                bodies.push_back(add(world, i % 2 == 0 ? ball(at, 0.2) : box(at, 0.2, 0.15)));
            }
            for (int i = 0; i < 400; ++i) {
                world.update();
                if (i < 100 || random.below(20) != 0) {
                    continue;
                }
                const BodyId id = bodies[random.below(static_cast<std::uint32_t>(bodies.size()))];
                switch (random.below(8)) {
                case 0:
                    world.applyImpulseAt(id, {0.1, 0.1}, world.body(id).massCenter);
                    break;
                case 1:
                    world.removeBody(id);
                    std::erase(bodies, id);
                    break;
                case 2:
                    bodies.push_back(add(world, ball({random.uniform(-2, 2), 6}, 0.2)));
                    break;
                case 3:
                    world.setActive(id, !world.body(id).active);
                    break;
                case 4:
                    world.setFrozen(id, !world.body(id).positionFrozen);
                    break;
                case 5:
                    world.setPose(walls[1], {random.uniform(-0.05, 0.05), 0}, 0);
                    break;
                case 6:
                    world.setPose(id, {random.uniform(-2, 2), 7}, 0);
                    break;
                default:
                    walls.push_back(add(world, lineBody({-0.5, 8}, {0.5, 8})));
                }
            }
            for (const BodyId id : bodies) {
                const BodyState state = world.body(id);
                const Vec2 at = state.massCenter;
                QVERIFY2(!state.active || (at.y() > 0.05 && std::abs(at.x()) < 3.05),
                         seedText(seed) + " round " + QByteArray::number(round));
                QVERIFY(!state.asleep || state.velocity == Vec2(0, 0));
            }
        }
    }
};

SPACETOW_TEST(WakingTest)
#include "waking_test.moc"
