// Overlays and readings go by the rules of the engine: who collides with whom, and with what of a wall.
#include "core/physics/query/contact_manifolds.h"
#include "core/physics/query/explain.h"
#include "tests/support/contact_scenes.h"
#include "tests/support/recording_draw.h"

using namespace spacetow;
using namespace spacetow::test;

namespace {

DebugView collisionView() {
    DebugView view;
    view.view = {.center = {0, 0}, .scale = 100, .size = {800, 600}};
    view.shapes = false;
    view.overlays = {.collides = true};
    return view;
}

} // namespace

class OverlayRulesTest : public QObject {
    Q_OBJECT

  private slots:
    void twoKinematicBodiesPassEachOther();
    void whatPassesAOneWayWallTouchesItsEndsAlone();
};

void OverlayRulesTest::twoKinematicBodiesPassEachOther() {
    World world;
    for (const BodyKind kind : {BodyKind::Kinematic, BodyKind::Kinematic, BodyKind::Static, BodyKind::Dynamic}) {
        BodyDef def = ball({static_cast<double>(world.bodyCount()) - 2, 0}, 0.25);
        def.kind = kind;
        def.user = static_cast<std::uint64_t>(world.bodyCount());
        add(world, def);
    }
    world.update();
    DebugView view = collisionView();
    view.isSelected = [](std::uint64_t user) { return user == 0; };
    const std::vector<DrawCall> calls = recorded(world, view);
    QCOMPARE(calls.size(), std::size_t{3});
    QVERIFY(calls[0].color == view.colors.passes);
    QVERIFY(calls[1].color == view.colors.passes);
    QVERIFY(calls[2].color == view.colors.meets);
}

void OverlayRulesTest::whatPassesAOneWayWallTouchesItsEndsAlone() {
    const Vec2 end(1, 0);
    World world(withIterations(20, {0, 0}));
    const BodyId wall = add(world, {.kind = BodyKind::Static, .shapes = {Edge{{-1, 0}, end, 0.5}}});
    BodyDef def = ball({0.9, -0.8}, 0.3);
    def.velocity = {0, 2};
    const BodyId passing = add(world, def);
    int seen = 0;
    for (int i = 0; i < 20; ++i) {
        world.update();
        const Vec2 towards = (end - world.body(passing).massCenter).normalized();
        for (const ContactManifold& contact : contactManifolds(world)) {
            QVERIFY(contact.a == passing && contact.b == wall);
            QVERIFY(contact.count == 1 && contact.normal.dot(towards) > 0.999);
            ++seen;
        }
        for (const ContactReading& contact : contactsOf(world, passing)) {
            const Vec2 fromBall = contact.a == passing ? contact.normal : Vec2(-contact.normal);
            QVERIFY(fromBall.dot(towards) > 0.999);
            ++seen;
        }
    }
    QVERIFY(seen > 0);
}

SPACETOW_TEST(OverlayRulesTest)
#include "overlay_rules_test.moc"
