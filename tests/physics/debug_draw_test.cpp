#include "tests/support/contact_scenes.h"
#include "tests/support/recording_draw.h"

using namespace spacetow;
using namespace spacetow::test;

namespace {

constexpr Color white{255, 255, 255};
constexpr Color cyan{0, 255, 255};
constexpr Color red{255, 0, 0};
constexpr Color normalGrey{210, 200, 200, 128};
constexpr Color incircleGreen{150, 250, 200};
constexpr Color bandGrey{210, 200, 200};
constexpr Color bandFill{210, 200, 200, 60};

ShapeColors tableColors(BodyKind kind, const QString& shape) {
    if (kind == BodyKind::Static) {
        return {{210, 200, 200, 128}, {220, 210, 210}};
    }
    const bool dynamic = kind == BodyKind::Dynamic;
    if (shape == "circle") {
        return dynamic ? ShapeColors{{150, 200, 150, 128}, {150, 250, 200}}
                       : ShapeColors{{75, 75, 200, 128}, {75, 75, 255}};
    }
    if (shape == "polygon") {
        return dynamic ? ShapeColors{{150, 150, 200, 128}, {200, 150, 255}}
                       : ShapeColors{{200, 150, 150, 128}, {255, 100, 100}};
    }
    return dynamic ? ShapeColors{{200, 200, 100, 128}, {250, 250, 75}}
                   : ShapeColors{{100, 200, 100, 128}, {55, 200, 55}};
}

Shape shapeNamed(const QString& name) {
    if (name == "circle") {
        return Circle{{1, 0}, 0.5};
    }
    if (name == "polygon") {
        return Polygon{{Vec2(0, 0), Vec2(4, 0), Vec2(4, 2), Vec2(0, 2)}};
    }
    return name == "edge" ? Shape(Edge{{0, 0}, {4, 0}, 0.5}) : Shape(Line{{0, 0}, {4, 0}});
}

/// What shapeNamed() looks like in a body at (3, 2) that is turned by a right angle anticlockwise, its box aside.
std::vector<DrawCall> shapeCalls(BodyKind kind, const QString& name) {
    const auto [fill, outline] = tableColors(kind, name);
    if (name == "circle") {
        return {{Form::FilledCircle, {{3, -3}}, 0.5, fill}, {Form::Circle, {{3, -3}}, 0.5, outline}};
    }
    if (name == "polygon") {
        const std::vector<Vec2> corners{Vec2(3, -2), Vec2(3, -6), Vec2(1, -6), Vec2(1, -2)};
        return {{Form::FilledPolygon, corners, 0, fill},
                {Form::Circle, {{2, -4}}, 1, incircleGreen},
                {Form::Polygon, corners, 0, outline}};
    }
    std::vector<DrawCall> calls;
    if (name == "edge") { // half a metre of it is solid
        calls.push_back({Form::FilledPolygon, {{3, -2}, {3, -6}, {3.5, -6}, {3.5, -2}}, 0, bandFill});
        calls.push_back({Form::Line, {{3.5, -6}, {3.5, -2}}, 0, bandGrey});
    }
    calls.push_back({Form::Line, {{3, -4}, {2, -4}}, 0, normalGrey});
    if (name == "line") {
        calls.push_back({Form::Line, {{3, -4}, {4, -4}}, 0, normalGrey});
    }
    calls.push_back({Form::Line, {{3, -2}, {3, -6}}, 0, outline});
    return calls;
}

Vec2 shapeCenter(const QString& name) {
    return name == "circle" ? Vec2(3, 3) : name == "polygon" ? Vec2(2, 4) : Vec2(3, 4);
}

BodyDef turnedBody(BodyKind kind, const QString& shape) {
    BodyDef def{.kind = kind, .shapes = {shapeNamed(shape)}, .position = {3, 2}, .angle = pi / 2};
    def.velocity = {2, -1};
    return def;
}

qsizetype count(const std::vector<DrawCall>& calls, Form form, const Color& color) {
    return std::count_if(calls.begin(), calls.end(),
                         [&](const DrawCall& call) { return call.form == form && call.color == color; });
}

} // namespace

class DebugDrawTest : public QObject {
    Q_OBJECT

  private slots:
    void eachShapeOfEachKindLooksAsInTheTable_data();
    void eachShapeOfEachKindLooksAsInTheTable();
    void staticThenKinematicThenDynamicThenConnectors();
    void theHueTellsTheStretch_data();
    void theHueTellsTheStretch();
    void ofAHiddenBodyNothingIsDrawn_data();
    void ofAHiddenBodyNothingIsDrawn();
    void severalShapesShareOneBoxOneOrientationAndOneVelocity();
    void aConcavePolygonKeepsItsOutline();
    void whatHasNoExtentIsLeftOut();
    void ofWhatIsTooSmallToBeSeenTheHostIsTold();
};

void DebugDrawTest::eachShapeOfEachKindLooksAsInTheTable_data() {
    QTest::addColumn<int>("kind");
    QTest::addColumn<QString>("shape");
    const char* const kinds[] = {"static", "kinematic", "dynamic"};
    for (int kind = 0; kind < 3; ++kind) {
        for (const char* shape : {"circle", "polygon", "edge", "line"}) {
            QTest::addRow("%s %s", kinds[kind], shape) << kind << QString(shape);
        }
    }
}

void DebugDrawTest::eachShapeOfEachKindLooksAsInTheTable() {
    QFETCH(int, kind);
    QFETCH(QString, shape);
    const auto bodyKind = static_cast<BodyKind>(kind);
    World world;
    const BodyId id = add(world, turnedBody(bodyKind, shape));
    const Aabb box = world.bounds(id);
    std::vector<DrawCall> expected{
        {Form::Rectangle, {Vec2(box.min.x(), -box.max.y()), Vec2(box.max.x(), -box.min.y())}, 0, white}};
    for (const DrawCall& call : shapeCalls(bodyKind, shape)) {
        expected.push_back(call);
    }
    const bool wall = shape == "edge" || shape == "line";
    if (bodyKind != BodyKind::Static || !wall) {
        expected.push_back({Form::Line, {{3, -2}, {2, -2}}, 0, cyan});
    }
    if (bodyKind != BodyKind::Static) {
        const Vec2 c = shapeCenter(shape);
        expected.push_back({Form::Line, {{c.x(), -c.y()}, {c.x() + 2, -c.y() + 1}}, 0, red});
    }
    QVERIFY(sameWithin(1e-12, recorded(world, plainView()), expected));
}

void DebugDrawTest::staticThenKinematicThenDynamicThenConnectors() {
    World world;
    std::vector<DrawCall> expected[3];
    BodyId ends[2];
    int x = 0;
    for (const BodyKind kind : {BodyKind::Dynamic, BodyKind::Static, BodyKind::Kinematic, BodyKind::Dynamic,
                                BodyKind::Kinematic, BodyKind::Static}) {
        BodyDef def = ball({static_cast<double>(++x), 0}, 0.25);
        def.kind = kind;
        ends[x % 2] = add(world, def);
        const ShapeColors colors = tableColors(kind, "circle");
        expected[static_cast<int>(kind)].push_back({Form::FilledCircle, {def.position}, 0.25, colors.fill});
        expected[static_cast<int>(kind)].push_back({Form::Circle, {def.position}, 0.25, colors.outline});
    }
    QVERIFY(world.addConnector({.a = ends[1], .b = ends[0], .anchorB = {0, 0.5}, .length = 4}));
    std::vector<DrawCall> all;
    for (const std::vector<DrawCall>& calls : expected) {
        all.insert(all.end(), calls.begin(), calls.end());
    }
    all.push_back({Form::Line, {{5, 0}, {6, -0.5}}, 0, Color{255, 0, 0}});
    QVERIFY(sameWithin(0, recorded(world, bareView()), all));
}

void DebugDrawTest::theHueTellsTheStretch_data() {
    QTest::addColumn<double>("distance");
    QTest::addColumn<double>("length");
    QTest::addColumn<double>("hue"); // of 360
    QTest::addColumn<int>("red");
    QTest::addColumn<int>("green");
    QTest::newRow("together") << 0.0 << 2.0 << 0.0 << 255 << 0;
    QTest::newRow("a quarter") << 0.5 << 2.0 << 0.0 << 255 << 0;
    QTest::newRow("half") << 1.0 << 2.0 << 0.0 << 255 << 0;
    QTest::newRow("three quarters") << 1.5 << 2.0 << 30.0 << 255 << 128;
    QTest::newRow("natural") << 2.0 << 2.0 << 60.0 << 255 << 255;
    QTest::newRow("one and a quarter") << 2.5 << 2.0 << 90.0 << 128 << 255;
    QTest::newRow("one and a half") << 3.0 << 2.0 << 120.0 << 0 << 255;
    QTest::newRow("far") << 80.0 << 2.0 << 120.0 << 0 << 255;
    QTest::newRow("no length") << 1.0 << 0.0 << 60.0 << 255 << 255;
    QTest::newRow("no length, together") << 0.0 << 0.0 << 60.0 << 255 << 255;
}

void DebugDrawTest::theHueTellsTheStretch() {
    QFETCH(double, distance);
    QFETCH(double, length);
    QFETCH(double, hue);
    QFETCH(int, red);
    QFETCH(int, green);
    QVERIFY(std::abs(360 * connectorHue(distance, length) - hue) < 1e-9);
    World world;
    const BodyId a = add(world, ball({1, 1}, 0.25));
    const BodyId b = add(world, ball({1 + distance, 1}, 0.25));
    QVERIFY(world.addConnector({.a = a, .b = b, .length = length}));
    const DrawCall expected{Form::Line,
                            {{1, -1}, {1 + distance, -1}},
                            0,
                            {static_cast<std::uint8_t>(red), static_cast<std::uint8_t>(green), 0}};
    QVERIFY(recorded(world, bareView()).back() == expected);
}

void DebugDrawTest::ofAHiddenBodyNothingIsDrawn_data() {
    QTest::addColumn<QString>("shape");
    for (const char* shape : {"circle", "polygon", "edge", "line"}) {
        QTest::newRow(shape) << QString(shape);
    }
}

void DebugDrawTest::ofAHiddenBodyNothingIsDrawn() {
    QFETCH(QString, shape);
    World world;
    add(world, ball({0, 0}, 0.5));
    const std::vector<DrawCall> without = recorded(world, plainView());
    const BodyId hidden = add(world, turnedBody(BodyKind::Dynamic, shape));
    QVERIFY(recorded(world, plainView()) != without);
    DebugView view = plainView();
    view.shows = [hidden](BodyId id) { return id != hidden; };
    QVERIFY(recorded(world, view) == without);
}

void DebugDrawTest::severalShapesShareOneBoxOneOrientationAndOneVelocity() {
    World world;
    BodyDef def{
        .shapes = {Circle{{-1, 0}, 0.5}, Circle{{1, 0}, 0.5}, Polygon{regularPolygon(4, 1)}, Edge{{0, 0}, {0, 2}}},
        .velocity = {1, 0}};
    add(world, def);
    const std::vector<DrawCall> calls = recorded(world, plainView());
    QCOMPARE(count(calls, Form::Rectangle, white), 1);
    QCOMPARE(count(calls, Form::Line, cyan), 1);
    QCOMPARE(count(calls, Form::Line, red), 1);
    QCOMPARE(count(calls, Form::FilledCircle, tableColors(BodyKind::Dynamic, "circle").fill), 2);
    QCOMPARE(count(calls, Form::FilledPolygon, tableColors(BodyKind::Dynamic, "polygon").fill), 1);
    QCOMPARE(count(calls, Form::Line, tableColors(BodyKind::Dynamic, "edge").outline), 1);
    QCOMPARE(count(calls, Form::Line, normalGrey), 1);
    QCOMPARE(count(calls, Form::FilledPolygon, bandFill), 1);
    QCOMPARE(calls.size(), std::size_t{1 + 2 * 2 + 3 + 3 + 2});
}

void DebugDrawTest::aConcavePolygonKeepsItsOutline() {
    const Polygon comb{{Vec2(0, 0), Vec2(5, 0), Vec2(5, 2), Vec2(4, 2), Vec2(4, 1), Vec2(3, 1), Vec2(3, 2), Vec2(2, 2),
                        Vec2(2, 1), Vec2(1, 1), Vec2(1, 2), Vec2(0, 2)}};
    World world;
    add(world, {.kind = BodyKind::Static, .shapes = {comb}});
    std::vector<Vec2> outline;
    for (const Vec2& vertex : comb.vertices) {
        outline.emplace_back(vertex.x(), -vertex.y());
    }
    const ShapeColors colors = tableColors(BodyKind::Static, "polygon");
    const std::vector<DrawCall> expected{{Form::FilledPolygon, outline, 0, colors.fill},
                                         {Form::Polygon, outline, 0, colors.outline}};
    QVERIFY(recorded(world, bareView()) == expected);
}

void DebugDrawTest::whatHasNoExtentIsLeftOut() {
    World world;
    add(world, {.kind = BodyKind::Static});
    QVERIFY(recorded(world, plainView()).empty());
    const std::vector<Shape> shapes{Edge{{1, 1}, {1, 1}}, Line{{1, 1}, {1, 1}}, Polygon{},
                                    Polygon{{Vec2(0, 0), Vec2(1, 0)}}};
    RecordingDraw draw;
    drawBody({BodyKind::Static, shapes, {}, {0, 0}, {0, 0}, {}, {}}, bareView(), draw);
    QVERIFY(draw.calls.empty());
}

void DebugDrawTest::ofWhatIsTooSmallToBeSeenTheHostIsTold() {
    World world;
    add(world, {.kind = BodyKind::Static, .shapes = {Edge{{0, 0}, {0.5, 0}, 0.2}}});
    add(world, {.kind = BodyKind::Dynamic, .shapes = {Circle{{3, 0}, 0.5}}, .velocity = {0.5, 0}});
    add(world,
        {.kind = BodyKind::Dynamic, .shapes = {Circle{{5, 0}, 0.5}}, .velocity = {1e-3, 0}}); // as good as at rest
    const auto leftOut = [&world](double scale, const OverlayFlags& overlays, const Vec2& middle) {
        DebugView view = bareView();
        view.view.scale = scale;
        view.overlays = overlays;
        view.isSelected = [](std::uint64_t) { return true; };
        view.area = Aabb{middle - Vec2(10, 10), middle + Vec2(10, 10)};
        RecordingDraw draw;
        drawWorld(world, view, draw);
        return draw.leftOutCount;
    };
    for (const OverlayFlags& overlays :
         {OverlayFlags{.velocity = true}, OverlayFlags{.normals = true}, OverlayFlags{.collides = true}}) {
        QVERIFY(leftOut(1, overlays, {0, 0}) > 0);
        QCOMPARE(leftOut(1, overlays, {100, 0}), 0); // elsewhere nothing is
        QCOMPARE(leftOut(10, overlays, {0, 0}), 0);
    }
}

SPACETOW_TEST(DebugDrawTest)
#include "debug_draw_test.moc"
