#include "tests/support/contact_scenes.h"
#include "tests/support/seed_text.h"

#include "core/base/random.h"
#include "core/physics/query/why_apart.h"

#include <map>

using namespace spacetow;
using namespace spacetow::test;

namespace {

std::vector<Shape> thingOf(Random& random) {
    const double size = random.uniform(0.2, 0.8);
    switch (random.below(5)) {
    case 0:
        return {Edge{{-size, 0}, {size, random.uniform(-0.3, 0.3)}, random.below(2) == 0 ? noBack : 0.1}};
    case 1:
        return {Line{{-size, 0}, {size, 0}}};
    case 2:
        return {Polygon{regularPolygon(3 + static_cast<int>(random.below(5)), size)}};
    default:
        return {Circle{{0, 0}, size}};
    }
}

/// Many kinds of bodies in little room, most of which may not touch some of the others.
World crowdedWorld(Random& random) {
    World world(withIterations(static_cast<int>(1 + random.below(6)), {0, random.uniform(-9, 0)}));
    std::vector<BodyId> all;
    for (int i = 0; i < 10; ++i) {
        BodyDef def{.shapes = thingOf(random)};
        const double x = random.uniform(-2, 2);
        def.position = {x, random.uniform(-2, 2)};
        def.kind = random.below(2) == 0 ? BodyKind::Dynamic : static_cast<BodyKind>(random.below(3));
        def.angle = random.uniform(-3, 3);
        if (def.kind != BodyKind::Static) {
            def.velocity = {random.uniform(-3, 3), 0};
        }
        def.restitution = random.below(2) == 0 ? 0 : 0.5;
        def.active = random.below(10) != 0;
        def.tangible = random.below(5) != 0;
        def.filter = {{1 + random.below(7)}, {random.below(4) == 0 ? random.below(8) : 7}};
        all.push_back(add(world, def));
    }
    for (int i = 0; i < 2; ++i) {
        const BodyId a = all[random.below(5)];
        world.addConnector({.a = a, .b = all[5 + random.below(5)], .bodiesCollide = random.below(2) == 0}).value();
    }
    return world;
}

/// Two bodies, where they are as they were made.
struct Two {
    World world{withIterations(4, {0, 0})};
    BodyId a, b;

    Two(const BodyDef& first, const BodyDef& second) : a(add(world, first)), b(add(world, second)) {}
    CollisionAnswer answer() const { return whyNotColliding(world, a, b); }
};

} // namespace

class WhyApartTest : public QObject {
    Q_OBJECT

  private slots:
    // By the events, which are another account of the same: when the engine has two in contact the answer is "touch",
    // and otherwise never.
    void theyTouchWhenTheEngineSaysSo() {
        std::map<WhyApart, int> seen;
        for (std::uint64_t seed = 1; seed <= usualOrThin<std::uint64_t>(150, 20); ++seed) {
            Random random(seed);
            World world = crowdedWorld(random);
            std::map<std::pair<BodyId, BodyId>, int> touching;
            for (int update = 0; update < 8; ++update) {
                world.update();
                for (const TouchEvent& began : world.events().began) {
                    ++touching[{began.a, began.b}];
                }
                for (const TouchEvent& ended : world.events().ended) {
                    --touching[{ended.a, ended.b}];
                }
                const std::vector<BodyId> bodies = world.bodies();
                for (std::size_t i = 0; i < bodies.size(); ++i) {
                    for (std::size_t j = i + 1; j < bodies.size(); ++j) {
                        const CollisionAnswer answer = whyNotColliding(world, bodies[i], bodies[j]);
                        const bool solid = world.body(bodies[i]).tangible && world.body(bodies[j]).tangible;
                        const bool touches = touching[{bodies[i], bodies[j]}] > 0;
                        QVERIFY2((answer.why == WhyApart::Touch) == (touches && solid), seedText(seed));
                        QVERIFY2(whyNotColliding(world, bodies[j], bodies[i]).why == answer.why, seedText(seed));
                        if (answer.why == WhyApart::Intangible) {
                            QVERIFY2(!touches || answer.sensed, seedText(seed));
                        } else if (answer.why != WhyApart::Touch) {
                            QVERIFY2(!touches, seedText(seed));
                        }
                        ++seen[answer.why];
                    }
                }
            }
        }
        for (const WhyApart why :
             {WhyApart::Touch, WhyApart::Inactive, WhyApart::Unmovable, WhyApart::Mask, WhyApart::Connected,
              WhyApart::Intangible, WhyApart::Walls, WhyApart::Behind, WhyApart::Distance}) {
            QVERIFY2(isThinRun() || seen[why] > 0, QByteArray::number(static_cast<int>(why)));
        }
    }

    void sleepersTouchWhatTheySleepOn() {
        World world(withIterations(4));
        world.setSleeping(true);
        const BodyId floor = add(world, edgeBody({-5, 0}, {5, 0}));
        const BodyId lower = add(world, box({0, 0.2}, 0.2, 0.2));
        const BodyId upper = add(world, box({0, 0.6}, 0.2, 0.2));
        run(world, 3);
        QVERIFY(world.body(lower).asleep && world.body(upper).asleep);
        QCOMPARE(whyNotColliding(world, floor, lower).why, WhyApart::Touch);
        QCOMPARE(whyNotColliding(world, lower, upper).why, WhyApart::Touch);
        QCOMPARE(whyNotColliding(world, floor, upper).why, WhyApart::Distance);
    }

    void aDistanceIsThatBetweenTheSurfaces() {
        Two two(ball({0, 0}, 0.5), box({3, 0}, 1, 1));
        const CollisionAnswer answer = two.answer();
        QCOMPARE(answer.why, WhyApart::Distance);
        QVERIFY(std::abs(answer.distance - 1.5) < 1e-12);
        QVERIFY((answer.from - Vec2(0.5, 0)).norm() < 1e-12);
        QVERIFY((answer.to - Vec2(2, 0)).norm() < 1e-12);
    }

    void aMaskSaysWhoseItIsAndWhatIsMissing() {
        BodyDef first = ball({0, 0}, 0.5);
        BodyDef second = ball({0.2, 0}, 0.5);
        first.filter = {{1}, {1}};
        second.filter = {{6}, {5}};
        Two two(first, second);
        CollisionAnswer answer = two.answer();
        QCOMPARE(answer.why, WhyApart::Mask);
        QCOMPARE(answer.body, two.a);
        QCOMPARE(answer.missing.bits, 6U);
        QVERIFY(!answer.bothMasks);
        two.world.setFilter(two.a, {{1}, {3}});
        QCOMPARE(two.answer().why, WhyApart::NextUpdate);
        two.world.update();
        QCOMPARE(two.answer().why, WhyApart::Touch);
        two.world.setFilter(two.a, {{2}, {0}});
        two.world.update();
        answer = two.answer();
        QCOMPARE(answer.why, WhyApart::Mask);
        QVERIFY(answer.bothMasks);
    }

    void aConnectorThatKeepsThemApartIsNamed() {
        Two two(ball({0, 0}, 0.5), ball({0.2, 0}, 0.5));
        const ConnectorId one = two.world.addConnector({.a = two.a, .b = two.b}).value();
        two.world.addConnector({.a = two.b, .b = two.a, .bodiesCollide = true}).value();
        const CollisionAnswer answer = two.answer();
        QCOMPARE(answer.why, WhyApart::Connected);
        QVERIFY(answer.connectors == std::vector<ConnectorId>{one});
    }

    void theBackOfAWallIsNamed() {
        BodyDef wall;
        wall.kind = BodyKind::Static;
        wall.shapes = {Edge{{-3, 0}, {-1, 0}, 0}, Edge{{-1, 0}, {1, 0}, 0}};
        BodyDef body = ball({0, -0.3}, 0.5);
        Two two(body, wall);
        two.world.update();
        const CollisionAnswer answer = two.answer();
        QCOMPARE(answer.why, WhyApart::Behind);
        QCOMPARE(answer.body, two.b);
        QVERIFY((answer.from - Vec2(-1, 0)).norm() < 1e-12 && (answer.to - Vec2(1, 0)).norm() < 1e-12);
    }

    void whatIsOnItsWayThroughAOneWayWallFromBehindIsToldSo() {
        BodyDef wall{.kind = BodyKind::Static};
        wall.position = {0.5, 1};
        wall.shapes = {Edge{{-3, 0}, {3, 0}, 0.2}};
        for (const char* const what : {"ball", "box", "ship"}) {
            BodyDef body = dropped(what, {0, 0});
            body.velocity = {0, 1};
            Two two(body, wall);
            int passing = 0;
            while (two.world.body(two.a).pose.position.y() < 2) {
                two.world.update();
                const CollisionAnswer answer = two.answer();
                QVERIFY2(answer.why == WhyApart::Passing || answer.why == WhyApart::Behind ||
                             answer.why == WhyApart::Distance,
                         what);
                if (answer.why == WhyApart::Passing) {
                    QCOMPARE(answer.body, two.b);
                    QVERIFY((answer.from - Vec2(-2.5, 1)).norm() < 1e-12);
                    QVERIFY((answer.to - Vec2(3.5, 1)).norm() < 1e-12);
                    ++passing;
                }
            }
            QVERIFY2(passing > 10, what);
            QCOMPARE(two.answer().why, WhyApart::Distance);
        }
    }

    void othersAreNamedByWhatTheyAre() {
        BodyDef fixed = ball({0, 0}, 0.5);
        fixed.kind = BodyKind::Static;
        QCOMPARE(Two(fixed, fixed).answer().why, WhyApart::Unmovable);
        BodyDef off = ball({0, 0}, 0.5);
        off.active = false;
        const Two inactive(fixed, off);
        QCOMPARE(inactive.answer().why, WhyApart::Inactive);
        QCOMPARE(inactive.answer().body, inactive.b);
        BodyDef ghost = ball({0, 0}, 0.5);
        ghost.tangible = false;
        Two sensed(fixed, ghost);
        QCOMPARE(sensed.answer().why, WhyApart::Intangible);
        QVERIFY(!sensed.answer().sensed);
        sensed.world.update();
        QVERIFY(sensed.answer().sensed);
        QCOMPARE(sensed.answer().body, sensed.b);
        QCOMPARE(whyNotColliding(sensed.world, sensed.a, sensed.a).why, WhyApart::SameBody);
    }
};

SPACETOW_TEST(WhyApartTest)
#include "why_apart_test.moc"
