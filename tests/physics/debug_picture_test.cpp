#include "tests/support/contact_scenes.h"
#include "tests/support/recording_draw.h"

using namespace spacetow;
using namespace spacetow::test;

namespace {

/// One body of each kind with several shapes, joined by a connector, in motion and in touch.
World busyWorld() {
    World world(withIterations(4));
    const BodyId ball = add(world, {.shapes = {Circle{{0, 0}, 0.3}, Circle{{0.5, 0}, 0.2}}, .position = {0, 1}});
    BodyDef lift = box({3, 1}, 0.5, 0.1);
    lift.kind = BodyKind::Kinematic;
    lift.velocity = {0, 0.2};
    const BodyId platform = add(world, lift);
    add(world, edgeBody({-5, 0}, {5, 0}));
    BodyDef ship = dropped("ship", {-1, 0.4});
    ship.angle = 0.7;
    add(world, ship);
    (void)world.addConnector({.a = ball, .b = platform, .anchorA = {0.1, 0.2}, .length = 2});
    run(world, 0.5);
    return world;
}

} // namespace

class DebugPictureTest : public QObject {
    Q_OBJECT

  private slots:
    void eachSwitchHidesOneThing_data();
    void eachSwitchHidesOneThing();
    void theSamePictureComesOutEveryTime();
    void aCopyIsDrawnAsItWasWhileTheWorldGoesOn();
    void aStaticBodyThatWasPutElsewhereIsDrawnThere();
    void theBoxIsExactAndTheFatOneThatOfTheBroadPhase();
    void circlesStayRoundInEveryWindow_data();
    void circlesStayRoundInEveryWindow();
    void theHostMayGiveVelocitiesAndNormalsAHead();
    void theBackgroundComesFirstAndCoversThePicture();
};

void DebugPictureTest::eachSwitchHidesOneThing_data() {
    QTest::addColumn<int>("which");
    QTest::addColumn<int>("least");
    QTest::newRow("boxes") << 0 << 4;
    QTest::newRow("velocities") << 1 << 2;
    QTest::newRow("orientations") << 2 << 3;
    QTest::newRow("incircles") << 3 << 2;
    QTest::newRow("normals") << 4 << 1;
}

void DebugPictureTest::eachSwitchHidesOneThing() {
    QFETCH(int, which);
    QFETCH(int, least);
    DebugView view = plainView();
    view.colors = {{1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}, {5, 0, 0}};
    view.colors.fatBox = view.colors.box;
    view.colors.depth = {3, 0, 0};
    const Color own[] = {view.colors.box, view.colors.velocity, view.colors.orientation, view.colors.incircle,
                         view.colors.normal};
    const World world = busyWorld();
    std::vector<DrawCall> expected = recorded(world, view);
    const auto hidden = std::erase_if(
        expected, [&](const DrawCall& call) { return call.color.red == own[which].red && call.color.green == 0; });
    QVERIFY(static_cast<int>(hidden) >= least);
    OverlayFlags& on = view.overlays;
    bool* const switches[] = {&on.aabb, &on.velocity, &on.orientation, &on.incircle, &on.normals};
    *switches[which] = false;
    QVERIFY(recorded(world, view) == expected);
}

void DebugPictureTest::theSamePictureComesOutEveryTime() {
    World world = busyWorld();
    const std::uint64_t hash = world.hash();
    const std::vector<DrawCall> first = recorded(world, plainView());
    QVERIFY(first.size() > 15);
    QVERIFY(recorded(world, plainView()) == first);
    QVERIFY(recorded(world, plainView()) == first);
    QCOMPARE(world.hash(), hash);
    world.update();
    QVERIFY(recorded(world, plainView()) != first);
}

void DebugPictureTest::aCopyIsDrawnAsItWasWhileTheWorldGoesOn() {
    World world = busyWorld();
    const World copy = world;
    const std::vector<DrawCall> before = recorded(copy, plainView());
    run(world, 0.2);
    QVERIFY(recorded(copy, plainView()) == before);
    QVERIFY(recorded(world, plainView()) != before);
}

void DebugPictureTest::aStaticBodyThatWasPutElsewhereIsDrawnThere() {
    World world;
    BodyDef def = box({0, 0}, 1, 0.5);
    def.kind = BodyKind::Static;
    const BodyId id = add(world, def);
    world.update();
    world.setPose(id, {5, 3}, 0);
    const std::vector<Vec2> corners{Vec2(4, -2.5), Vec2(6, -2.5), Vec2(6, -3.5), Vec2(4, -3.5)};
    DebugView view = bareView();
    view.overlays.aabb = true;
    const ShapeColors colors = shapeColors(BodyKind::Static, Polygon{});
    const std::vector<DrawCall> expected{{Form::Rectangle, {{4, -3.5}, {6, -2.5}}, 0, Color{255, 255, 255}},
                                         {Form::FilledPolygon, corners, 0, colors.fill},
                                         {Form::Polygon, corners, 0, colors.outline}};
    QVERIFY(sameWithin(1e-12, recorded(world, view), expected));
    world.update();
    QVERIFY(sameWithin(1e-12, recorded(world, view), expected));
}

void DebugPictureTest::theBoxIsExactAndTheFatOneThatOfTheBroadPhase() {
    World world(withIterations(4, {0, 0}));
    BodyDef def = ball({0, 0}, 0.5);
    def.velocity = {3, 0};
    const BodyId id = add(world, def);
    world.update();
    const Aabb box = world.bounds(id);
    QVERIFY(box.size().x() > 1.01); // it covers the motion
    const double x = world.body(id).pose.position.x();
    const std::vector<DrawCall> expected{
        {Form::Rectangle, {{box.min.x(), -box.max.y()}, {box.max.x(), -box.min.y()}}, 0, DebugColors().fatBox},
        {Form::Rectangle, {{x - 0.5, -0.5}, {x + 0.5, 0.5}}, 0, {255, 255, 255}}};
    std::vector<DrawCall> calls = recorded(world, plainView());
    calls.resize(2);
    QVERIFY(sameWithin(1e-12, calls, expected));
    RecordingDraw draw;
    drawBody({.bounds = box}, bareView(), draw);
    QVERIFY(draw.calls.empty());
}

void DebugPictureTest::circlesStayRoundInEveryWindow_data() {
    QTest::addColumn<double>("width");
    QTest::addColumn<double>("height");
    QTest::addColumn<double>("scale");
    QTest::newRow("as the world") << 880.0 << 660.0 << 66.0;
    QTest::newRow("wide") << 1600.0 << 600.0 << 60.0;
    QTest::newRow("tall") << 400.0 << 2000.0 << 30.0;
    QTest::newRow("tiny") << 1.0 << 1.0 << 0.075;
}

void DebugPictureTest::circlesStayRoundInEveryWindow() {
    QFETCH(double, width);
    QFETCH(double, height);
    QFETCH(double, scale);
    const Vec2 at(8, 7);
    World world;
    BodyDef round = ball(at, 0.5);
    round.shapes.push_back(Polygon{regularPolygon(64, 0.5)});
    add(world, round);
    DebugView view = bareView();
    view.view = ViewTransform::fitting({{0, 0}, {40.0 / 3, 10}}, {width, height});
    const std::vector<DrawCall> calls = recorded(world, view);
    QCOMPARE(calls.size(), std::size_t{4});
    const Vec2 middle(width / 2 + (at.x() - 20.0 / 3) * scale, height / 2 - (at.y() - 5) * scale);
    for (const DrawCall& call : {calls[0], calls[1]}) {
        QVERIFY((call.points[0] - middle).norm() < 1e-9 && std::abs(call.radius - 0.5 * scale) < 1e-9);
    }
    QCOMPARE(calls[3].points.size(), std::size_t{64});
    for (const Vec2& corner : calls[3].points) {
        QVERIFY(std::abs((corner - middle).norm() - 0.5 * scale) < 1e-9);
    }
}

void DebugPictureTest::theHostMayGiveVelocitiesAndNormalsAHead() {
    class WithHeads : public RecordingDraw {
      public:
        std::vector<DrawCall> arrows;
        void arrow(const Vec2& from, const Vec2& to, const Color& color) override {
            arrows.push_back({Form::Line, {from, to}, 0, color});
        }
    };
    const World world = busyWorld();
    WithHeads draw;
    drawWorld(world, plainView(), draw);
    DebugView without = plainView();
    without.overlays.normals = without.overlays.velocity = false;
    const std::vector<DrawCall> all = recorded(world, plainView());
    QCOMPARE(draw.arrows.size(), all.size() - draw.calls.size());
    const Color band = without.colors.depth;
    std::erase_if(draw.calls, [&](const DrawCall& call) { // of walls, which go with their normals
        const bool isFaint = call.color.alpha < 100;
        return call.color == band || (isFaint && call.color.red == band.red && call.form == Form::FilledPolygon);
    });
    QVERIFY(draw.calls == recorded(world, without));
    for (const DrawCall& arrow : draw.arrows) {
        QVERIFY(std::find(all.begin(), all.end(), arrow) != all.end());
    }
}

void DebugPictureTest::theBackgroundComesFirstAndCoversThePicture() {
    const World world = busyWorld();
    DebugView view = plainView();
    view.view = ViewTransform::fitting({{0, 0}, {1, 1}}, {300, 200});
    std::vector<DrawCall> expected = recorded(world, view);
    view.background = Color{1, 2, 3};
    expected.insert(expected.begin(), {Form::FilledRectangle, {{0, 0}, {300, 200}}, 0, {1, 2, 3}});
    QVERIFY(recorded(world, view) == expected);
}

SPACETOW_TEST(DebugPictureTest)
#include "debug_picture_test.moc"
