// Bodies that move as they are told: drawing them, and the arrow of their velocity, then and later.

#include "editor/editing/kinematic_tool.h"

#include "core/level/edits.h"
#include "editor/editing/velocity_handle.h"
#include "tests/support/drive.h"
#include "tests/support/test_main.h"

#include <algorithm>

using namespace spacetow;
using namespace spacetow::test;

namespace {

struct KinematicDrawer : Drive {
    KinematicDrawer() { toolbox.choose(ToolId::Kinematic); }
    const BodyObject& body() const { return std::get<BodyObject>(newest().data); }
    std::string hintCode() const { return toolbox.hint().code; }
};

Level withPlatform(BodyKind kind, const Vec2& velocity) {
    Object object = bodyWith(1, Polygon{{{-1, -0.5}, {1, -0.5}, {1, 0.5}, {-1, 0.5}}}, {2, 1});
    auto& body = std::get<BodyObject>(object.data);
    body.kind = kind;
    body.velocity = velocity;
    return added(Level{}, object);
}

std::size_t arrows(const Drive& drive) {
    const std::vector<OverlayLine> lines = drive.toolbox.overlay().lines;
    return static_cast<std::size_t>(
        std::ranges::count_if(lines, [](const OverlayLine& line) { return line.style == OverlayStyle::Velocity; }));
}

} // namespace

class KinematicToolTest : public QObject {
    Q_OBJECT

  private slots:
    void aDragDrawsAPlatformAndTheNextItsVelocity() {
        KinematicDrawer drive;
        drive.drag({1, 1}, {3, 1.5});
        QCOMPARE(drive.level().objects.size(), 1);
        QCOMPARE(drive.body().kind, BodyKind::Kinematic);
        QVERIFY(drive.body().position == Vec2(2, 1.25)); // it turns about its middle
        QVERIFY(worldPoints(drive.newest()) == (std::vector<Vec2>{{1, 1}, {3, 1}, {3, 1.5}, {1, 1.5}}));
        QVERIFY(drive.toolbox.isBusy());

        drive.move({2, 2.75});
        QCOMPARE(drive.toolbox.hint(), (Hint{"velocity.drawing", {"1.50", "90"}}));
        QVERIFY(arrows(drive) > 0);
        drive.drag({2, 1.75}, {3, 1.25});
        QVERIFY(drive.body().velocity == Vec2(1, 0));
        QVERIFY(!drive.toolbox.isBusy());
        QCOMPARE(drive.document.history(), (std::vector<Label>{{"draw-kinematic", 1}, {"set-velocity", 1}}));
    }

    void aClickSetsTheVelocityToo() {
        KinematicDrawer drive;
        drive.drag({1, 1}, {3, 1.5});
        drive.click({2.5, 1.75});
        QVERIFY(drive.body().velocity == Vec2(0.5, 0.5));
        QVERIFY(!drive.toolbox.isBusy());
        drive.drag({5, 5}, {6, 6}); // ready for the next
        QCOMPARE(drive.level().objects.size(), 2);
    }

    void clicksDrawAPolygon() {
        KinematicDrawer drive;
        drive.move({0, 0});
        QCOMPARE(drive.hintCode(), std::string("draw-kinematic.start"));
        drive.click({{0, 0}, {2, 0}, {2, 2}});
        QCOMPARE(drive.hintCode(), std::string("draw-polygon.next"));
        drive.key(ToolKey::Enter);
        QCOMPARE(drive.body().kind, BodyKind::Kinematic);
        QVERIFY(drive.body().position == Vec2(1, 1));
        QVERIFY(worldPoints(drive.newest()) == (std::vector<Vec2>{{0, 0}, {2, 0}, {2, 2}}));
        drive.click({0, 1});
        QVERIFY(drive.body().velocity == Vec2(-1, 0));
    }

    void theBodyStaysAtRestWhenNoVelocityIsGiven_data() {
        QTest::addColumn<int>("how");
        QTest::newRow("enter") << 0;
        QTest::newRow("escape") << 1;
        QTest::newRow("secondary") << 2;
        QTest::newRow("another tool") << 3;
    }
    void theBodyStaysAtRestWhenNoVelocityIsGiven() {
        QFETCH(int, how);
        KinematicDrawer drive;
        drive.drag({1, 1}, {3, 1.5});
        drive.move({4, 4});
        switch (how) {
        case 0:
            drive.key(ToolKey::Enter);
            break;
        case 1:
            drive.key(ToolKey::Escape);
            break;
        case 2:
            QVERIFY(drive.secondaryClick({4, 4})); // no menu
            break;
        default:
            drive.toolbox.choose(ToolId::Select);
        }
        QVERIFY(!drive.toolbox.isBusy());
        QVERIFY(drive.body().velocity == Vec2(0, 0));
        QCOMPARE(drive.document.history().size(), std::size_t{1});
    }

    void undoWhileTheArrowIsDrawnTakesTheBodyBack() {
        KinematicDrawer drive;
        drive.drag({1, 1}, {3, 1.5});
        drive.document.undo();
        drive.move({4, 4});
        QVERIFY(!drive.toolbox.isBusy());
        QCOMPARE(drive.hintCode(), std::string("draw-kinematic.start"));
    }

    void aDragWithoutAreaDrawsNothing() {
        KinematicDrawer drive;
        drive.drag({1, 1}, {3, 1});
        QVERIFY(drive.level().objects.empty());
        QVERIFY(!drive.toolbox.isBusy());
    }

    void shiftKeepsTheVelocityToSteps() {
        KinematicDrawer drive;
        drive.drag({1, 1}, {3, 2});
        drive.held.shift = true;
        drive.click({4, 1.6});
        QVERIFY(drive.body().velocity == Vec2(2, 0));
    }

    void theTipOfTheArrowIsAHandleLater_data() {
        QTest::addColumn<BodyKind>("kind");
        QTest::addColumn<bool>("moves");
        QTest::newRow("kinematic") << BodyKind::Kinematic << true;
        QTest::newRow("kinematic at rest") << BodyKind::Kinematic << false;
        QTest::newRow("dynamic") << BodyKind::Dynamic << true;
    }
    void theTipOfTheArrowIsAHandleLater() {
        QFETCH(BodyKind, kind);
        QFETCH(bool, moves);
        Drive drive(withPlatform(kind, moves ? Vec2(0, 2) : Vec2(0, 0)));
        drive.document.select(Selection({1}));
        const auto arrow = velocityArrow(drive.document.current(), drive.view.pixel());
        QVERIFY(arrow);
        drive.move(arrow->handle);
        QCOMPARE(drive.toolbox.hint().code, std::string("velocity.handle"));
        QCOMPARE(drive.toolbox.cursor(), CursorShape::Pointing);
        drive.press(arrow->handle);
        drive.move(arrow->handle + Vec2(0.5, 0.3));
        drive.move(arrow->handle + Vec2(1, 0));
        QCOMPARE(drive.toolbox.hint().code, std::string("velocity.dragging"));
        drive.release(arrow->handle + Vec2(1, 0));
        const auto& body = std::get<BodyObject>(drive.newest().data);
        QVERIFY(body.velocity == (moves ? Vec2(1, 2) : Vec2(1, 0)));
        QVERIFY(body.position == Vec2(2, 1));
        QCOMPARE(drive.document.history(), (std::vector<Label>{{"set-velocity", 1}}));
    }

    void aClickOnTheTipKeepsTheSelection() {
        Drive drive(withPlatform(BodyKind::Kinematic, {0, 2}));
        drive.document.select(Selection({1}));
        drive.click({2, 3});
        QVERIFY(drive.document.selection() == Selection({1}));
        QVERIFY(drive.document.history().empty());
    }

    void thereIsNoArrowWhereNoneIsDue_data() {
        QTest::addColumn<BodyKind>("kind");
        QTest::addColumn<bool>("moves");
        QTest::addColumn<bool>("locked");
        QTest::newRow("static") << BodyKind::Static << true << false;
        QTest::newRow("dynamic at rest") << BodyKind::Dynamic << false << false;
        QTest::newRow("locked") << BodyKind::Kinematic << true << true;
    }
    void thereIsNoArrowWhereNoneIsDue() {
        QFETCH(BodyKind, kind);
        QFETCH(bool, moves);
        QFETCH(bool, locked);
        Level level = withPlatform(kind, moves ? Vec2(1, 0) : Vec2(0, 0));
        Object object = level.objects[0];
        object.locked = locked;
        Drive drive(withObject(level, object));
        drive.document.select(Selection({1}));
        QVERIFY(!velocityArrow(drive.document.current(), drive.view.pixel()));
        QCOMPARE(arrows(drive), std::size_t{0});
    }

    void severalSelectedBodiesShowNoArrow() {
        Level level = withPlatform(BodyKind::Kinematic, {1, 0});
        level = added(level, bodyWith(2, Circle{{0, 0}, 1}, {6, 6}));
        QVERIFY(!velocityArrow({std::make_shared<const Level>(level), Selection({1, 2})}, 0.01));
        QVERIFY(velocityArrow({std::make_shared<const Level>(level), Selection({1})}, 0.01));
    }
};

SPACETOW_TEST(KinematicToolTest)
#include "kinematic_tool_test.moc"
