// The view goes along with what is dragged to its edges.
#include "core/level/bounds.h"
#include "tests/support/body_with.h"
#include "tests/support/test_main.h"
#include "tests/support/window.h"

#include <QWheelEvent>

#include <chrono>
#include <cmath>

using namespace spacetow;
using namespace spacetow::test;

namespace {

/// A ball about the origin, and time that passes when the test says so.
struct Scrolling : TestWindow {
    Scrolling() {
        Level level;
        level.objects.append(bodyWith(1, Circle{{0, 0}, 0.5}));
        document().reset(level);
        canvas().setView(Viewport());
        canvas().edgeScroll().clock = [this] { return now; };
    }
    Vec2 center() { return canvas().view().center; }
    void moveTo(const QPoint& place) { QTest::mouseMove(&canvas(), place); }
    void press(const QPoint& place) {
        moveTo(place);
        QTest::mousePress(&canvas(), Qt::LeftButton, {}, place);
    }
    void release(const QPoint& place) { QTest::mouseRelease(&canvas(), Qt::LeftButton, {}, place); }
    void pass(int turns, std::chrono::milliseconds each = std::chrono::milliseconds(16)) {
        for (int i = 0; i < turns; ++i) {
            now += each;
            canvas().edgeScroll().turn();
        }
    }
    Vec2 ball() { return std::get<BodyObject>(document().shown().level->objects[0].data).position; }
    QPoint beyond(int pixels) { return {canvas().width() + pixels, canvas().height() / 2}; }

    std::chrono::steady_clock::time_point now;
};

} // namespace

class EdgeScrollTest : public QObject {
    Q_OBJECT

  private slots:
    void whatIsDraggedTakesTheViewAlong() {
        Scrolling test;
        test.press(test.at(0, 0));
        test.moveTo(test.at(1, 0));
        test.pass(10);
        QCOMPARE(test.center().x(), 0.0);
        test.moveTo(test.beyond(50));
        const Vec2 before = test.ball();
        test.pass(10);
        const double slow = test.center().x();
        QVERIFY(slow > 0.5);
        QCOMPARE(test.center().y(), 0.0);
        QVERIFY(std::abs(test.ball().x() - before.x() - slow) < 1e-9); // it stays under the pointer
        test.moveTo(test.beyond(120));
        test.pass(10);
        QVERIFY(test.center().x() - slow > slow);
        const double reached = test.center().x();
        test.moveTo(test.at(reached, 0));
        test.pass(10);
        QCOMPARE(test.center().x(), reached);
        test.release(test.at(reached, 0));
        QVERIFY(std::abs(test.ball().x() - reached) < 2 * test.canvas().view().pixel());
        test.trigger(Act::Undo);
        QCOMPARE(test.ball().x(), 0.0);
    }

    void theViewGoesAsFarHoweverOftenItIsPainted() {
        double far[2];
        for (const int turns : {1, 10}) {
            Scrolling test;
            test.press(test.at(0, 0));
            test.moveTo(test.at(1, 0));
            test.moveTo(test.beyond(50));
            test.pass(turns, std::chrono::milliseconds(80 / turns));
            far[turns == 1 ? 0 : 1] = test.center().x() / test.canvas().view().pixel();
            test.release(test.beyond(50));
        }
        QVERIFY(far[0] > 10);
        QVERIFY(std::abs(far[0] - far[1]) <= 1);
    }

    void aWindowThatHungDoesNotJump() {
        Scrolling test;
        test.press(test.at(0, 0));
        test.moveTo(test.at(1, 0));
        test.moveTo(test.beyond(50));
        test.pass(1, std::chrono::seconds(10));
        QVERIFY(test.center().x() / test.canvas().view().pixel() < 100);
        test.release(test.beyond(50));
    }

    void nodesToolsAndHandlesTakeTheViewAlong_data() {
        QTest::addColumn<int>("tool");
        QTest::addColumn<QPointF>("from");
        QTest::newRow("a node") << int(ToolId::Nodes) << QPointF(2, 2);
        QTest::newRow("a handle") << int(ToolId::Select) << QPointF(2, 2);
        QTest::newRow("a circle") << int(ToolId::Circle) << QPointF(3, 3);
        QTest::newRow("a rectangle") << int(ToolId::Rectangle) << QPointF(3, 3);
        QTest::newRow("a line that is dragged") << int(ToolId::Line) << QPointF(3, 3);
    }
    void nodesToolsAndHandlesTakeTheViewAlong() {
        QFETCH(int, tool);
        QFETCH(QPointF, from);
        Scrolling test;
        test.drawWalls();
        test.canvas().setView(Viewport());
        test.document().select(Selection({test.level().objects[1].key}));
        test.trigger(ToolId(tool));
        const double right = test.canvas().view().visible().max.x();
        test.press(test.at(from.x(), from.y()));
        test.moveTo(test.at(4, 3));
        test.moveTo(test.beyond(50));
        test.pass(20);
        const double reached = test.center().x();
        QVERIFY(reached > 2);
        test.release(test.beyond(50));
        test.key(Qt::Key_Return);
        test.pass(20);
        QCOMPARE(test.center().x(), reached);
        QVERIFY(boundsOf(test.level()).max.x() > right + reached);
    }

    void thePointerAloneMovesNothing() {
        Scrolling test;
        test.trigger(ToolId::Edge);
        test.click(0, 0);
        test.moveTo(test.at(1, 0));
        test.moveTo({test.canvas().width() - 2, 200});
        test.pass(10);
        test.moveTo(test.beyond(50));
        test.pass(10);
        QVERIFY(test.center() == Vec2(0, 0));
    }

    void theEdgeItselfIsEnoughForAWindowThatFillsTheScreen() {
        Scrolling test;
        test.press(test.at(0, 0));
        test.moveTo({2, 2});
        test.pass(10);
        QVERIFY(test.center().x() < 0 && test.center().y() > 0);
        test.release({2, 2});
    }

    void aBandGrowsBeyondTheView() {
        Scrolling test;
        const QPoint corner = test.at(-1, -1);
        test.press(corner);
        test.moveTo(test.at(-1.5, -1.5));
        test.moveTo({test.at(-1, 0).x(), -40});
        test.pass(40);
        QVERIFY(test.center().y() > 1);
        test.moveTo(test.at(1, 3));
        test.release(test.at(1, 3));
        QVERIFY(test.document().selection() == Selection({1}));
    }

    void aDragThatBeginsAtTheEdgeLeavesTheViewUntilItHasBeenInside() {
        Scrolling test;
        test.press({3, 200});
        test.moveTo({3, 260});
        test.pass(10);
        QVERIFY(test.center() == Vec2(0, 0));
        test.moveTo({200, 260});
        test.moveTo({3, 260});
        test.pass(10);
        QVERIFY(test.center().x() < 0);
        test.release({3, 260});
        const Vec2 left = test.center();
        test.pass(10);
        QVERIFY(test.center() == left);
    }

    void nobodyScrollsAfterTheDrag_data() {
        QTest::addColumn<int>("end");
        QTest::newRow("released") << 0;
        QTest::newRow("Escape") << 1;
        QTest::newRow("the mouse is lost") << 2;
    }
    void nobodyScrollsAfterTheDrag() {
        QFETCH(int, end);
        Scrolling test;
        test.press(test.at(0, 0));
        test.moveTo(test.at(1, 0));
        test.moveTo(test.beyond(50));
        test.pass(1);
        if (end == 0) {
            test.release(test.beyond(50));
        } else if (end == 1) {
            test.key(Qt::Key_Escape);
        } else {
            test.canvas().loseMouse();
        }
        const Vec2 left = test.center();
        test.pass(5);
        QVERIFY(test.center() == left);
        test.moveTo(test.beyond(60));
        test.pass(5);
        QVERIFY(test.center() == left);
    }

    void spaceAndTheWheelMoveTheViewInTheMiddleOfADrag() {
        Scrolling test;
        test.press(test.at(0, 0));
        test.moveTo(test.at(1, 0));
        const Vec2 held = test.ball();
        QTest::keyPress(&test.canvas(), Qt::Key_Space);
        test.moveTo(test.at(-1, 0));
        QTest::keyRelease(&test.canvas(), Qt::Key_Space);
        QVERIFY(std::abs(test.center().x() - 2) < 0.1);
        QVERIFY((test.ball() - held).norm() < 2 * test.canvas().view().pixel());
        const QPoint place = test.at(1, 0);
        QWheelEvent wheel(place, test.canvas().mapToGlobal(place), QPoint(), QPoint(0, -120), Qt::LeftButton, {},
                          Qt::NoScrollPhase, false);
        const double scale = test.canvas().view().scale;
        QApplication::sendEvent(&test.canvas(), &wheel);
        QVERIFY(test.canvas().view().scale < scale);
        QVERIFY((test.ball() - held).norm() < 2 * test.canvas().view().pixel());
        test.moveTo(test.at(4, 0));
        test.release(test.at(4, 0));
        QVERIFY(std::abs(test.ball().x() - 4) < 2 * test.canvas().view().pixel());
    }

    void aGuideIsDraggedBackOntoItsRulerWithoutTheView() {
        Scrolling test;
        Level level = test.level();
        level.guides.push_back({{0, 2}, 0, ""});
        test.document().reset(level);
        test.canvas().setView(Viewport());
        test.press(test.at(2, 2));
        test.moveTo(test.at(2, 1));
        test.moveTo({300, -10});
        test.pass(10);
        QVERIFY(test.center() == Vec2(0, 0));
        test.release({300, -10});
        QVERIFY(test.level().guides.empty());
    }
};

SPACETOW_TEST(EdgeScrollTest)
#include "edge_scroll_test.moc"
