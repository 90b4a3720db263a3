#include "editor/editing/rectangle_tool.h"

#include "core/geometry/polygon.h"
#include "core/level/bounds.h"
#include "editor/editing/drawn_body.h"
#include "editor/editing/verbs.h"
#include "tests/support/drive.h"
#include "tests/support/test_main.h"

#include <numbers>

using namespace spacetow;
using namespace spacetow::test;

namespace {

struct RectangleDrawer : Drive {
    RectangleDrawer() { toolbox.choose(ToolId::Rectangle); }
    std::vector<Vec2> corners() const { return worldPoints(newest()); }
};

using Corners = std::vector<Vec2>;

} // namespace

class RectangleToolTest : public QObject {
    Q_OBJECT

  private slots:
    void aDragDrawsFromCornerToCorner() {
        RectangleDrawer drive;
        drive.press({3, 2});
        drive.move({1, 1.5});
        QCOMPARE(drive.level().objects.size(), 1); // while dragging
        QCOMPARE(drive.toolbox.hint(), (Hint{"draw-rectangle.size", {"2.00", "0.50"}}));
        QVERIFY(drive.document.history().empty());
        drive.move({1, 1});
        drive.release({1, 1});
        QVERIFY(drive.corners() == (Corners{{1, 1}, {3, 1}, {3, 2}, {1, 2}}));
        const auto& body = std::get<BodyObject>(drive.newest().data);
        QVERIFY(std::holds_alternative<Polygon>(body.shapes.front()));
        QVERIFY(signedArea(std::get<Polygon>(body.shapes.front()).vertices) > 0);
        QCOMPARE(body.kind, BodyKind::Static);
        QVERIFY(body.filter.tags == TagMask::bit(wallTag));
        QCOMPARE(drive.document.history(), (std::vector<Label>{{"draw-rectangle", 1}}));
        QVERIFY(drive.document.selection() == Selection({drive.newest().key}));
        drive.document.undo();
        QVERIFY(drive.level().objects.empty());
    }

    void itTurnsAboutItsPlaceAsWhenItsAngleIsTyped_data() {
        QTest::addColumn<Vec2>("corner");
        QTest::addColumn<Vec2>("place");
        QTest::newRow("even") << Vec2(2, 1) << Vec2(1, 0.5);
        QTest::newRow("whose middle is off the grid") << Vec2(1, 0.75) << Vec2(0.5, 0.5);
        QTest::newRow("thin") << Vec2(3.25, 0.25) << Vec2(1.75, 0.25);
    }
    void itTurnsAboutItsPlaceAsWhenItsAngleIsTyped() {
        QFETCH(Vec2, corner);
        QFETCH(Vec2, place);
        RectangleDrawer drive;
        drive.drag({0, 0}, corner);
        const auto body = [&] { return std::get<BodyObject>(drive.newest().data); };
        QVERIFY(body().position == place);
        const ShapeList drawn = body().shapes;
        drive.toolbox.finish(rotateSelected(drive.toolbox.context(), std::numbers::pi / 4));
        QVERIFY(body().position == place && body().shapes == drawn);
        QVERIFY(std::abs(body().angle - std::numbers::pi / 4) < 1e-12);
        // Also where it has been moved off the grid since.
        drive.document.select(Selection({drive.newest().key}));
        drive.toolbox.finish(nudgeSelected(drive.toolbox.context(), {0.013, 0.017}));
        drive.toolbox.finish(rotateSelected(drive.toolbox.context(), std::numbers::pi / 4));
        QVERIFY((body().position - place - Vec2(0.013, 0.017)).norm() < 1e-12);
        QVERIFY(std::abs(body().angle - std::numbers::pi / 2) < 1e-12);
    }

    void whatIsSmallerThanAStepOfTheGridHasItsPlaceInItself() {
        for (const double step : {1.0, 0.25, 0.1}) {
            RectangleDrawer drive;
            drive.toolbox.snap.step = step;
            const Edit edit = withDrawnPolygon(
                drive.toolbox.context(), {{0.42, 0.42}, {0.47, 0.42}, {0.47, 0.47}, {0.42, 0.47}}, BodyKind::Static);
            drive.document.commit({"draw-rectangle", 1}, edit);
            const Aabb box = boundsOf(drive.level(), drive.newest());
            QVERIFY(box.contains(std::get<BodyObject>(drive.newest().data).position));
            QVERIFY(box.contains(*turningPoint(drive.toolbox.context())));
        }
    }

    void twoClicksDrawToo() {
        RectangleDrawer drive;
        drive.click({0, 0});
        QVERIFY(drive.toolbox.isBusy());
        drive.click({2, 1});
        QVERIFY(drive.corners() == (Corners{{0, 0}, {2, 0}, {2, 1}, {0, 1}}));
        QVERIFY(!drive.toolbox.isBusy());
    }

    void enterTakesTheCornerWhereThePointerIs() {
        RectangleDrawer drive;
        drive.click({0, 0});
        drive.move({2, 1});
        drive.key(ToolKey::Enter);
        QCOMPARE(drive.corners().size(), std::size_t{4});
    }

    void shiftDrawsFromTheMiddleAndCtrlASquare_data() {
        QTest::addColumn<bool>("shift");
        QTest::addColumn<bool>("ctrl");
        QTest::addColumn<double>("left");
        QTest::addColumn<double>("bottom");
        QTest::addColumn<double>("right");
        QTest::addColumn<double>("top");
        QTest::newRow("shift") << true << false << -1.0 << -2.0 << 3.0 << 4.0;
        QTest::newRow("ctrl") << false << true << 1.0 << 1.0 << 4.0 << 4.0;
        QTest::newRow("both") << true << true << -2.0 << -2.0 << 4.0 << 4.0;
    }
    void shiftDrawsFromTheMiddleAndCtrlASquare() {
        QFETCH(bool, shift);
        QFETCH(bool, ctrl);
        QFETCH(double, left);
        QFETCH(double, bottom);
        QFETCH(double, right);
        QFETCH(double, top);
        RectangleDrawer drive;
        drive.held = {shift, ctrl, false};
        drive.drag({1, 1}, {3.1, 4.1}); // the grid holds with Ctrl too
        QVERIFY(drive.corners() == (Corners{{left, bottom}, {right, bottom}, {right, top}, {left, top}}));
    }

    void altLeavesTheGrid() {
        RectangleDrawer drive;
        drive.held.alt = true;
        drive.drag({0, 0}, {1.1, 0.6});
        QVERIFY(drive.corners()[2] == Vec2(1.1, 0.6));
    }

    void whatIsOnTheGridIsSpelledSo() {
        RectangleDrawer drive;
        drive.toolbox.snap.step = 0.1;
        drive.drag({0.1, 0.1}, {0.7, 0.3});
        const auto& body = std::get<BodyObject>(drive.newest().data);
        QVERIFY(std::get<Polygon>(body.shapes.front()).vertices ==
                (Corners{{-0.3, -0.1}, {0.3, -0.1}, {0.3, 0.1}, {-0.3, 0.1}}));
    }

    void whatHasNoAreaIsNotDrawnAndSaysWhy() {
        RectangleDrawer drive;
        drive.press({0, 0});
        drive.move({2, 0});
        QCOMPARE(drive.toolbox.hint().code, std::string("draw-rectangle.too-small"));
        drive.release({2, 0});
        QVERIFY(drive.level().objects.empty());
        QVERIFY(drive.document.history().empty());
        drive.click({{0, 0}, {2, 0}});
        QCOMPARE(drive.toolbox.hint().code, std::string("draw-rectangle.too-small"));
        drive.move({2, 1});
        QCOMPARE(drive.toolbox.hint().code, std::string("draw-rectangle.size"));
        drive.click({2, 1});
        QCOMPARE(drive.level().objects.size(), 1);
    }

    void escapeAndBackspaceTakeTheFirstCornerBack() {
        RectangleDrawer drive;
        for (const ToolKey key : {ToolKey::Escape, ToolKey::Backspace}) {
            drive.click({0, 0});
            drive.key(key);
            QVERIFY(!drive.toolbox.isBusy());
        }
        drive.press({0, 0});
        drive.move({2, 2});
        drive.key(ToolKey::Escape);
        drive.release({2, 2});
        QVERIFY(drive.level().objects.empty());
    }

    void widthAndHeightAreShown() {
        RectangleDrawer drive;
        drive.click({0, 0});
        drive.move({2, 1});
        const Overlay overlay = drive.toolbox.overlay();
        QCOMPARE(overlay.texts.size(), std::size_t{1});
        QCOMPARE(QString::fromStdString(overlay.texts.front().text), QString::fromUtf8("2.00 × 1.00 m"));
        QVERIFY(overlay.texts.front().at == Vec2(2, 1));
    }
};

SPACETOW_TEST(RectangleToolTest)
#include "rectangle_tool_test.moc"
