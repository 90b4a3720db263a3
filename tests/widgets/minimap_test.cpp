// The minimap, beside the canvas.

#include "tests/support/test_main.h"
#include "tests/support/window.h"

#include <QDockWidget>
#include <QWheelEvent>

using namespace spacetow;
using spacetow::test::TestWindow;

namespace {

struct MapWindow : TestWindow {
    MapWindow() {
        drawWalls();
        window->panels().dock(QStringLiteral("minimap")).toggleViewAction()->trigger();
        QApplication::processEvents();
        map().finish();
    }
    Minimap& map() { return window->minimap(); }
    void clickMap(const Vec2& world) { QTest::mouseClick(&map(), Qt::LeftButton, {}, map().at(world).toPoint()); }
    QImage image() { return map().picture().toImage(); }
};

} // namespace

class MinimapTest : public QObject {
    Q_OBJECT

  private slots:
    void aClickGoesThereAndTheFrameShowsWhatIsInView() {
        MapWindow shown;
        QVERIFY(shown.map().isVisible());
        shown.canvas().zoom(4);
        shown.clickMap({2, 2});
        const double pixel = 4.0 / shown.map().height(); // m
        QVERIFY((shown.canvas().view().center - Vec2(2, 2)).norm() < 2 * pixel);
        QVERIFY((shown.map().shownPart().center() - shown.map().at({2, 2})).manhattanLength() < 3);
        const Aabb visible = shown.canvas().view().visible();
        QVERIFY(qAbs(shown.map().shownPart().left() - shown.map().at(visible.min).x()) < 4);
    }

    void aDragTakesTheViewAlong() {
        MapWindow shown;
        shown.canvas().zoom(8);
        const QPoint from = shown.map().at({-1, -1}).toPoint();
        const QPoint to = shown.map().at({1, 0}).toPoint();
        QTest::mousePress(&shown.map(), Qt::LeftButton, {}, from);
        QMouseEvent move(QEvent::MouseMove, to, shown.map().mapToGlobal(to), Qt::NoButton, Qt::LeftButton, {});
        QApplication::sendEvent(&shown.map(), &move);
        QTest::mouseRelease(&shown.map(), Qt::LeftButton, {}, to);
        QVERIFY((shown.canvas().view().center - Vec2(1, 0)).norm() < 0.2);
    }

    void wheelAndArrowsMoveTheView() {
        MapWindow shown;
        const double scale = shown.canvas().view().scale;
        const QPointF middle = shown.map().rect().center();
        QWheelEvent wheel(middle, middle, {}, {0, 120}, Qt::NoButton, {}, Qt::NoScrollPhase, false);
        QApplication::sendEvent(&shown.map(), &wheel);
        QVERIFY(shown.canvas().view().scale > 1.2 * scale);
        const Vec2 center = shown.canvas().view().center;
        QTest::keyClick(&shown.map(), Qt::Key_Right);
        QTest::keyClick(&shown.map(), Qt::Key_Up);
        QVERIFY(shown.canvas().view().center.x() > center.x() && shown.canvas().view().center.y() > center.y());
    }

    void itIsPaintedAnewWhenTheLevelChanges() {
        MapWindow shown;
        const QImage before = shown.image();
        QVERIFY(!before.isNull());
        shown.canvas().zoom(2);
        shown.map().finish();
        QVERIFY(shown.image() == before); // the view alone changes nothing
        shown.trigger(Act::Undo);
        shown.map().finish();
        QVERIFY(shown.image() != before);
    }

    void itFollowsTheColoursOfThePanels() {
        MapWindow shown;
        shown.window->setAppearance(Appearance::Dark);
        QApplication::processEvents();
        shown.map().finish();
        const int dark = qGray(shown.image().pixel(0, 0));
        shown.window->setAppearance(Appearance::Light);
        QApplication::processEvents();
        shown.map().finish();
        QVERIFY(qGray(shown.image().pixel(0, 0)) > dark);
    }

    void tabHidesItWithTheOtherPanelsAndBringsItBack() {
        MapWindow shown;
        shown.canvas().setFocus();
        shown.trigger(Act::HidePanels);
        QVERIFY(!shown.map().isVisible());
        shown.trigger(Act::HidePanels);
        QVERIFY(shown.map().isVisible());
    }
};

SPACETOW_TEST(MinimapTest)
#include "minimap_test.moc"
