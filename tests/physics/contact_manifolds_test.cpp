// What the contacts of a world tell: of bodies that are awake, and of sleepers.
#include "core/physics/query/contact_manifolds.h"

#include "tests/support/contact_scenes.h"
#include "tests/support/recording_draw.h"

using namespace spacetow;
using namespace spacetow::test;

namespace {

constexpr double weightOfAKilogram = 9.81; // N

World withRough(const Vec2& gravity, const BodyDef& def) {
    World world(withIterations(10, gravity));
    for (BodyDef each : {edgeBody({-5, 0}, {5, 0}), def}) {
        each.friction = 1;
        add(world, each);
    }
    run(world, 2);
    return world;
}

/// Of all contacts, on the upper body.
Vec2 newtonsOn(const World& world) {
    Vec2 sum(0, 0);
    for (const ContactManifold& contact : contactManifolds(world)) {
        const double sense = contact.b == world.bodies().back() ? 1 : -1;
        for (int i = 0; i < contact.count; ++i) {
            sum += sense * contact.points[static_cast<std::size_t>(i)].normalImpulse * contact.normal;
        }
        sum += sense * contact.tangentImpulse * leftOf(contact.normal);
    }
    return sum * world.parameters().iterations / world.parameters().seconds;
}

} // namespace

class ContactManifoldsTest : public QObject {
    Q_OBJECT

  private slots:
    void impulsesBearTheWeightOnASlope_data() {
        QTest::addColumn<QString>("what");
        QTest::newRow("a box, whose manifold is kept") << "box";
        QTest::newRow("a hexagon") << "hexagon";
    }
    void impulsesBearTheWeightOnASlope() {
        QFETCH(QString, what);
        BodyDef def = dropped(what, {0, 0.23});
        def.angle = what == "hexagon" ? pi / 6 : 0; // with a face down, or it would roll
        def.mass = 3;
        const Vec2 gravity = weightOfAKilogram * Vec2(std::sin(0.3), -std::cos(0.3));
        const World world = withRough(gravity, def);
        QVERIFY2((newtonsOn(world) + 3 * gravity).norm() < 0.3,
                 qPrintable(QString("%1, %2 N").arg(newtonsOn(world).x()).arg(newtonsOn(world).y())));
    }

    void frictionHasAnArrowToo() {
        const World world = withRough(weightOfAKilogram * Vec2(std::sin(0.3), -std::cos(0.3)), box({0, 0.5}, 0.5, 0.5));
        DebugView view;
        view.view = {.center = {0, 0}, .scale = 100, .size = {800, 600}};
        view.shapes = false;
        view.overlays = {.contacts = true};
        Vec2 sum(0, 0);
        for (const DrawCall& call : recorded(world, view)) {
            if (call.form == Form::Line && call.color == view.colors.impulse) {
                sum += (call.points[1] - call.points[0]) / view.view.scale;
            }
        }
        const Vec2 weight(std::sin(0.3), std::cos(0.3)); // on the floor, in the picture, where y points down
        QVERIFY2((sum - weight).norm() < 0.02, qPrintable(QString("%1, %2").arg(sum.x()).arg(sum.y())));
    }

    void sleepersTellWhatBearsThem() {
        World world = withRough({0, -weightOfAKilogram}, box({0, 0.5}, 0.5, 0.5));
        const BodyId id = world.bodies().back();
        const std::size_t awake = contactManifolds(world).size();
        QCOMPARE(awake, std::size_t{1});
        world.setSleeping(true);
        run(world, 2);
        QVERIFY(world.body(id).asleep);
        QCOMPARE(contactManifolds(world).size(), awake);
        QVERIFY(contactManifolds(world).front().touching);
        const double weight = weightOfAKilogram * world.body(id).mass;
        QVERIFY((newtonsOn(world) - Vec2(0, weight)).norm() < 0.02 * weight);
        QCOMPARE(contactManifolds(world, Aabb{{-1, -1}, {1, 1}}).size(), awake);
        QVERIFY(contactManifolds(world, Aabb{{2, -1}, {3, 1}}).empty());
    }
};

SPACETOW_TEST(ContactManifoldsTest)
#include "contact_manifolds_test.moc"
