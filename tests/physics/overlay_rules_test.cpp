// Overlays and readings go by the rules of the engine: who collides with whom.
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

SPACETOW_TEST(OverlayRulesTest)
#include "overlay_rules_test.moc"
