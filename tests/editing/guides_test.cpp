#include "core/level/guides.h"
#include "editor/editing/guide_gestures.h"
#include "editor/editing/guide_verbs.h"
#include "tests/support/drive.h"
#include "tests/support/test_main.h"

#include <numbers>

using namespace spacetow;
using namespace spacetow::test;

namespace {

constexpr double quarter = std::numbers::pi / 2;

Level guidedLevel(std::initializer_list<Guide> guides) {
    Level level;
    level.guides = guides;
    return level;
}

Guide guideAt(double x, double y, double angle, const char* name = "") {
    Guide guide;
    guide.point = Vec2(x, y);
    guide.angle = angle;
    guide.name = name;
    return guide;
}

/// The world point of a place on the screen, in pixels from the upper left corner of the view.
Vec2 onScreen(const Drive& drive, double x, double y) {
    return drive.view.toWorld(Vec2(x, y));
}

/// As the rulers do it.
void dragOut(Drive& drive, double angle, const Vec2& from, const Vec2& to) {
    drive.begin(std::make_unique<NewGuideGesture>(drive.toolbox.context(), angle), from);
    drive.move(0.5 * (from + to));
    drive.move(to);
    drive.release(to);
}

} // namespace

class GuidesTest : public QObject {
    Q_OBJECT

  private slots:
    void aGuideIsDraggedOutOfARuler() {
        Drive drive;
        dragOut(drive, quarter, onScreen(drive, -10, 100), Vec2(1.02, 0.9));
        QVERIFY(drive.level().guides == std::vector{guideAt(1, 1, quarter)}); // on the grid
        QCOMPARE(drive.document.position(), 1);
        QCOMPARE(drive.document.undoLabel().code.text(), std::string("add-guide"));
        drive.document.undo();
        QVERIFY(drive.level().guides.empty());
    }

    void whatIsNotDraggedIntoTheViewIsNoGuide() {
        Drive drive;
        dragOut(drive, 0, onScreen(drive, 100, -10), onScreen(drive, 300, -2));
        QVERIFY(drive.level().guides.empty());
        QCOMPARE(drive.document.position(), 0);
    }

    void anyToolMayBeInTheHandAndGoesOnWithItsShape() {
        Drive drive;
        drive.toolbox.choose(ToolId::Polygon);
        drive.click({Vec2(0, 0), Vec2(2, 0)});
        dragOut(drive, 0, onScreen(drive, 100, -10), Vec2(0, 3));
        QCOMPARE(drive.level().guides.size(), std::size_t{1});
        QCOMPARE(drive.level().objects.size(), 0); // the click of the release is none of the tool's
        drive.click(Vec2(2, 2));
        drive.key(ToolKey::Enter);
        QCOMPARE(worldPoints(drive.newest()).size(), std::size_t{3});
    }

    void escapeDropsTheGuideAndTheReleaseThenMeansNothing() {
        Drive drive;
        drive.begin(std::make_unique<NewGuideGesture>(drive.toolbox.context(), 0.0), onScreen(drive, 100, -10));
        drive.move(Vec2(0, 1));
        QCOMPARE(drive.level().guides.size(), std::size_t{1});
        drive.key(ToolKey::Escape);
        QVERIFY(drive.level().guides.empty());
        drive.release(Vec2(0, 1));
        QVERIFY(drive.level().guides.empty());
        QCOMPARE(drive.document.position(), 0);
    }

    void aGuideIsMovedBySelectingAndInOneStep() {
        Drive drive(guidedLevel({guideAt(0, 1, 0, "floor"), guideAt(5, 0, quarter)}));
        drive.drag(Vec2(-2, 1), Vec2(-1.5, 2.01));
        QVERIFY(drive.level().guides[0] == guideAt(-1.5, 2, 0, "floor"));
        QVERIFY(drive.level().guides[1] == guideAt(5, 0, quarter));
        QCOMPARE(drive.document.position(), 1);
        drive.document.undo();
        QVERIFY(drive.level().guides[0] == guideAt(0, 1, 0, "floor"));
    }

    void ctrlTakesAGuideOffTheGrid() {
        Drive drive(guidedLevel({guideAt(0, 1, 0)}));
        drive.press(Vec2(0, 1));
        drive.held.ctrl = true;
        drive.move(Vec2(0.11, 1.62));
        drive.release(Vec2(0.11, 1.62));
        QVERIFY((drive.level().guides[0].point - Vec2(0.11, 1.62)).norm() < 1e-9);
    }

    void shiftTurnsAGuideAboutItsPoint() {
        Drive drive(guidedLevel({guideAt(1, 1, 0)}));
        drive.press(Vec2(3, 1));
        drive.held.shift = true;
        drive.move(Vec2(3, 2.9));
        drive.release(Vec2(3, 2.9));
        QCOMPARE(drive.level().guides[0].point, Vec2(1, 1));
        QVERIFY(std::abs(drive.level().guides[0].angle - std::numbers::pi / 4) < 1e-12);
    }

    void aGuideDraggedBackOntoARulerIsDeleted_data() {
        QTest::addColumn<double>("x");
        QTest::addColumn<double>("y");
        QTest::newRow("above") << 200.0 << -8.0;
        QTest::newRow("on the left") << -8.0 << 200.0;
    }
    void aGuideDraggedBackOntoARulerIsDeleted() {
        QFETCH(double, x);
        QFETCH(double, y);
        Drive drive(guidedLevel({guideAt(0, 1, 0), guideAt(5, 0, quarter)}));
        drive.drag(Vec2(0, 1), onScreen(drive, x, y));
        QVERIFY(drive.level().guides == std::vector{guideAt(5, 0, quarter)});
        QCOMPARE(drive.document.position(), 1);
        drive.document.undo();
        QCOMPARE(drive.level().guides.size(), std::size_t{2});
    }

    void objectsComeBeforeGuidesAndHiddenGuidesAreNotTaken() {
        Level level = guidedLevel({guideAt(0, 0, 0)});
        level.objects.append(bodyWith(7, Circle{Vec2(0, 0), 1}));
        Drive drive(level);
        drive.drag(Vec2(0.5, 0), Vec2(0.5, 1));
        QVERIFY(drive.level().guides == level.guides); // the circle was meant
        QVERIFY(!(drive.level() == level));
        drive.document.undo();
        drive.document.select({});
        drive.toolbox.guidesVisible = false;
        drive.drag(Vec2(3, 0), Vec2(3, 1));
        QVERIFY(drive.level() == level);
        drive.toolbox.guidesVisible = true;
        drive.drag(Vec2(3, 0), Vec2(3, 1));
        QVERIFY(drive.level().guides[0] == guideAt(3, 1, 0));
    }

    void theGuideInReachIsTheNearestOneAndTheHintSaysSo() {
        Drive drive(guidedLevel({guideAt(0, 1, 0), guideAt(0, 1.04, 0)}));
        const auto hover = [&drive](const Vec2& at) {
            drive.move(at);
            return drive.toolbox.guideInReach();
        };
        QCOMPARE(hover(Vec2(0, 0.99)), std::optional<std::size_t>(0));
        QCOMPARE(drive.toolbox.hint().code, std::string("guide.hover"));
        QCOMPARE(drive.toolbox.cursor(), CursorShape::Move);
        QCOMPARE(hover(Vec2(0, 1.05)), std::optional<std::size_t>(1));
        QVERIFY(!hover(Vec2(0, 1.5)));
        drive.toolbox.choose(ToolId::Edge);
        QVERIFY(!hover(Vec2(0, 1)));
    }

    void everyStateOfADragHasItsHint() {
        Drive drive(guidedLevel({guideAt(0, 1, 0)}));
        drive.begin(std::make_unique<NewGuideGesture>(drive.toolbox.context(), 0.0), onScreen(drive, 100, -10));
        QCOMPARE(drive.toolbox.hint().code, std::string("guide.outside"));
        drive.move(Vec2(0, 2));
        QCOMPARE(drive.toolbox.hint(), (Hint{"guide.new", {"0.00", "2.00", "0"}}));
        QCOMPARE(drive.toolbox.overlay().texts.front().text, std::string("y 2.00 m"));
        drive.release(Vec2(0, 2));
        drive.press(Vec2(0, 1));
        drive.move(Vec2(0, 1.5));
        QCOMPARE(drive.toolbox.hint().code, std::string("guide.moving"));
        drive.move(onScreen(drive, 100, -10));
        QCOMPARE(drive.toolbox.hint().code, std::string("guide.delete"));
        QVERIFY(drive.toolbox.overlay().texts.empty());
    }

    void aShiftedOrCtrlPressOnAGuideBandsAsAnywhere() {
        Level level = guidedLevel({guideAt(0, 0, 0)});
        level.objects.append(bodyWith(7, Circle{Vec2(0, 1), 0.2}));
        Drive drive(level);
        drive.held.shift = true;
        drive.drag(Vec2(-2, 0), Vec2(2, 2));
        QVERIFY(drive.level() == level);
        QVERIFY(drive.document.selection().contains(7));
    }

    void guidesAreChangedWithoutDragging() {
        Drive drive(guidedLevel({guideAt(0, 0, 0)}));
        QVERIFY(!changeGuide(drive.document.current(), 0, guideAt(0, 0, 0))); // as it was
        QVERIFY(!changeGuide(drive.document.current(), 1, guideAt(1, 0, 0)));
        QVERIFY(drive.toolbox.finish(changeGuide(drive.document.current(), 0, guideAt(1, 2, 3, "slope"))));
        QVERIFY(drive.level().guides[0] == guideAt(1, 2, 3, "slope"));
        QVERIFY(drive.toolbox.finish(addGuide(drive.toolbox.context(), Vec2(0.3, 0.9))));
        QVERIFY(drive.level().guides[1] == guideAt(0.25, 1, 0));
        QVERIFY(drive.toolbox.finish(deleteGuide(drive.document.current(), 0)));
        QVERIFY(drive.level().guides == std::vector{guideAt(0.25, 1, 0)});
        QVERIFY(drive.toolbox.finish(clearGuides(drive.toolbox.context())));
        QVERIFY(!clearGuides(drive.toolbox.context()));
        QVERIFY(drive.level().guides.empty());
        for (int i = 0; i < 4; ++i) {
            drive.document.undo();
        }
        QVERIFY(drive.level().guides == std::vector{guideAt(0, 0, 0)});
    }
};

SPACETOW_TEST(GuidesTest)
#include "guides_test.moc"
