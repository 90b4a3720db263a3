#include "editor/editing/handles.h"

#include "core/geometry/polygon.h"
#include "core/level/bounds.h"
#include "core/level/groups.h"
#include "core/level/object_geometry.h"
#include "tests/support/drive.h"
#include "tests/support/test_main.h"

#include <algorithm>
#include <array>
#include <numbers>

using namespace spacetow;
using namespace spacetow::test;

Q_DECLARE_METATYPE(spacetow::Modifiers)
Q_DECLARE_METATYPE(spacetow::Vec2)
Q_DECLARE_METATYPE(spacetow::HandleSide)

namespace {

/// A room of 2 m × 1 m (1), solid inside; a ball (2) at (5, 0) with radius 0.5; the ship (3) at (-4, 0).
Level scene() {
    Level level;
    level.objects.append(bodyWith(1, EdgeChain{{{0, 0}, {2, 0}, {2, 1}, {0, 1}}, true, noBack}));
    level.objects.append(bodyWith(2, Circle{{0, 0}, 0.5}, {5, 0}));
    level.objects.append({3, "", ShipObject{{-4, 0}, 0}, {}});
    return level;
}

struct Handles : Drive {
    explicit Handles(std::vector<Key> keys) : Drive(scene()) { document.select(Selection(std::move(keys))); }

    Aabb box() const { return boundsOf(level(), document.selection().keys()); }
    /// Where the handle of that side is at this moment.
    Vec2 handle(const HandleSide& side) {
        const Aabb around = boundsOf(*document.current().level, document.selection().keys()).grown(10 * view.pixel());
        return side.isPivot() ? turningPlace() : pointOf(around, side);
    }
    Vec2 turningPlace() { return handleFrame(toolbox.context()).pivot; }
    void dragHandle(const HandleSide& side, const Vec2& way) {
        const Vec2 from = handle(side);
        drag(from, from + way);
    }
    /// Turns the upper right handle about the pivot.
    void turnBy(double degrees) {
        const Vec2 from = handle({1, 1});
        const Vec2 pivot = turningPlace();
        const Rot turn = Rot::fromAngle(degrees * std::numbers::pi / 180);
        drag(from, pivot + turn * Vec2(from - pivot));
    }
    void clickAgain(const Vec2& at) { click(at); }
    int shown(OverlayStyle style) const {
        const std::vector<OverlayPoint> points = toolbox.overlay().points;
        return static_cast<int>(std::ranges::count(points, style, &OverlayPoint::style));
    }
    double angleOf(Key key) const { return std::get<BodyObject>(level().objects.find(key)->data).angle; }
    Vec2 placeOf(Key key) const { return *spacetow::placeOf(level().objects.find(key)->data); }
};

bool isNear(const Vec2& a, const Vec2& b) {
    return (a - b).norm() < 1e-9;
}

} // namespace

class HandlesTest : public QObject {
    Q_OBJECT

  private slots:
    void theOriginOfASingleBodyIsShownWhereItIsNotItsMiddle() {
        Handles drive({1}); // its origin is a corner
        QCOMPARE(drive.shown(OverlayStyle::Origin), 1);
        drive.document.select(Selection({2}));
        QCOMPARE(drive.shown(OverlayStyle::Origin), 0);
        drive.document.select(Selection({3})); // the ship turns about it
        QCOMPARE(drive.shown(OverlayStyle::Origin), 0);
        drive.document.select(Selection({1, 2}));
        QCOMPARE(drive.shown(OverlayStyle::Origin), 0);
    }

    void aSelectionHasEightHandlesAndASecondClickTurnsThem() {
        Handles drive({});
        drive.click({1, 0}); // the wall
        QCOMPARE(drive.shown(OverlayStyle::Handle), 8);
        drive.click({1, 0});
        QCOMPARE(drive.shown(OverlayStyle::Handle), 0);
        QCOMPARE(drive.shown(OverlayStyle::TurnHandle), 4);
        QCOMPARE(drive.shown(OverlayStyle::Pivot), 1);
        drive.click({1, 0});
        QCOMPARE(drive.shown(OverlayStyle::Handle), 8);
        drive.click({1, 0});
        drive.click({5, 0}); // another selection begins anew
        QCOMPARE(drive.shown(OverlayStyle::Handle), 8);
        QVERIFY(drive.document.history().empty());
    }

    void handlesStayWhileThePointerIsElsewhere() {
        Handles drive({1});
        drive.move({1, 3});
        drive.toolbox.leave();
        QCOMPARE(drive.shown(OverlayStyle::Handle), 8);
    }

    void aClickOnAHandleKeepsTheSelection() {
        Handles drive({1});
        drive.click(drive.handle({1, 1}));
        QCOMPARE(drive.document.selection().keys(), (std::vector<Key>{1}));
    }

    void scaling_data() {
        QTest::addColumn<HandleSide>("side");
        QTest::addColumn<Vec2>("way");
        QTest::addColumn<Modifiers>("held");
        QTest::addColumn<Vec2>("min");
        QTest::addColumn<Vec2>("max");

        QTest::newRow("corner") << HandleSide{1, 1} << Vec2(1, 0.5) << none << Vec2(0, 0) << Vec2(3, 1.5);
        QTest::newRow("other corner") << HandleSide{-1, -1} << Vec2(-1, -0.5) << none << Vec2(-1, -0.5) << Vec2(2, 1);
        QTest::newRow("side") << HandleSide{1, 0} << Vec2(1, 4) << none << Vec2(0, 0) << Vec2(3, 1);
        QTest::newRow("upper side") << HandleSide{0, 1} << Vec2(3, 1) << none << Vec2(0, 0) << Vec2(2, 2);
        QTest::newRow("on the grid") << HandleSide{1, 0} << Vec2(1.1, 0) << none << Vec2(0, 0) << Vec2(3, 1);
        QTest::newRow("alt off the grid") << HandleSide{1, 0} << Vec2(1.1, 0) << alt << Vec2(0, 0) << Vec2(3.1, 1);
        QTest::newRow("shift about the middle")
            << HandleSide{1, 1} << Vec2(1, 0.5) << shift << Vec2(-1, -0.5) << Vec2(3, 1.5);
        QTest::newRow("ctrl keeps proportions")
            << HandleSide{1, 1} << Vec2(2, 0.25) << ctrl << Vec2(0, 0) << Vec2(4, 2);
        QTest::newRow("ctrl at a side") << HandleSide{1, 0} << Vec2(2, 0) << ctrl << Vec2(0, -0.5) << Vec2(4, 1.5);
        QTest::newRow("through zero") << HandleSide{1, 0} << Vec2(-3, 0) << none << Vec2(-1, 0) << Vec2(0, 1);
        QTest::newRow("to zero leaves a step")
            << HandleSide{1, 0} << Vec2(-2, 0) << none << Vec2(0, 0) << Vec2(0.25, 1);
    }

    void scaling() {
        QFETCH(HandleSide, side);
        QFETCH(Vec2, way);
        QFETCH(Modifiers, held);
        QFETCH(Vec2, min);
        QFETCH(Vec2, max);
        Handles drive({1});
        drive.move(drive.handle(side));
        drive.held = held;
        drive.dragHandle(side, way);
        QVERIFY2(isNear(drive.box().min, min),
                 qPrintable(QString("%1 %2").arg(drive.box().min.x()).arg(drive.box().min.y())));
        QVERIFY2(isNear(drive.box().max, max),
                 qPrintable(QString("%1 %2").arg(drive.box().max.x()).arg(drive.box().max.y())));
        QCOMPARE(drive.document.undoLabel(), (Label{"scale", 1}));
        drive.document.undo();
        QVERIFY(drive.level() == scene());
    }

    void mirroredWallsStaySolidOnTheirInside() {
        Handles drive({1});
        const double before = signedArea(worldPoints(*drive.level().objects.find(1)));
        drive.dragHandle({1, 0}, {-4, 0});
        const double after = signedArea(worldPoints(*drive.level().objects.find(1)));
        QVERIFY(before * after > 0);
    }

    void aBallStaysABallUnderItsHandle() {
        Handles drive({2});
        drive.dragHandle({1, 0}, {1, 0});
        QVERIFY(isNear(drive.box().min, {4.5, -1}));
        QVERIFY(isNear(drive.box().max, {6.5, 1}));
    }

    void theShipHasNoSize() {
        Handles drive({3});
        drive.move({-4, 3});
        QCOMPARE(drive.shown(OverlayStyle::Handle), 0);
        QCOMPARE(drive.shown(OverlayStyle::TurnHandle), 4);
        QCOMPARE(drive.shown(OverlayStyle::Pivot), 0);
        const auto shape = std::get<ShipObject>(drive.level().objects.find(3)->data);
        QVERIFY(shape.angle == 0);
        drive.held = ctrl;
        drive.turnBy(90);
        QVERIFY(std::abs(std::get<ShipObject>(drive.level().objects.find(3)->data).angle - std::numbers::pi / 2) <
                1e-12);
    }

    void whatIsFlatScalesAlongItselfOnly() {
        Drive drive;
        Level level;
        level.objects.append(bodyWith(1, LineChain{{{0, 0}, {2, 0}}, false}));
        drive.document.reset(level);
        drive.document.select(Selection({1}));
        const HandleFrame frame = handleFrame(drive.toolbox.context());
        QCOMPARE(handlesOf(frame, HandleMode::Scale, 0.01).size(), std::size_t{2});
    }

    void turningGoesAboutThePivotInStepsWithCtrl() {
        Handles drive({2, 1});
        drive.clickAgain({5, 0});
        const Vec2 pivot = drive.turningPlace();
        drive.held = ctrl;
        drive.turnBy(86);
        QVERIFY(std::abs(drive.angleOf(1) - std::numbers::pi / 2) < 1e-12);
        QCOMPARE(drive.document.undoLabel(), (Label{"rotate", 2}));
        QCOMPARE(drive.document.history().size(), std::size_t{1});
        for (int i = 0; i < 3; ++i) {
            drive.turnBy(90);
        }
        QVERIFY(isNear(drive.turningPlace(), pivot));
        QVERIFY(drive.placeOf(1) == Vec2(0, 0));
        QVERIFY(drive.placeOf(2) == Vec2(5, 0));
    }

    void turningShowsItsAngle() {
        Handles drive({1});
        drive.clickAgain({1, 0});
        const Vec2 from = drive.handle({1, 1});
        const Vec2 pivot = drive.turningPlace();
        drive.move(from);
        QCOMPARE(drive.toolbox.hint().code, std::string("select.turn-handle"));
        drive.press(from);
        drive.held = ctrl;
        drive.move(pivot + Rot::fromAngle(std::numbers::pi / 4) * Vec2(from - pivot));
        QCOMPARE(drive.toolbox.hint(), (Hint{"select.turning", {"45"}}));
        QCOMPARE(drive.toolbox.overlay().texts.front().text, std::string("45°"));
        drive.key(ToolKey::Escape);
        QVERIFY(drive.level() == scene());
        QVERIFY(drive.document.history().empty());
    }

    void shiftTurnsAboutTheOppositeCorner() {
        Handles drive({1});
        drive.clickAgain({1, 0});
        const Vec2 from = drive.handle({1, 1});
        drive.press(from);
        drive.held = {true, true, false};
        const Vec2 to = Rot::fromAngle(std::numbers::pi / 2) * from; // about (0, 0)
        drive.move(to);
        drive.release(to);
        QVERIFY(isNear(drive.box().min, {-1, 0}));
        QVERIFY(isNear(drive.box().max, {0, 2}));
    }

    void thePivotSnapsToCornersAndIsTurnedAbout() {
        Handles drive({1});
        drive.clickAgain({1, 0});
        drive.drag(drive.turningPlace(), {2.03, 0.04}); // near the corner
        QVERIFY(drive.document.selection().pivot() == std::optional(Vec2(2, 0)));
        QVERIFY(drive.document.history().empty());
        drive.held = ctrl;
        drive.turnBy(90);
        QVERIFY(isNear(drive.box().min, {1, -2}));
        QVERIFY(isNear(drive.box().max, {2, 0}));
    }

    void theShipIsDraggedByItsMiddleHoweverOften_data() {
        QTest::addColumn<int>("clicks");
        QTest::newRow("selected") << 0;
        QTest::newRow("clicked") << 1;
        QTest::newRow("clicked again") << 2;
    }
    void theShipIsDraggedByItsMiddleHoweverOften() {
        QFETCH(int, clicks);
        Handles drive({3});
        for (int i = 0; i < clicks; ++i) {
            drive.click({-4, 0});
        }
        for (int i = 0; i < 3; ++i) {
            drive.drag(drive.placeOf(3), drive.placeOf(3) + Vec2(1, 0.5));
        }
        QVERIFY(isNear(drive.placeOf(3), {-1, 1.5}));
        QCOMPARE(drive.document.history().size(), std::size_t{3});
        drive.document.undo();
        QVERIFY(isNear(drive.placeOf(3), {-2, 1}));
    }

    void thePivotOfSmallThingsIsTakenWithShiftAndThatIsSaid() {
        Handles drive({3});
        QCOMPARE(drive.shown(OverlayStyle::Pivot), 0);
        drive.click({-4, 0});
        QCOMPARE(drive.shown(OverlayStyle::Pivot), 1);
        drive.move({-4, 0});
        QCOMPARE(drive.toolbox.hint().code, std::string("select.small-pivot"));
        drive.held = shift;
        drive.move({-4, 0});
        QCOMPARE(drive.toolbox.hint().code, std::string("select.pivot-handle"));
        drive.drag(drive.turningPlace(), {-3, 1});
        QVERIFY(isNear(drive.turningPlace(), {-3, 1}));
        QVERIFY(drive.placeOf(3) == Vec2(-4, 0));
        drive.held = none;
        drive.drag(drive.turningPlace(), {-4, -2}); // beside the ship it is in nobody's way
        QVERIFY(isNear(drive.turningPlace(), {-4, -2}));
        drive.held = shift;
        drive.click({-4, 0});
        QVERIFY(drive.document.selection().empty());
    }

    void aPivotThatWasPutElsewhereIsSeenAndTakenWithoutASecondClick() {
        Handles drive({3});
        drive.document.select(drive.document.selection().withPivot(Vec2(-3, 1)));
        drive.move({-4, 3});
        QCOMPARE(drive.shown(OverlayStyle::Pivot), 1);
        drive.drag({-3, 1}, {-2, 1});
        QVERIFY(isNear(drive.turningPlace(), {-2, 1}));
    }

    void thePivotGoesWithWhatIsMoved() {
        Handles drive({2});
        drive.document.select(drive.document.selection().withPivot(Vec2(5, 1)));
        drive.drag({5, 0}, {6, 0});
        QVERIFY(drive.document.selection().pivot() == std::optional(Vec2(6, 1)));
    }

    void sizeAndSharesAreSaidWhileScaling() {
        Handles drive({1});
        const Vec2 from = drive.handle({1, 1});
        drive.move(from);
        QCOMPARE(drive.toolbox.hint().code, std::string("select.scale-handle"));
        QCOMPARE(drive.toolbox.cursor(), CursorShape::SizeRising);
        drive.press(from);
        drive.move(from + Vec2(1, 1));
        QCOMPARE(drive.toolbox.hint(), (Hint{"select.scaling", {"3.00", "2.00", "150", "200"}}));
        QCOMPARE(drive.toolbox.overlay().texts.front().text, std::string("3.00 × 2.00 m"));
        drive.key(ToolKey::Escape);
        QVERIFY(drive.level() == scene());
    }

    void whatIsLockedStays() {
        Handles drive({});
        drive.document.reset(withLocked(scene(), std::array{Key{2}}, true));
        drive.document.select(Selection({1, 2}));
        const HandleFrame frame = handleFrame(drive.toolbox.context());
        QVERIFY(isNear(frame.box.max, {2, 1}));
        drive.drag({1, 0}, {1, 1});
        QVERIFY(drive.placeOf(1) == Vec2(0, 1));
        QVERIFY(drive.placeOf(2) == Vec2(5, 0));
        drive.key(ToolKey::Delete);
        QVERIFY(drive.level().objects.find(1) == nullptr);
        QVERIFY(drive.level().objects.find(2) != nullptr);
    }
};

SPACETOW_TEST(HandlesTest)
#include "handles_test.moc"
