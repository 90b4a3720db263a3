#include "editor/editing/draw_tool.h"

#include "tests/support/drive.h"
#include "tests/support/test_main.h"

#include <algorithm>

using namespace spacetow;
using namespace spacetow::test;

namespace {

const std::vector<Vec2> triangle{{0, 0}, {2, 0}, {2, 2}};

struct ChainDrawer : Drive {
    explicit ChainDrawer(ToolId tool) { toolbox.choose(tool); }
    void points(const std::vector<Vec2>& points) {
        for (const Vec2& point : points) {
            click(point);
        }
    }
    const LevelShape& shape() const { return std::get<BodyObject>(newest().data).shapes.front(); }
    bool isClosed() const {
        const auto* edges = std::get_if<EdgeChain>(&shape());
        return edges ? edges->closed : std::get<LineChain>(shape()).closed;
    }
    std::string hintCode() const { return toolbox.hint().code; }
};

void chainTools() {
    QTest::addColumn<ToolId>("tool");
    QTest::newRow("edge") << ToolId::Edge;
    QTest::newRow("line") << ToolId::Line;
}

void drawTools() {
    chainTools();
    QTest::newRow("polygon") << ToolId::Polygon;
}

LabelCode labelOf(ToolId tool) {
    return tool == ToolId::Edge   ? LabelCode("draw-edge")
           : tool == ToolId::Line ? LabelCode("draw-line")
                                  : "draw-polygon";
}

} // namespace

class DrawToolTest : public QObject {
    Q_OBJECT

  private slots:
    void clicksPlacePointsAndTheFirstOneCloses_data() { drawTools(); }
    void clicksPlacePointsAndTheFirstOneCloses();
    void whatIsDrawnIsAStaticWall_data() { drawTools(); }
    void whatIsDrawnIsAStaticWall();
    void aChainEndsOpen_data();
    void aChainEndsOpen();
    void aPolygonClosesHoweverItEnds_data();
    void aPolygonClosesHoweverItEnds();
    void tooFewPointsAreKept_data();
    void tooFewPointsAreKept();
    void backspaceDropsTheLastPoint_data() { drawTools(); }
    void backspaceDropsTheLastPoint();
    void escapeCancelsTheShape_data() { drawTools(); }
    void escapeCancelsTheShape();
    void theFirstDragDrawsASegment();
    void laterDragsAdjustTheirPoint();
    void escapeDuringADragKeepsThePointsPlaced();
    void noSegmentHasZeroLength_data() { drawTools(); }
    void noSegmentHasZeroLength();
    void shiftAndCtrlChangeWhereAPointLands();
    void closingIsPossibleOffTheGrid();
    void theRingShowsWhereAClickCloses();
    void theSolidSideLiesToTheRight();
    void lengthAndAngleAreShown();
    void theHintCountsPoints();
};

void DrawToolTest::clicksPlacePointsAndTheFirstOneCloses() {
    QFETCH(ToolId, tool);
    ChainDrawer drive(tool);
    drive.points(triangle);
    QVERIFY(drive.level().objects.empty());
    QVERIFY(drive.toolbox.isBusy());
    drive.click(triangle.front());
    QCOMPARE(drive.level().objects.size(), 1);
    QVERIFY(worldPoints(drive.newest()) == triangle);
    QVERIFY(tool == ToolId::Polygon || drive.isClosed());
    QVERIFY(!drive.toolbox.isBusy());
    QCOMPARE(drive.document.history(), (std::vector<Label>{{labelOf(tool), 1}}));
}

void DrawToolTest::whatIsDrawnIsAStaticWall() {
    QFETCH(ToolId, tool);
    ChainDrawer drive(tool);
    drive.points({{1, 1}, {3, 1}, {3, 3}, {1, 1}});
    const auto& body = std::get<BodyObject>(drive.newest().data);
    QCOMPARE(body.kind, BodyKind::Static);
    QVERIFY(body.position == (tool == ToolId::Polygon ? Vec2(2, 2) : Vec2(1, 1))); // the middle, or where it begins
    QCOMPARE(body.angle, 0.0);
    QCOMPARE(body.filter.tags.bits, TagMask::bit(wallTag).bits);
    QCOMPARE(body.shapes.size(), std::size_t{1});
    QVERIFY(drive.newest().key != 0);
    QVERIFY(drive.document.selection() == Selection({drive.newest().key}));
    QCOMPARE(drive.toolbox.current(), tool); // ready for the next
    drive.points({{1, 1}, {3, 1}, {3, 3}, {1, 1}});
    QCOMPARE(drive.level().objects.size(), 2);
    QVERIFY(drive.level().objects[0].key != drive.level().objects[1].key);
}

void DrawToolTest::aChainEndsOpen_data() {
    QTest::addColumn<ToolId>("tool");
    QTest::addColumn<int>("how");
    QTest::newRow("edge, enter") << ToolId::Edge << 0;
    QTest::newRow("edge, secondary") << ToolId::Edge << 1;
    QTest::newRow("edge, double click") << ToolId::Edge << 2;
    QTest::newRow("line, enter") << ToolId::Line << 0;
    QTest::newRow("line, secondary") << ToolId::Line << 1;
    QTest::newRow("line, double click") << ToolId::Line << 2;
}

void DrawToolTest::aChainEndsOpen() {
    QFETCH(ToolId, tool);
    QFETCH(int, how);
    ChainDrawer drive(tool);
    drive.click({{0, 0}, {2, 0}});
    if (how == 2) {
        drive.doubleClick({2, 2});
    } else {
        drive.click({2, 2});
        if (how == 0) {
            drive.key(ToolKey::Enter);
        } else {
            QVERIFY(drive.secondaryClick({5, 5}));
        }
    }
    QCOMPARE(drive.level().objects.size(), 1);
    QVERIFY(worldPoints(drive.newest()) == triangle);
    QVERIFY(!drive.isClosed());
    QVERIFY(!drive.toolbox.isBusy());
}

void DrawToolTest::aPolygonClosesHoweverItEnds_data() {
    QTest::addColumn<int>("how");
    QTest::newRow("enter") << 0;
    QTest::newRow("secondary") << 1;
    QTest::newRow("double click") << 2;
}

void DrawToolTest::aPolygonClosesHoweverItEnds() {
    QFETCH(int, how);
    ChainDrawer drive(ToolId::Polygon);
    drive.click({{0, 0}, {2, 0}});
    if (how == 2) {
        drive.doubleClick({2, 2});
    } else {
        drive.click({2, 2});
        how == 0 ? drive.key(ToolKey::Enter) : static_cast<void>(drive.secondaryClick({5, 5}));
    }
    QCOMPARE(drive.level().objects.size(), 1);
    QVERIFY(worldPoints(drive.newest()) == triangle);
}

void DrawToolTest::tooFewPointsAreKept_data() {
    QTest::addColumn<ToolId>("tool");
    QTest::addColumn<int>("points");
    QTest::newRow("edge") << ToolId::Edge << 1;
    QTest::newRow("line") << ToolId::Line << 1;
    QTest::newRow("polygon of one") << ToolId::Polygon << 1;
    QTest::newRow("polygon of two") << ToolId::Polygon << 2;
}

void DrawToolTest::tooFewPointsAreKept() {
    QFETCH(ToolId, tool);
    QFETCH(int, points);
    ChainDrawer drive(tool);
    drive.points({triangle.begin(), triangle.begin() + points});
    drive.key(ToolKey::Enter);
    QCOMPARE(drive.hintCode(), std::string(labelOf(tool).text()) + ".too-few");
    QVERIFY(drive.secondaryClick({5, 5})); // no menu in the middle of a shape
    QVERIFY(drive.toolbox.isBusy());
    QVERIFY(drive.level().objects.empty());
    drive.points({triangle.begin() + points, triangle.end()});
    drive.key(ToolKey::Enter);
    QVERIFY(worldPoints(drive.newest()) == triangle);
}

void DrawToolTest::backspaceDropsTheLastPoint() {
    QFETCH(ToolId, tool);
    ChainDrawer drive(tool);
    drive.click({{0, 0}, {2, 0}, {7, 7}});
    drive.key(ToolKey::Backspace);
    drive.click({2, 2});
    drive.key(ToolKey::Enter);
    QVERIFY(worldPoints(drive.newest()) == triangle);
    drive.click({0, 0});
    drive.key(ToolKey::Backspace);
    QVERIFY(!drive.toolbox.isBusy());
    QCOMPARE(drive.level().objects.size(), 1); // and it deleted nothing
}

void DrawToolTest::escapeCancelsTheShape() {
    QFETCH(ToolId, tool);
    ChainDrawer drive(tool);
    drive.click({{0, 0}, {2, 0}});
    drive.key(ToolKey::Escape);
    QVERIFY(!drive.toolbox.isBusy());
    QVERIFY(drive.level().objects.empty());
    QCOMPARE(drive.toolbox.current(), tool);
    drive.points(triangle);
    drive.key(ToolKey::Enter);
    QVERIFY(worldPoints(drive.newest()) == triangle);
}

void DrawToolTest::theFirstDragDrawsASegment() {
    ChainDrawer drive(ToolId::Line);
    drive.drag({0.1, 0}, {2, 0.9});
    QVERIFY(drive.toolbox.isBusy());
    drive.key(ToolKey::Enter);
    QVERIFY(worldPoints(drive.newest()) == (std::vector<Vec2>{{0, 0}, {2, 1}}));
    drive.press({5, 5});
    drive.move({6, 6});
    drive.move({5, 5});
    drive.release({5, 5}); // a drag that comes back is a click
    drive.click({6, 5});
    drive.key(ToolKey::Enter);
    QVERIFY(worldPoints(drive.newest()) == (std::vector<Vec2>{{5, 5}, {6, 5}}));
}

void DrawToolTest::laterDragsAdjustTheirPoint() {
    ChainDrawer drive(ToolId::Edge);
    drive.click({0, 0});
    drive.drag({2, 0}, {3, 1});
    drive.key(ToolKey::Enter);
    QVERIFY(worldPoints(drive.newest()) == (std::vector<Vec2>{{0, 0}, {3, 1}}));
}

void DrawToolTest::escapeDuringADragKeepsThePointsPlaced() {
    ChainDrawer drive(ToolId::Edge);
    drive.click({{0, 0}, {2, 0}});
    drive.press({3, 3});
    drive.move({4, 4});
    drive.key(ToolKey::Escape);
    drive.release({4, 4});
    QVERIFY(drive.toolbox.isBusy());
    drive.click({2, 2});
    drive.key(ToolKey::Enter);
    QVERIFY(worldPoints(drive.newest()) == triangle);
}

void DrawToolTest::noSegmentHasZeroLength() {
    QFETCH(ToolId, tool);
    ChainDrawer drive(tool);
    drive.click({{0, 0}, {2, 0}, {2.05, 0.05}}); // the same grid point
    QCOMPARE(drive.hintCode(), std::string(labelOf(tool).text()) + ".same-point");
    drive.move({2, 1});
    QCOMPARE(drive.hintCode(), std::string(labelOf(tool).text()) + ".next");
    drive.click({{2, 2}, {2, 2}});
    drive.key(ToolKey::Enter);
    QVERIFY(worldPoints(drive.newest()) == triangle);
}

void DrawToolTest::shiftAndCtrlChangeWhereAPointLands() {
    ChainDrawer drive(ToolId::Line);
    drive.click({0, 0});
    drive.held = {true, false, false};
    drive.click({2, 0.2});
    drive.held = {false, true, false};
    drive.click({3.1, 0.33});
    drive.key(ToolKey::Enter);
    QVERIFY(worldPoints(drive.newest()) == (std::vector<Vec2>{{0, 0}, {2, 0}, {3.1, 0.33}}));
}

void DrawToolTest::closingIsPossibleOffTheGrid() {
    ChainDrawer drive(ToolId::Edge);
    drive.held.ctrl = true;
    drive.click({0.11, 0.13});
    drive.held.ctrl = false;
    drive.click({{2, 0}, {2, 2}, {0.11 + 9.0 / 66, 0.13}}); // nine pixels from the first point
    QVERIFY(drive.isClosed());
    drive.held.ctrl = true;
    drive.click({{5, 5}, {7, 5}, {7, 7}, {5 + 11.0 / 66, 5}}); // eleven
    QCOMPARE(drive.level().objects.size(), 1);
}

void DrawToolTest::theRingShowsWhereAClickCloses() {
    ChainDrawer drive(ToolId::Edge);
    const auto rings = [&drive] {
        const Overlay overlay = drive.toolbox.overlay();
        return std::count_if(overlay.points.begin(), overlay.points.end(),
                             [](const OverlayPoint& point) { return point.style == OverlayStyle::HotHandle; });
    };
    drive.click({{0, 0}, {2, 0}});
    drive.move({0, 0});
    QCOMPARE(rings(), 0); // two points close nothing
    drive.click({2, 2});
    QCOMPARE(rings(), 0);
    drive.move({0.05, 0.05});
    QCOMPARE(rings(), 1);
    QCOMPARE(drive.toolbox.cursor(), CursorShape::Pointing);
    drive.move({1, 1});
    QCOMPARE(rings(), 0);
    QCOMPARE(drive.toolbox.cursor(), CursorShape::Cross);
}

void DrawToolTest::theSolidSideLiesToTheRight() {
    const auto shades = [](ToolId tool) {
        ChainDrawer drive(tool);
        drive.click({0, 0});
        drive.move({2, 0});
        std::vector<OverlayLine> lines = drive.toolbox.overlay().lines;
        std::erase_if(lines, [](const OverlayLine& line) { return line.style != OverlayStyle::SolidSide; });
        return lines;
    };
    QVERIFY(shades(ToolId::Line).empty());
    const std::vector<OverlayLine> lines = shades(ToolId::Edge);
    QCOMPARE(lines.size(), std::size_t{1});
    QVERIFY(lines.front().points == (std::vector<Vec2>{{0, 0}, {2, 0}})); // the way along it
    QCOMPARE(lines.front().depth, noBack);
}

void DrawToolTest::lengthAndAngleAreShown() {
    ChainDrawer drive(ToolId::Line);
    drive.click({1, 1});
    drive.move({1, 3});
    const Overlay overlay = drive.toolbox.overlay();
    QCOMPARE(overlay.texts.size(), std::size_t{1});
    QCOMPARE(QString::fromStdString(overlay.texts.front().text), QString::fromUtf8("2.00 m  90°"));
    QVERIFY(overlay.texts.front().at == Vec2(1, 3)); // beside the pointer
}

void DrawToolTest::theHintCountsPoints() {
    ChainDrawer drive(ToolId::Edge);
    drive.move({0, 0});
    QCOMPARE(drive.hintCode(), std::string("draw-edge.start"));
    drive.click({{0, 0}, {2, 0}});
    drive.move({2, 1});
    QCOMPARE(drive.toolbox.hint(), (Hint{"draw-edge.next", {"2", "1.00", "90"}}));
    drive.click({2, 2});
    drive.move({0, 0});
    QCOMPARE(drive.toolbox.hint(), (Hint{"draw-edge.close", {"3"}}));
}

SPACETOW_TEST(DrawToolTest)
#include "draw_tool_test.moc"
