// What polygons need beyond chains: an order of corners, and an outline that does not cross itself.

#include "editor/editing/draw_tool.h"

#include "core/base/random.h"
#include "core/geometry/polygon.h"
#include "tests/support/drive.h"
#include "tests/support/test_main.h"

#include <algorithm>
#include <numbers>

using namespace spacetow;
using namespace spacetow::test;

namespace {

struct PolygonDrawer : Drive {
    PolygonDrawer() { toolbox.choose(ToolId::Polygon); }
    void points(const std::vector<Vec2>& points) {
        for (const Vec2& point : points) {
            click(point);
        }
    }
    std::string hintCode() const { return toolbox.hint().code; }
};

} // namespace

class DrawPolygonTest : public QObject {
    Q_OBJECT

  private slots:
    void whatIsHalfDrawnIsKnownToTheJournal();
    void polygonsAreAnticlockwise();
    void aPolygonThatCrossesItselfIsRefused();
    void aSideThroughAnotherIsMarkedWhileItIsDrawn();
    void aFlatPolygonIsRefused();
    void aPolygonOfAThousandCornersIsDrawn();
};

void DrawPolygonTest::polygonsAreAnticlockwise() {
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
        Random random(seed);
        std::vector<double> angles;
        for (std::uint32_t i = 0; i < 3 + random.below(12); ++i) {
            angles.push_back(random.uniform(0, 2 * std::numbers::pi));
        }
        std::sort(angles.begin(), angles.end());
        if (random.below(2) == 0) {
            std::reverse(angles.begin(), angles.end());
        }
        std::vector<Vec2> corners;
        corners.reserve(angles.size());
        for (const double angle : angles) {
            corners.emplace_back(4 * std::cos(angle), 4 * std::sin(angle));
        }
        PolygonDrawer drive;
        drive.held.ctrl = true;
        drive.view.scale = 2000; // so that no two corners are within the closing distance
        drive.points(corners);
        drive.key(ToolKey::Enter);
        QVERIFY2(drive.level().objects.size() == 1, qPrintable(QString("seed %1").arg(seed)));
        std::vector<Vec2> drawn = worldPoints(drive.newest());
        QVERIFY(signedArea(drawn) > 0);
        QVERIFY((drawn.front() - corners.front()).norm() < 1e-11);
        if (signedArea(corners) < 0) {
            std::reverse(drawn.begin() + 1, drawn.end());
        }
        for (std::size_t i = 0; i < corners.size(); ++i) {
            QVERIFY2((drawn[i] - corners[i]).norm() < 1e-11, qPrintable(QString("seed %1").arg(seed)));
        }
    }
}

void DrawPolygonTest::aPolygonThatCrossesItselfIsRefused() {
    PolygonDrawer drive;
    drive.click({{0, 0}, {2, 2}, {2, 0}, {0, 2}});
    drive.key(ToolKey::Enter);
    QVERIFY(drive.level().objects.empty());
    QCOMPARE(drive.hintCode(), std::string("draw-polygon.crosses"));
    drive.click({0, 0}); // closing by click is refused as well
    QVERIFY(drive.level().objects.empty());
    drive.key(ToolKey::Backspace);
    QCOMPARE(drive.hintCode(), std::string("draw-polygon.close")); // the pointer is still on the first corner
    drive.click({0, 0});
    QCOMPARE(worldPoints(drive.newest()).size(), std::size_t{3});
}

void DrawPolygonTest::aSideThroughAnotherIsMarkedWhileItIsDrawn() {
    PolygonDrawer drive;
    const auto marked = [&drive] {
        const std::vector<OverlayLine> lines = drive.toolbox.overlay().lines;
        return std::ranges::count_if(lines, [](const OverlayLine& line) { return line.style == OverlayStyle::Fault; });
    };
    drive.click({{0, 0}, {2, 2}, {2, 0}});
    drive.move({3, 2});
    QCOMPARE(drive.hintCode(), std::string("draw-polygon.next"));
    QCOMPARE(marked(), 0);
    drive.move({0, 2});
    QCOMPARE(drive.hintCode(), std::string("draw-polygon.crossing"));
    QCOMPARE(marked(), 1);
    drive.move({2, 1}); // back over the last side
    QCOMPARE(drive.hintCode(), std::string("draw-polygon.crossing"));
    drive.click({0, 2});
    drive.move({0, 3});
    QCOMPARE(drive.hintCode(), std::string("draw-polygon.crossed")); // and goes on saying so
    QCOMPARE(marked(), 1);
    drive.click({0, 3});
    drive.key(ToolKey::Backspace);
    QCOMPARE(drive.hintCode(), std::string("draw-polygon.crossed"));
    drive.key(ToolKey::Backspace);
    drive.move({3, 2});
    QCOMPARE(drive.hintCode(), std::string("draw-polygon.next"));
    QCOMPARE(marked(), 0);
}

void DrawPolygonTest::aFlatPolygonIsRefused() {
    PolygonDrawer drive;
    drive.click({{0, 0}, {1, 0}, {3, 0}});
    drive.key(ToolKey::Enter);
    QVERIFY(drive.level().objects.empty());
    QCOMPARE(drive.hintCode(), std::string("draw-polygon.flat"));
    drive.click({3, 3});
    drive.key(ToolKey::Enter);
    QCOMPARE(worldPoints(drive.newest()).size(), std::size_t{4});
}

void DrawPolygonTest::aPolygonOfAThousandCornersIsDrawn() {
    PolygonDrawer drive;
    drive.held.ctrl = true;
    drive.view.scale = 20000;
    const std::vector<Vec2> corners = regularPolygon(1000, 5);
    drive.points(corners);
    drive.click(corners.front());
    QCOMPARE(worldPoints(drive.newest()).size(), std::size_t{1000});
}

void DrawPolygonTest::whatIsHalfDrawnIsKnownToTheJournal() {
    Drive drive;
    drive.toolbox.choose(ToolId::Polygon);
    QVERIFY(!drive.toolbox.unfinished());
    drive.click({{0, 0}, {2, 0}});
    for (const bool enough : {false, true}) {
        if (enough) {
            drive.click({2, 2});
        }
        const std::optional<Edit> edit = drive.toolbox.unfinished();
        QVERIFY(edit.has_value());
        QCOMPARE(edit->level->objects.size(), 1);
        const LevelShape& shape = std::get<BodyObject>(edit->level->objects[0].data).shapes.front();
        QCOMPARE(std::holds_alternative<Polygon>(shape), enough); // else a line through what there is
    }
    QVERIFY(drive.toolbox.isBusy() && drive.level().objects.empty()); // and goes on
}

SPACETOW_TEST(DrawPolygonTest)
#include "draw_polygon_test.moc"
