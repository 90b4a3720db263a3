#include "core/physics/def/codes.h"
#include "tests/support/contact_scenes.h"
#include "tests/support/known_values.h"
#include "tests/support/rows.h"
#include "tests/support/sleepers.h"

using namespace spacetow;
using namespace spacetow::test;

namespace {

constexpr double instant = 1e-6; // s: too short for anything to move

BodyDef post(const Vec2& at) {
    BodyDef def = ball(at, 0.01);
    def.kind = BodyKind::Static;
    return def;
}

/// A body of 1 × 1 m on a connector to a static post; the connector's bodies are not set.
struct Moored {
    World world{{.gravity = {0, 0}, .seconds = instant, .iterations = 1, .substeps = 1}};
    BodyId id, postId;
    ConnectorId rope;

    Moored(double mass, double angle, const Vec2& postAt, ConnectorDef connector) {
        BodyDef def = box({0, 0}, 0.5, 0.5);
        def.mass = mass;
        def.angle = angle;
        id = add(world, def);
        postId = add(world, post(postAt));
        connector.a = id;
        connector.b = postId;
        rope = world.addConnector(connector).value();
    }
    BodyState moved() {
        world.update();
        return world.body(id);
    }
};

/// m/s² of a body that is pulled with 10 N.
double accelerationUnderTenNewtons(double mass) {
    return Moored(mass, 0, {2, 0}, {.length = 1, .stiffness = 10}).moved().velocity.x() / instant;
}

/// Angular acceleration of a body of 1 kg, turned by `angle`, that is pulled by 10 N at its local point (0.5, 0)
/// straight to the right.
double angularAccelerationAt(double angle) {
    const Vec2 anchor = Rot::fromAngle(angle) * Vec2(0.5, 0);
    Moored moored(1, angle, anchor + Vec2(2, 0), {.anchorA = {0.5, 0}, .length = 1, .stiffness = 10});
    return moored.moved().angularVelocity / instant;
}

/// N, of a connector of 1,000 N/m that is 1 m too long.
double tensionUnder(const Truncation& truncation) {
    Moored moored(1e9, 0, {2, 0}, {.length = 1, .stiffness = 1000, .truncation = truncation});
    moored.world.update();
    return moored.world.connector(moored.rope).tension;
}

double forceUnder(const Truncation& truncation) {
    return Moored(1, 0, {2, 0}, {.length = 1, .stiffness = 1000, .truncation = truncation}).moved().velocity.x() /
           instant;
}

/// Acceleration to the right of a body that flies at 3 m/s towards (or away from) the post on a slack rope of 2 m.
double slackPull(double distance, double speed) {
    Moored moored(1, 0, {distance, 0}, {.length = 2, .stiffness = 100, .damping = 50, .slack = true});
    moored.world.setVelocity(moored.id, {speed, 0}, 0);
    return (moored.moved().velocity.x() - speed) / instant;
}

struct Towing {
    double slow = 0, fast = 0, momentum = 0;
};

/// A body of 1 kg at −1 m/s drags one of 0.25 kg that was at rest, until both are equally fast.
Towing dragged() {
    World world({.gravity = {0, 0}});
    BodyDef def = ball({0, 0}, 0.1);
    def.mass = 1;
    def.velocity = {-1, 0};
    const BodyId a = add(world, def);
    def = ball({1, 0}, 0.1);
    def.mass = 0.25;
    const BodyId b = add(world, def);
    static_cast<void>(world.addConnector({.a = a, .b = b, .stiffness = 50, .damping = 5}).value());
    run(world, 20);
    const double va = world.body(a).velocity.x();
    const double vb = world.body(b).velocity.x();
    return {va, vb, va + 0.25 * vb};
}

void forceRows() {
    known("a pull of 10 N accelerates 0.25 kg by 40 m/s²: the mass divides once", accelerationUnderTenNewtons(0.25), 40,
          1e-6);
    known("a pull of 10 N accelerates 4 kg by 2.5 m/s²: the mass divides once", accelerationUnderTenNewtons(4), 2.5,
          1e-6);
    known("pulled along its anchor a body does not turn", angularAccelerationAt(0), 0, 1e-6);
    known("turned by 90°, the anchor is on top and the pull turns the body clockwise", angularAccelerationAt(pi / 2),
          -0.5 * 10 * 6, 1e-3);
    known("turned by −90°, the anchor is below and the pull turns the body anticlockwise",
          angularAccelerationAt(-pi / 2), 0.5 * 10 * 6, 1e-3);
    known("turned by 30°, the anchor's lever is half as long", angularAccelerationAt(pi / 6), -0.25 * 10 * 6, 1e-3);
    const Towing towing = dragged();
    known("a tow of 1 kg at −1 m/s and 0.25 kg at rest ends at −0.8 m/s", towing.slow, -0.8, 1e-9);
    known("what is towed ends as fast as what tows it", towing.fast, -0.8, 1e-9);
    known("a tow keeps its momentum of −1 N s", towing.momentum, -1, 1e-12);
}

void truncationRows() {
    const Truncation partial{TruncationRule::PartialTanh, 150, 0.75, {}};
    known("a partial tanh of 150 and 0.75 makes 119.9016 of 120, not 112.5", truncated(partial, 120),
          112.5 + 37.5 * std::tanh(0.2));
    known("a partial tanh is odd: it makes −119.9016 of −120", truncated(partial, -120),
          -112.5 - 37.5 * std::tanh(0.2));
    known("the tension is truncated, not the stretch: 1,000 N become 150 by a partial tanh", tensionUnder(partial), 150,
          1e-6);
    known("the truncated tension is what the body feels", forceUnder(partial), 150, 1e-3);
    known("without truncation 1,000 N stay what they are", tensionUnder({}), 1000, 1e-6);
    known("clamped at 150, 1,000 N become 150", tensionUnder({TruncationRule::Clamp, 150, 0.5, {}}), 150, 1e-6);
    known("tanh to 2,000 makes 2,000 tanh ½ of 1,000 N", tensionUnder({TruncationRule::Tanh, 2000, 0.5, {}}),
          2000 * std::tanh(0.5), 1e-6);
    known("truncated to zero, nothing is felt", forceUnder({TruncationRule::Zero, 150, 0.5, {}}), 0, 0);
    const auto root = [](double x) { return std::copysign(std::sqrt(std::abs(x)), x); };
    known("a function of the user's own is applied to the tension", tensionUnder({TruncationRule::Custom, 0, 0, root}),
          std::sqrt(1000.0), 1e-6);
    known("a function of the user's own decides what the body feels", forceUnder({TruncationRule::Custom, 0, 0, root}),
          std::sqrt(1000.0), 1e-3);
    known("a limit of minus zero is a limit of zero, clamped", forceUnder({TruncationRule::Clamp, -0.0, 0.5, {}}), 0,
          0);
    known("a limit of minus zero is a limit of zero, by tanh", forceUnder({TruncationRule::Tanh, -0.0, 0.5, {}}), 0, 0);
    known("a limit of minus zero is a limit of zero, by partial tanh",
          forceUnder({TruncationRule::PartialTanh, -0.0, 0.5, {}}), 0, 0);
}

void slackRows() {
    known("a slack rope that is too long pulls with its stretch and its damping", slackPull(2.5, -3), 50 + 150, 0.1);
    known("a slack rope that is too long does not push, however fast it shortens", slackPull(2.5, 3), 0, 0);
    known("a slack rope that is too short exerts nothing, damping included", slackPull(1.5, -3), 0, 0);
    known("a slack rope of exactly its length exerts nothing, damping included", slackPull(2, 3), 0, 0);
    Moored stiff(1, 0, {1.5, 0}, {.length = 2, .stiffness = 100});
    known("a rod that is too short pushes", stiff.moved().velocity.x() / instant, -50, 1e-3);
    Moored together(1, 0, {0, 0}, {.length = 0, .stiffness = 1000, .damping = 10});
    known("anchors on top of each other give no force and no division by zero", together.moved().velocity.norm(), 0, 0);
    Moored apart(1, 0, {0.5, 0}, {.length = 0, .stiffness = 1000});
    known("a rope of length zero pulls with stiffness times distance", apart.moved().velocity.x() / instant, 500, 1e-2);
}

} // namespace

class ConnectorRulesTest : public QObject {
    Q_OBJECT

  private slots:
    void everyNumberIsWhatItsSentenceSays_data() {
        knownValueColumns();
        forceRows();
        truncationRows();
        slackRows();
    }
    void everyNumberIsWhatItsSentenceSays() { checkKnownValue(); }

    void aConnectorToWhatIsNotThereIsRefused_data() {
        QTest::addColumn<bool>("asA");
        QTest::newRow("as the first body") << true;
        QTest::newRow("as the second body") << false;
    }
    void aConnectorToWhatIsNotThereIsRefused() {
        QFETCH(bool, asA);
        World world;
        World other;
        const BodyId here = add(world, ball({0, 0}, 0.1));
        add(other, ball({0, 0}, 0.1));
        const BodyId foreign = add(other, ball({1, 0}, 0.1));
        const BodyId removed = add(world, ball({1, 0}, 0.1));
        world.removeBody(removed);
        world.update();
        const BodyId successor = add(world, ball({2, 0}, 0.1));
        QCOMPARE(successor.index, removed.index);
        for (const BodyId absent : {BodyId{}, removed, BodyId{foreign.index + 1, foreign.generation}}) {
            const auto made =
                asA ? world.addConnector({.a = absent, .b = here}) : world.addConnector({.a = here, .b = absent});
            QVERIFY(!made);
            QCOMPARE(made.error().code.text(), std::string("no-such-body"));
            QCOMPARE(made.error().arguments.front(), std::string(asA ? "a" : "b"));
        }
        QCOMPARE(world.addConnector({.a = here, .b = here}).error().code.text(), std::string("same-body"));
        QVERIFY(world.connectors().empty());
    }

    void bodiesOnAConnectorDoNotCollideUnlessItSaysSo_data() {
        QTest::addColumn<bool>("first");
        QTest::addColumn<bool>("second");
        QTest::addColumn<bool>("collide");
        QTest::newRow("both let them collide") << true << true << true;
        QTest::newRow("one does not") << true << false << false;
        QTest::newRow("neither does") << false << false << false;
    }
    void bodiesOnAConnectorDoNotCollideUnlessItSaysSo() {
        QFETCH(bool, first);
        QFETCH(bool, second);
        QFETCH(bool, collide);
        World world({.gravity = {0, 0}});
        const BodyId a = add(world, ball({0, 0}, 0.2));
        const BodyId b = add(world, box({0.3, 0}, 0.2, 0.2));
        ConnectorDef rope{.a = a, .b = b, .stiffness = 0, .bodiesCollide = first};
        const ConnectorId one = world.addConnector(rope).value();
        rope.bodiesCollide = second;
        const ConnectorId two = world.addConnector(rope).value();
        world.update();
        QCOMPARE(!world.events().began.empty(), collide);
        QCOMPARE(world.body(a).massCenter.x() < 0, collide);
        world.removeConnector(first ? two : one);
        run(world, 0.1);
        QCOMPARE(world.body(a).massCenter.x() < 0, first || second); // what is left decides
        world.removeConnector(first ? one : two);
        run(world, 0.1);
        QVERIFY(world.body(a).massCenter.x() < 0);
    }

    void aChangedConnectorPullsAsOneThatWasMadeSo() {
        const ConnectorDef soft{.length = 1, .stiffness = 10};
        const ConnectorDef stiff{.anchorA = {0.5, 0},
                                 .length = 0.5,
                                 .stiffness = 70,
                                 .damping = 2,
                                 .slack = true,
                                 .bodiesCollide = true,
                                 .truncation = {TruncationRule::Clamp, 20, 0.5, {}}};
        Moored changed(2, 0.1, {2, 0}, soft);
        Moored made(2, 0.1, {2, 0}, stiff);
        ConnectorDef def = stiff;
        def.a = changed.id;
        def.b = changed.postId;
        QVERIFY(changed.world.setConnector(changed.rope, def).value());
        QCOMPARE(changed.world.hash(), made.world.hash());
        for (int i = 0; i < 100; ++i) {
            changed.world.update({.gravity = {0, 0}, .iterations = 4});
            made.world.update({.gravity = {0, 0}, .iterations = 4});
            QCOMPARE(changed.world.hash(), made.world.hash());
        }
        QVERIFY(changed.world.contains(changed.rope));
        const std::uint64_t before = changed.world.hash();
        QVERIFY(!changed.world.setConnector(changed.rope, def).value()); // nothing is new
        QCOMPARE(changed.world.hash(), before);
    }

    void aChangedConnectorMayHaveOtherEndsAndLetThemCollide() {
        World world({.gravity = {0, 0}, .iterations = 4});
        std::vector<BodyId> ids;
        for (const double x : {0.0, 0.5, 5.0}) {
            ids.push_back(add(world, ball({x, 0}, 0.3))); // the first two overlap
        }
        ConnectorDef def{.a = ids[0], .b = ids[1], .stiffness = 0};
        const ConnectorId rope = world.addConnector(def).value();
        runUpdates(world, 5);
        QVERIFY(world.events().began.empty() && world.body(ids[1]).massCenter == Vec2(0.5, 0));
        def.b = ids[2];
        QVERIFY(world.setConnector(rope, def).value());
        QCOMPARE(world.connector(rope).length, 5.0); // measured again
        QCOMPARE(world.connector(rope).b, ids[2]);
        world.update();
        QCOMPARE(world.events().began.size(), std::size_t(1));
        runUpdates(world, 50);
        QVERIFY(world.body(ids[1]).massCenter.x() > 0.5); // pushed out
        world.removeBody(ids[2]);
        world.update();
        QVERIFY(!world.contains(rope));
    }

    void aConnectorThatCannotBeChangedSoStaysAsItWas() {
        Moored moored(2, 0.1, {2, 0}, {.length = 1, .stiffness = 10});
        const std::uint64_t before = moored.world.hash();
        const ConnectorDef good{.a = moored.id, .b = moored.postId};
        const auto refused = [&](const Error& error, auto change) {
            ConnectorDef def = good;
            change(def);
            const Result<bool> changed = moored.world.setConnector(moored.rope, def);
            return !changed && changed.error() == error && moored.world.hash() == before;
        };
        QVERIFY(refused({PhysicsCode("no-such-body"), {"b"}}, [](ConnectorDef& d) { d.b = BodyId{}; }));
        QVERIFY(refused({PhysicsCode("same-body"), {}}, [](ConnectorDef& d) { d.b = d.a; }));
        QVERIFY(
            refused({PhysicsCode("not-finite"), {"stiffness"}}, [](ConnectorDef& d) { d.stiffness = std::nan(""); }));
        QVERIFY(refused({PhysicsCode("out-of-range"), {"length"}}, [](ConnectorDef& d) { d.length = -1; }));
    }

    void connectorsAreListedInTheOrderInWhichTheyWereAdded() {
        World world;
        const BodyId a = add(world, ball({0, 0}, 0.1));
        const BodyId b = add(world, ball({1, 0}, 0.1));
        std::vector<ConnectorId> expected;
        for (int i = 0; i < 4; ++i) {
            expected.push_back(world.addConnector({.a = a, .b = b}).value());
        }
        for (const std::size_t removed : {2, 0}) { // their places are taken by the next two
            world.removeConnector(expected[removed]);
            expected.erase(expected.begin() + static_cast<std::ptrdiff_t>(removed));
        }
        for (int i = 0; i < 3; ++i) {
            expected.push_back(world.addConnector({.a = b, .b = a}).value());
        }
        QVERIFY(world.connectors() == expected);
        const World copy = world;
        QVERIFY(copy.connectors() == expected);
    }

    void whatLosesItsOtherEndFliesOn_data() {
        QTest::addColumn<bool>("remove");
        QTest::newRow("removed") << true;
        QTest::newRow("switched off") << false;
    }
    void whatLosesItsOtherEndFliesOn() {
        QFETCH(bool, remove);
        World world({.gravity = {0, 0}});
        BodyDef def = ball({0, 0}, 0.1);
        def.velocity = {0, 2};
        const BodyId a = add(world, def);
        const BodyId b = add(world, ball({1, 0}, 0.1));
        const ConnectorId rope = world.addConnector({.a = a, .b = b, .stiffness = 100, .damping = 1}).value();
        run(world, 0.5);
        remove ? world.removeBody(b) : world.setActive(b, false);
        const BodyState before = world.body(a);
        run(world, 1);
        QCOMPARE(world.body(a).velocity, before.velocity);
        QVERIFY((world.body(a).massCenter - before.massCenter - before.velocity).norm() < 1e-9);
        QCOMPARE(world.contains(rope), !remove);
        if (!remove) { // pulls again as soon as both ends are there
            world.setActive(b, true);
            run(world, 0.1);
            QVERIFY(world.body(a).velocity != before.velocity);
        }
    }
};

SPACETOW_TEST(ConnectorRulesTest)
#include "connector_rules_test.moc"
