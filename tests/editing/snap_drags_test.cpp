// What each tool and each drag snaps to.
#include "core/level/node_edits.h"
#include "editor/editing/node_verbs.h"
#include "tests/support/drive.h"
#include "tests/support/test_main.h"

#include <algorithm>
#include <numbers>

using namespace spacetow;
using namespace spacetow::test;

namespace {

/// Key 1: a triangle with corners at (0.1, 0.1), (2.1, 0.1), (0.1, 1.1), off the grid. Key 2: a ball at (5, 5).
Level triangleAndBall() {
    Level level;
    level.objects.append(bodyWith(1, Polygon{{{0, 0}, {2, 0}, {0, 1}}}, {0.1, 0.1}));
    level.objects.append(bodyWith(2, Circle{{0, 0}, 0.5}, {5, 5}));
    return level;
}

Vec2 placeIn(const Drive& drive, Key key) {
    return std::get<BodyObject>(drive.level().objects.find(key)->data).position;
}

bool isAt(const Vec2& a, const Vec2& b) {
    return (a - b).norm() < 1e-9;
}

SnapKind shownKind(const Drive& drive) {
    const Overlay overlay = drive.toolbox.overlay();
    return overlay.snap ? overlay.snap->kind : SnapKind::None;
}

} // namespace

class SnapDragsTest : public QObject {
    Q_OBJECT

  private slots:
    void eachDrawingToolSnapsAndShowsIt_data();
    void eachDrawingToolSnapsAndShowsIt();
    void ctrlSuspendsAndReleasesAtOnce();
    void withAllOffCtrlTurnsItOn();
    void aWallIsDrawnOnToACorner();
    void aWallEndsAtARightAngle();
    void shiftStopsAtTheEdgeThatTheDirectionMeets();
    void aRimGoesThroughACorner();
    void aMovedBodySnapsByItsCornerNearThePointer();
    void aMovedBodyAligns();
    void aMovedBodyIgnoresItself();
    void shiftMovesAlongOneAxisToWhatIsInLine();
    void aGroupSnapsWithAllItsMembers();
    void aDraggedNodeSnaps();
    void aDraggedNodeIgnoresItsOwnSegments();
    void aScaledSideReachesACorner();
    void scaledNodesReachACorner();
    void thePivotSnapsToWhatIsUnderIt();
    void theKnifeCutsFromCornerToCorner();
    void aNodeIsInsertedAtTheMiddle();
    void aMoveShowsItsMeasures();
    void hoverMarksGoWithThePointer();
};

void SnapDragsTest::eachDrawingToolSnapsAndShowsIt_data() {
    QTest::addColumn<int>("tool");
    for (const ToolId tool : {ToolId::Edge, ToolId::Line, ToolId::Polygon, ToolId::Circle, ToolId::Ship,
                              ToolId::Payload, ToolId::Finish, ToolId::Knife}) {
        QTest::newRow(toolRows()[static_cast<std::size_t>(tool)].make()->code().c_str()) << static_cast<int>(tool);
    }
}

void SnapDragsTest::eachDrawingToolSnapsAndShowsIt() {
    QFETCH(int, tool);
    Drive drive(triangleAndBall());
    drive.toolbox.choose(static_cast<ToolId>(tool));
    drive.move({2.13, 0.14});
    const Overlay overlay = drive.toolbox.overlay();
    QVERIFY(overlay.snap && overlay.snap->kind == SnapKind::Vertex && overlay.snap->key == 1);
    QVERIFY(isAt(overlay.snap->point, {2.1, 0.1}));
    QVERIFY(std::ranges::any_of(overlay.points, [](const OverlayPoint& point) { return isAt(point.at, {2.1, 0.1}); }));
    drive.move({1.12, 0.12});
    QVERIFY(shownKind(drive) == SnapKind::Midpoint);
    drive.held = ctrl;
    drive.move({1.12, 0.12});
    QVERIFY(shownKind(drive) == SnapKind::None);
}

void SnapDragsTest::ctrlSuspendsAndReleasesAtOnce() {
    Drive drive(triangleAndBall());
    drive.toolbox.choose(ToolId::Line);
    drive.held = ctrl;
    drive.click({2.13, 0.14});
    drive.held = none;
    drive.click({0.13, 1.14});
    drive.key(ToolKey::Enter);
    QVERIFY(isAt(worldPoints(drive.newest())[0], {2.13, 0.14}));
    QVERIFY(isAt(worldPoints(drive.newest())[1], {0.1, 1.1}));
}

void SnapDragsTest::withAllOffCtrlTurnsItOn() {
    Drive drive(triangleAndBall());
    drive.toolbox.snap.grid = drive.toolbox.snap.smart = false;
    drive.toolbox.choose(ToolId::Payload);
    drive.click({2.13, 0.14});
    QVERIFY(isAt(std::get<PayloadObject>(drive.newest().data).position, {2.13, 0.14}));
    drive.held = ctrl;
    drive.click({2.13, 0.14});
    QVERIFY(isAt(std::get<PayloadObject>(drive.newest().data).position, {2.1, 0.1}));
}

void SnapDragsTest::aWallIsDrawnOnToACorner() {
    Drive drive(triangleAndBall());
    drive.toolbox.choose(ToolId::Edge);
    drive.click({{-3, 0}, {0.04, 1.15}});
    drive.key(ToolKey::Enter);
    const std::vector<Vec2> points = worldPoints(drive.newest());
    QVERIFY(isAt(points[0], {-3, 0}) && isAt(points[1], {0.1, 1.1}));
    // As one place for the node tool, which takes both along.
    QCOMPARE(nodesAt(drive.level(), std::vector{Vec2(0.1, 1.1)}).size(), std::size_t{2});
}

void SnapDragsTest::aWallEndsAtARightAngle() {
    Drive drive(triangleAndBall());
    drive.toolbox.choose(ToolId::Line);
    drive.click({1.5, -2});
    drive.move({1.55, 0.15});
    QVERIFY(shownKind(drive) == SnapKind::Perpendicular);
    drive.click({1.55, 0.15});
    drive.key(ToolKey::Enter);
    QVERIFY(isAt(worldPoints(drive.newest())[1], {1.5, 0.1}));
}

void SnapDragsTest::shiftStopsAtTheEdgeThatTheDirectionMeets() {
    Drive drive(triangleAndBall());
    drive.toolbox.choose(ToolId::Line);
    drive.click({-2, 0.5});
    drive.held = shift;
    drive.move({1.34, 0.55}); // across the first side to the slanting one
    QVERIFY(shownKind(drive) == SnapKind::Edge);
    drive.click({1.34, 0.55});
    drive.key(ToolKey::Enter);
    QVERIFY(isAt(worldPoints(drive.newest())[1], {1.3, 0.5}));
}

void SnapDragsTest::aRimGoesThroughACorner() {
    Drive drive(triangleAndBall());
    drive.toolbox.choose(ToolId::Circle);
    drive.drag({2, 3}, {2.13, 0.14});
    const auto& circle = std::get<Circle>(std::get<BodyObject>(drive.newest().data).shapes[0]);
    QVERIFY(std::abs(circle.radius - (Vec2(2.1, 0.1) - Vec2(2, 3)).norm()) < 1e-9);
}

void SnapDragsTest::aMovedBodySnapsByItsCornerNearThePointer() {
    Level level = triangleAndBall();
    level.objects.append(bodyWith(3, LineChain{{{0, 0}, {0, 3}}}, {-4.07, -1.07}));
    Drive drive(level);
    drive.document.select(Selection({1}));
    drive.press({1.9, 0.15}); // near the corner (2.1, 0.1)
    drive.move({-4.2, 2});
    drive.move({-4.24, 2.01}); // the corner comes to (−4.04, 1.96)
    QVERIFY(shownKind(drive) == SnapKind::Vertex);
    QVERIFY(isAt(drive.toolbox.overlay().snap->mark, {-4.07, 1.93}));
    drive.release({-4.24, 2.01});
    QVERIFY(isAt(placeIn(drive, 1), Vec2(-6.07, 1.93)));
}

void SnapDragsTest::aMovedBodyAligns() {
    Drive drive(triangleAndBall());
    drive.document.select(Selection({1}));
    drive.toolbox.snap.grid = false;
    drive.press({0.6, 0.4});
    drive.move({4.93, 0.4}); // its left side comes to x = 4.43; that of the ball is at 4.5
    const Overlay overlay = drive.toolbox.overlay();
    QVERIFY(overlay.snap && overlay.snap->kind == SnapKind::Alignment);
    QCOMPARE(overlay.snap->lines.size(), std::size_t{1});
    QCOMPARE(overlay.snap->lines[0].key, Key{2});
    drive.release({4.93, 0.4});
    QVERIFY(isAt(placeIn(drive, 1), {4.5, 0.1}));
}

void SnapDragsTest::aMovedBodyIgnoresItself() {
    Drive drive(triangleAndBall());
    drive.toolbox.snap.grid = false;
    drive.document.select(Selection({1}));
    drive.drag({0.6, 0.3}, {0.67, 0.36});
    QVERIFY(isAt(placeIn(drive, 1), {0.17, 0.16}));
}

void SnapDragsTest::shiftMovesAlongOneAxisToWhatIsInLine() {
    Drive drive(triangleAndBall());
    drive.toolbox.snap.grid = false;
    drive.document.select(Selection({1}));
    drive.press({0.6, 0.4});
    drive.held = shift;
    drive.move({4.95, 0.9});
    drive.release({4.95, 0.9});
    QVERIFY(isAt(placeIn(drive, 1), {4.5, 0.1}));
}

void SnapDragsTest::aGroupSnapsWithAllItsMembers() {
    Level level = triangleAndBall();
    Object group;
    group.key = 7;
    group.data = GroupObject{};
    level.objects.append(group);
    for (int i = 0; i < 2; ++i) {
        Object member = level.objects[i];
        member.parent = 7;
        level.objects.replace(i, member);
    }
    Drive drive(level);
    drive.toolbox.snap.grid = false;
    drive.document.select(Selection({7}));
    drive.drag({5, 5}, {5.06, 5.05}); // the ball's own place, and the triangle's, draw nothing
    QVERIFY(isAt(placeIn(drive, 2), {5.06, 5.05}));
    QVERIFY(isAt(placeIn(drive, 1), {0.16, 0.15}));
}

void SnapDragsTest::aDraggedNodeSnaps() {
    Level level = triangleAndBall();
    level.objects.append(bodyWith(3, LineChain{{{0, 0}, {0, 3}}}, {-4, -1}));
    Drive drive(level);
    drive.document.select(Selection({3}));
    drive.toolbox.choose(ToolId::Nodes);
    drive.drag({-4, 2}, {0.14, 1.13});
    QVERIFY(isAt(worldPoints(drive.newest())[1], {0.1, 1.1}));
    drive.document.undo();
    drive.press({-4, 2});
    drive.move({1.14, 0.63});
    QVERIFY(shownKind(drive) == SnapKind::Midpoint); // of the long side
    drive.release({1.14, 0.63});
    QVERIFY(isAt(worldPoints(drive.newest())[1], {1.1, 0.6}));
}

void SnapDragsTest::aDraggedNodeIgnoresItsOwnSegments() {
    Drive drive(triangleAndBall());
    drive.toolbox.snap.grid = false;
    drive.document.select(Selection({1}));
    drive.toolbox.choose(ToolId::Nodes);
    drive.press({2.1, 0.1});
    drive.move({1.5, 0.13}); // on the side that ends at it
    QVERIFY(shownKind(drive) != SnapKind::Edge && shownKind(drive) != SnapKind::Midpoint);
    drive.release({1.5, 0.13});
}

void SnapDragsTest::aScaledSideReachesACorner() {
    Level level = triangleAndBall();
    level.objects.append(bodyWith(3, LineChain{{{0, 0}, {3, 2}}}, {4.07, 1.13}));
    Drive drive(level);
    drive.document.select(Selection({1}));
    const double outside = 10 * drive.view.pixel();
    const Vec2 handle(2.1 + outside, 1.1 + outside); // upper right
    drive.press(handle);
    drive.move(handle + Vec2(1.95, 0.05)); // the corner comes to (4.05, 1.15)
    QVERIFY(shownKind(drive) == SnapKind::Vertex);
    drive.release(handle + Vec2(1.95, 0.05));
    const std::vector<Vec2> points = worldPoints(*drive.level().objects.find(1));
    Aabb box;
    for (const Vec2& point : points) {
        box.include(point);
    }
    QVERIFY(isAt(box.max, {4.07, 1.13}) && isAt(box.min, {0.1, 0.1}));
    drive.document.undo();
    drive.press(handle);
    drive.held = alt;
    drive.move(handle + Vec2(1.95, 0.05));
    QVERIFY(shownKind(drive) == SnapKind::None);
    drive.release(handle + Vec2(1.95, 0.05));
}

void SnapDragsTest::scaledNodesReachACorner() {
    Level level = triangleAndBall();
    level.objects.append(bodyWith(3, LineChain{{{0, 0}, {1, 1}, {3, 0}}}, {-6, -4}));
    Drive drive(level);
    drive.toolbox.choose(ToolId::Nodes);
    drive.document.select(Selection({3}, {{3, 0, 0}, {3, 0, 1}}));
    const double outside = 14 * drive.view.pixel();
    const Vec2 handle(-5 + outside, -3 + outside);
    drive.press(handle);
    drive.move(handle + Vec2(2.03, -0.97)); // to the end of the chain, (−3, −4)
    QVERIFY(shownKind(drive) == SnapKind::Vertex);
    drive.release(handle + Vec2(2.03, -0.97));
}

void SnapDragsTest::thePivotSnapsToWhatIsUnderIt() {
    Drive drive(triangleAndBall());
    drive.document.select(Selection({1}));
    drive.click({0.6, 0.3}); // the handles that turn
    drive.press(drive.document.selection().pivot().value_or(Vec2(0.75, 0.5)));
    drive.move({5.03, 5.04});
    drive.release({5.03, 5.04});
    if (drive.document.selection().pivot()) {
        QVERIFY(isAt(*drive.document.selection().pivot(), {5, 5}));
    }
}

void SnapDragsTest::theKnifeCutsFromCornerToCorner() {
    Drive drive(triangleAndBall());
    drive.toolbox.choose(ToolId::Knife);
    drive.drag({0.12, 0.08}, {1.13, 0.64}); // a corner, and the middle of the side across
    int pieces = 0;
    for (const Object& object : drive.level().objects) {
        if (const auto* body = std::get_if<BodyObject>(&object.data); body != nullptr && object.key != 2) {
            pieces += static_cast<int>(body->shapes.size());
        }
    }
    QCOMPARE(pieces, 2);
}

void SnapDragsTest::aNodeIsInsertedAtTheMiddle() {
    Drive drive(triangleAndBall());
    drive.document.select(Selection({1}));
    drive.toolbox.choose(ToolId::Nodes);
    drive.doubleClick({1.13, 0.12});
    const std::vector<Vec2> points = worldPoints(*drive.level().objects.find(1));
    QCOMPARE(points.size(), std::size_t{4});
    QVERIFY(std::ranges::any_of(points, [](const Vec2& point) { return isAt(point, {1.1, 0.1}); }));
}

void SnapDragsTest::aMoveShowsItsMeasures() {
    Drive drive(triangleAndBall());
    drive.toolbox.snap.smart = false;
    drive.press({5, 5});
    drive.move({8, 9});
    QCOMPARE(drive.toolbox.overlay().texts.size(), std::size_t{1});
    const OverlayText text = drive.toolbox.overlay().texts[0];
    QCOMPARE(QString::fromStdString(text.text), QString::fromUtf8("Δx 3.00  Δy 4.00 m\n5.00 m  53.1°"));
    QVERIFY(text.at == Vec2(8, 9));
}

void SnapDragsTest::hoverMarksGoWithThePointer() {
    Drive drive(triangleAndBall());
    drive.toolbox.choose(ToolId::Line);
    drive.move({2.13, 0.14});
    QVERIFY(shownKind(drive) == SnapKind::Vertex);
    drive.toolbox.leave();
    QVERIFY(shownKind(drive) == SnapKind::None);
    drive.toolbox.choose(ToolId::Select);
    drive.move({2.13, 0.14});
    QVERIFY(shownKind(drive) == SnapKind::None); // a click there selects, it places nothing
}

SPACETOW_TEST(SnapDragsTest)
#include "snap_drags_test.moc"
