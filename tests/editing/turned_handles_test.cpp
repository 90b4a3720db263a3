// Handles around a body that is turned.
#include "editor/editing/handles.h"
#include "tests/support/drive.h"
#include "tests/support/test_main.h"

#include <algorithm>
#include <numbers>

using namespace spacetow;
using namespace spacetow::test;

namespace {

/// A board of 2 m × 1 m about (3, 1), turned by 30°.
Level turnedBoard() {
    Level level;
    Object board = bodyWith(1, Polygon{{{-1, -0.5}, {1, -0.5}, {1, 0.5}, {-1, 0.5}}}, {3, 1});
    std::get<BodyObject>(board.data).angle = std::numbers::pi / 6;
    level.objects.append(board);
    return level;
}

bool meets(const Vec2& a, const Vec2& b) {
    return (a - b).norm() < 1e-9;
}

} // namespace

class TurnedHandlesTest : public QObject {
    Q_OBJECT

  private slots:
    void theHandlesOfATurnedBodyFollowItsSides_data() {
        QTest::addColumn<HandleSide>("side");
        QTest::addColumn<Vec2>("way"); // along the sides
        QTest::addColumn<Modifiers>("held");
        QTest::addColumn<Vec2>("min"); // of its own coordinates, as seen from where it was
        QTest::addColumn<Vec2>("max");
        QTest::newRow("wider") << HandleSide{1, 0} << Vec2(0.52, 3) << none << Vec2(-1, -0.5) << Vec2(1.5, 0.5);
        QTest::newRow("off the steps") << HandleSide{1, 0} << Vec2(0.52, 0) << alt << Vec2(-1, -0.5) << Vec2(1.52, 0.5);
        QTest::newRow("higher") << HandleSide{0, -1} << Vec2(0, -1.03) << none << Vec2(-1, -1.5) << Vec2(1, 0.5);
        QTest::newRow("at a corner") << HandleSide{1, 1} << Vec2(1.02, 0.49) << none << Vec2(-1, -0.5) << Vec2(2, 1);
        QTest::newRow("about the middle")
            << HandleSide{1, 0} << Vec2(0.26, 0) << shift << Vec2(-1.25, -0.5) << Vec2(1.25, 0.5);
        QTest::newRow("in proportion") << HandleSide{1, 1} << Vec2(2.04, 0.3) << ctrl << Vec2(-1, -0.5) << Vec2(3, 1.5);
    }
    void theHandlesOfATurnedBodyFollowItsSides() {
        QFETCH(HandleSide, side);
        QFETCH(Vec2, way);
        QFETCH(Modifiers, held);
        QFETCH(Vec2, min);
        QFETCH(Vec2, max);
        Drive drive(turnedBoard());
        drive.document.select(Selection({1}));
        const HandleFrame frame = handleFrame(drive.toolbox.context());
        const std::vector<Handle> handles = handlesOf(frame, HandleMode::Scale, drive.view.pixel());
        const auto handle = std::ranges::find(handles, side, &Handle::side);
        const Rot turn = Rot::fromAngle(std::numbers::pi / 6);
        const Vec2 from = handle->at;
        const Vec2 outwards = turn.inverse() * Vec2(from - pointOf(frame, side));
        QVERIFY(meets(outwards, 10 * drive.view.pixel() * Vec2(side.x, side.y)));
        drive.held = held;
        drive.drag(from, from + turn * way);
        const auto& board = std::get<BodyObject>(drive.level().objects.find(1)->data);
        QCOMPARE(board.angle, std::numbers::pi / 6);
        Aabb box;
        for (const Vec2& vertex : std::get<Polygon>(board.shapes.front()).vertices) {
            const Vec2 inWorld = board.position + turn * vertex;
            box.include(turn.inverse() * Vec2(inWorld - Vec2(3, 1)));
        }
        QVERIFY2(
            meets(box.min, min) && meets(box.max, max),
            qPrintable(QString("%1 %2, %3 %4").arg(box.min.x()).arg(box.min.y()).arg(box.max.x()).arg(box.max.y())));
        QCOMPARE(std::get<Polygon>(board.shapes.front()).vertices.size(), std::size_t{4});
        drive.document.undo();
        QVERIFY(drive.level() == turnedBoard());
    }

    void aSideThatSlantsReachesACorner() {
        Level level = turnedBoard();
        const Rot turn = Rot::fromAngle(std::numbers::pi / 6);
        const Vec2 corner = Vec2(3, 1) + turn * Vec2(1.83, 0);
        level.objects.append(bodyWith(2, LineChain{{{0, 0}, {3, -2}}}, corner));
        Drive drive(level);
        drive.document.select(Selection({1}));
        const Vec2 from = Vec2(3, 1) + turn * Vec2(1 + 10 * drive.view.pixel(), 0);
        drive.drag(from, from + turn * Vec2(0.85, 0));
        const auto& board = std::get<BodyObject>(drive.level().objects.find(1)->data);
        QVERIFY(std::ranges::any_of(std::get<Polygon>(board.shapes.front()).vertices, [&](const Vec2& vertex) {
            return meets(turn.inverse() * Vec2(board.position + turn * vertex - Vec2(3, 1)), {1.83, 0.5});
        }));
    }

    void theArrowsOfTheCursorLieAlongSidesThatSlant() {
        const Rot eighth = Rot::fromAngle(std::numbers::pi / 4);
        QCOMPARE(handleCursor({1, 0}, HandleMode::Scale, {}), CursorShape::SizeAcross);
        QCOMPARE(handleCursor({0, -1}, HandleMode::Scale, {}), CursorShape::SizeUpright);
        QCOMPARE(handleCursor({-1, 1}, HandleMode::Scale, {}), CursorShape::SizeFalling);
        QCOMPARE(handleCursor({1, 0}, HandleMode::Scale, eighth), CursorShape::SizeRising);
        QCOMPARE(handleCursor({1, 1}, HandleMode::Scale, eighth), CursorShape::SizeUpright);
        QCOMPARE(handleCursor({0, 1}, HandleMode::Scale, eighth), CursorShape::SizeFalling);
    }
};

SPACETOW_TEST(TurnedHandlesTest)
#include "turned_handles_test.moc"
