#include "editor/canvas/canvas.h"

#include "core/level/bounds.h"
#include "core/level/edits.h"

#include "editor/window/preferences.h"
#include "tests/support/test_main.h"
#include "tests/support/window.h"

#include <QLineEdit>
#include <QMenu>
#include <QSignalSpy>
#include <QToolButton>
#include <QWheelEvent>

using namespace spacetow;
using spacetow::test::TestWindow;

namespace {

Vec2 worldAt(const Canvas& canvas, const QPoint& at) {
    return canvas.view().toWorld(Vec2(at.x(), at.y()));
}

void wheel(Canvas& canvas, const QPoint& at, int notches, Qt::KeyboardModifiers modifiers) {
    QWheelEvent event(at, canvas.mapToGlobal(at), QPoint(), QPoint(0, 120 * notches), Qt::NoButton, modifiers,
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(&canvas, &event);
}

void dragWith(Canvas& canvas, Qt::MouseButton button, const QPoint& from, const QPoint& to) {
    QTest::mousePress(&canvas, button, {}, from);
    for (int i = 1; i <= 4; ++i) {
        const QPoint at = from + (to - from) * i / 4;
        QMouseEvent move(QEvent::MouseMove, at, canvas.mapToGlobal(at), Qt::NoButton, button, {});
        QApplication::sendEvent(&canvas, &move);
    }
    QTest::mouseRelease(&canvas, button, {}, to);
}

Level levelWithABall() {
    Object ball;
    ball.key = 1;
    ball.data = BodyObject{.shapes = {Circle{{0, 0}, 1}}, .position = {3, 2}};
    return added(Level{}, ball);
}

} // namespace

class CanvasTest : public QObject {
    Q_OBJECT

  private slots:
    void anEmptyLevelSaysHowToBegin() {
        TestWindow test;
        Canvas& canvas = test.canvas();
        const auto shown = [&](const QString& words) {
            canvas.setBeginning(words);
            canvas.finishPainting();
            return canvas.grab().toImage();
        };
        QVERIFY(shown("Begin here.") != shown({}));
        test.trigger(ToolId::Edge); // who draws has begun
        test.click(-1, -1);
        QCOMPARE(shown("Begin here."), shown({}));
        QTest::keyClick(&canvas, Qt::Key_Escape);
        QTest::keyClick(&canvas, Qt::Key_Escape);
        QVERIFY(shown("Begin here.") != shown({}));
        test.drawWalls();
        QCOMPARE(shown("Begin here."), shown({}));
    }
    void theWheelZoomsAboutThePointer_data() {
        QTest::addColumn<int>("notches");
        QTest::addColumn<int>("modifiers");
        QTest::newRow("in") << 1 << 0;
        QTest::newRow("out") << -3 << 0;
        QTest::newRow("with ctrl") << 2 << static_cast<int>(Qt::ControlModifier);
    }
    void theWheelZoomsAboutThePointer() {
        QFETCH(int, notches);
        QFETCH(int, modifiers);
        TestWindow test;
        const QPoint at(200, 150);
        const Vec2 before = worldAt(test.canvas(), at);
        const double scale = test.canvas().view().scale;
        wheel(test.canvas(), at, notches, Qt::KeyboardModifiers(modifiers));
        QVERIFY((worldAt(test.canvas(), at) - before).norm() < 1e-9);
        QVERIFY(notches > 0 ? test.canvas().view().scale > scale : test.canvas().view().scale < scale);
    }

    void aFittedLevelStaysFittedUntilTheViewIsMoved() {
        Document document(levelWithABall());
        Toolbox toolbox(document);
        Canvas canvas(document, toolbox);
        canvas.resize(800, 600);
        canvas.show();
        canvas.fitLevel();
        const double fitted = canvas.view().scale;
        canvas.resize(400, 300);
        QVERIFY(canvas.view().scale < 0.6 * fitted);
        QVERIFY(canvas.view().visible().contains(boundsOf(document.level())));
        wheel(canvas, QPoint(100, 100), 1, {});
        const double zoomed = canvas.view().scale;
        canvas.resize(800, 600);
        QCOMPARE(canvas.view().scale, zoomed);
    }

    void aBarAboveLeavesTheDrawingWhereItIs_data() {
        QTest::addColumn<bool>("fitted");
        QTest::newRow("fitted") << true;
        QTest::newRow("as the view happens to be") << false;
    }
    void aBarAboveLeavesTheDrawingWhereItIs() {
        QFETCH(bool, fitted);
        TestWindow test;
        test.document().reset(levelWithABall());
        test.trigger(Act::SelectAll);
        fitted ? test.canvas().fitLevel() : test.canvas().zoom(0.7);
        const auto place = [&] { return test.canvas().mapTo(test.window.get(), test.at(3, 2)); };
        const QPoint before = place();
        const int height = test.canvas().height();
        test.trigger(Act::TypeTransform);
        QApplication::processEvents();
        QVERIFY(test.canvas().height() < height);
        QVERIFY((place() - before).manhattanLength() <= 1); // half a pixel is rounded
        test.window->transformBar().shut();
        QApplication::processEvents();
        QCOMPARE(test.canvas().height(), height);
        QCOMPARE(place(), before);
    }

    void aStrayObjectFarAwayIsShownWithTheRest_data() {
        QTest::addColumn<double>("far");
        QTest::newRow("10 km") << 1e4;
        QTest::newRow("as far as it goes") << 1e6;
    }
    void aStrayObjectFarAwayIsShownWithTheRest() {
        QFETCH(double, far);
        TestWindow test;
        Level level = levelWithABall();
        Object stray = level.objects[0];
        stray.key = 2;
        std::get<BodyObject>(stray.data).position = {far, 0};
        level = added(level, stray);
        test.trigger(Act::Grid); // off: nothing but the objects is to be seen
        test.document().reset(level);
        test.canvas().fitLevel();
        QVERIFY(test.canvas().view().visible().contains(boundsOf(level)));
        const QImage image = test.canvas().grab().toImage();
        for (const double x : {3.0, far}) {
            const QPoint at = test.at(x, x == far ? 0 : 2);
            const QColor there = image.pixelColor(at);
            const QColor elsewhere = image.pixelColor(at + QPoint(0, 40));
            QVERIFY2(std::abs(there.lightness() - elsewhere.lightness()) > 40, qPrintable(QString::number(x)));
        }
    }

    void placesOfProblemsAreMarkedWhileThatIsSwitchedOn() {
        TestWindow test;
        test.trigger(Act::Grid); // off
        Level level;
        BodyObject wall;
        wall.shapes = {LineChain{{Vec2(0, 0), Vec2(1, 0), Vec2(1, 0), Vec2(2, 1)}, false}};
        level.objects.append({1, "wall", wall, {}});
        test.document().reset(level);
        test.window->problems().check();
        test.canvas().fitLevel();
        test.canvas().finishPainting();
        const QImage marked = test.canvas().grab().toImage();
        test.trigger(Act::OverlayProblems);
        const QImage plain = test.canvas().grab().toImage();
        const QPoint at = test.at(1, 0) + QPoint(0, 4);
        QVERIFY(marked.pixelColor(at) != plain.pixelColor(at));
        const QPoint elsewhere = test.at(1, 0) + QPoint(0, 60);
        QCOMPARE(marked.pixelColor(elsewhere), plain.pixelColor(elsewhere));
    }

    void goingToAProblemBringsItsPlaceIntoView() {
        TestWindow test;
        Level level;
        BodyObject wall;
        wall.shapes = {LineChain{{Vec2(0, 0), Vec2(500, 0), Vec2(500, 0), Vec2(1000, 1)}, false}};
        level.objects.append({1, "wall", wall, {}});
        test.document().reset(level);
        test.canvas().setView(Viewport());
        test.trigger(Act::NextProblem);
        QVERIFY(test.canvas().view().visible().contains(Vec2(500, 0)));
        QVERIFY(test.document().selection().contains(Key{1}));
        test.trigger(Act::FixProblem);
        QCOMPARE(std::get<LineChain>(std::get<BodyObject>(test.document().level().objects[0].data).shapes[0])
                     .vertices.size(),
                 std::size_t{3});
        test.trigger(Act::Undo);
        QCOMPARE(test.document().level(), level);
    }

    void zoomingStaysWithinItsLimits() {
        TestWindow test;
        for (int i = 0; i < 100; ++i) {
            wheel(test.canvas(), QPoint(10, 10), 10, {});
        }
        QCOMPARE(test.canvas().view().scale, Viewport::maxScale);
        for (int i = 0; i < 100; ++i) {
            wheel(test.canvas(), QPoint(10, 10), -10, {});
        }
        const double farthest = test.canvas().view().scale;
        QVERIFY(farthest * 10 > 20 && farthest * 10 < 30); // px of an empty level, which is 10 m long
    }

    void aLevelIsNeverLostByZoomingOut() {
        TestWindow test;
        Level level = levelWithABall();
        Object stray = level.objects[0];
        stray.key = 2;
        std::get<BodyObject>(stray.data).position = {500, 0};
        test.document().reset(added(level, stray));
        for (int i = 0; i < 100; ++i) {
            wheel(test.canvas(), QPoint(300, 200), -10, {});
        }
        const double length = boundsOf(test.level()).size().x() * test.canvas().view().scale;
        QVERIFY2(length > 20 && length < 30, qPrintable(QString::number(length)));
        // The view of a larger one is not drawn nearer by a turn outwards.
        test.document().reset(level);
        const double before = test.canvas().view().scale;
        wheel(test.canvas(), QPoint(300, 200), -1, {});
        QCOMPARE(test.canvas().view().scale, before);
        wheel(test.canvas(), QPoint(300, 200), 1, {});
        QVERIFY(test.canvas().view().scale > before);
    }

    void theZoomIsTypedIntoTheStatusBar() {
        TestWindow test;
        auto* field = test.window->statusLine().findChild<ZoomField*>();
        field->setFocus();
        field->lineEdit()->selectAll();
        QTest::keyClicks(field, "250");
        QTest::keyClick(field, Qt::Key_Return);
        QCOMPARE(test.canvas().view().scale, 2.5 * Viewport().scale);
        QCOMPARE(field->currentText(), QString("250 %"));
        QVERIFY(test.canvas().hasFocus());
    }

    void theSnapButtonOpensTheMenuOfSnapping() {
        TestWindow test;
        const auto* button = test.window->statusLine().findChild<QToolButton*>("snap");
        QVERIFY(button->menu()->actions().contains(&test.window->actions()[Act::Snap]));
        const QString before = button->text();
        test.trigger(Act::Snap);
        QVERIFY(button->text() != before);
    }

    void draggingMovesTheView_data() {
        QTest::addColumn<Qt::MouseButton>("button");
        QTest::addColumn<bool>("space");
        QTest::newRow("middle button") << Qt::MiddleButton << false;
        QTest::newRow("right button") << Qt::RightButton << false;
        QTest::newRow("space and left button") << Qt::LeftButton << true;
    }
    void draggingMovesTheView() {
        QFETCH(Qt::MouseButton, button);
        QFETCH(bool, space);
        TestWindow test;
        test.drawWalls();
        const Level before = test.level();
        QSignalSpy menu(&test.canvas(), &Canvas::menuWanted);
        const QPoint from(100, 100);
        const QPoint to(180, 60);
        const Vec2 grabbed = worldAt(test.canvas(), from);
        if (space) {
            QTest::keyPress(&test.canvas(), Qt::Key_Space);
        }
        dragWith(test.canvas(), button, from, to);
        QVERIFY((worldAt(test.canvas(), to) - grabbed).norm() < 1e-9);
        QVERIFY(test.level() == before);
        QCOMPARE(menu.count(), 0);
    }

    void aRightClickAsksForTheMenuUnlessAShapeIsBeingDrawn() {
        TestWindow test;
        test.canvas().disconnect(test.window.get()); // the menu itself would wait for an answer
        QSignalSpy menu(&test.canvas(), &Canvas::menuWanted);
        QTest::mouseClick(&test.canvas(), Qt::RightButton, {}, QPoint(50, 50));
        QCOMPARE(menu.count(), 1);
        test.trigger(ToolId::Edge);
        test.click(0, 0);
        test.click(1, 0);
        QTest::mouseClick(&test.canvas(), Qt::RightButton, {}, test.at(1, 0));
        QCOMPARE(menu.count(), 1);
        QCOMPARE(test.level().objects.size(), 1);
    }

    void arrowKeysMoveTheSelectionOrTheView_data() {
        QTest::addColumn<int>("modifiers");
        QTest::addColumn<double>("metres");
        QTest::newRow("a little") << 0 << 0.05;
        QTest::newRow("a grid step") << static_cast<int>(Qt::ShiftModifier) << 0.25;
    }
    void arrowKeysMoveTheSelectionOrTheView() {
        QFETCH(int, modifiers);
        QFETCH(double, metres);
        TestWindow test;
        test.drawWalls();
        test.trigger(Act::SelectAll);
        const auto position = [&test] { return std::get<BodyObject>(test.level().objects[0].data).position; };
        const Vec2 before = position();
        const Viewport view = test.canvas().view();
        for (int i = 0; i < 4; ++i) {
            QTest::keyClick(&test.canvas(), Qt::Key_Right, Qt::KeyboardModifiers(modifiers));
        }
        QVERIFY((position() - before - Vec2(4 * metres, 0)).norm() < 1e-9);
        QVERIFY((test.canvas().view().center - view.center).norm() < 1e-12);
        test.trigger(Act::Undo);
        QVERIFY((position() - before).norm() < 1e-9);
        test.trigger(Act::SelectNone);
        QTest::keyClick(&test.canvas(), Qt::Key_Right);
        QVERIFY((position() - before).norm() < 1e-9);
        QVERIFY(test.canvas().view().center.x() > view.center.x());
    }

    void backspaceTakesBackAPointAndElseDeletes() {
        TestWindow test;
        test.drawWalls();
        test.trigger(Act::SelectAll);
        QTest::keyClick(&test.canvas(), Qt::Key_Backspace);
        QCOMPARE(test.level().objects.size(), 0);
        test.trigger(ToolId::Line);
        for (const double x : {0.0, 1.0, 2.0}) {
            test.click(x, 0);
        }
        QTest::keyClick(&test.canvas(), Qt::Key_Backspace);
        QTest::keyClick(&test.canvas(), Qt::Key_Return);
        QCOMPARE(test.level().objects.size(), 1);
        const auto& body = std::get<BodyObject>(test.level().objects[0].data);
        QCOMPARE(std::get<LineChain>(body.shapes[0]).vertices.size(), std::size_t{2});
    }

    void theViewShowsWhatItIsAskedFor() {
        TestWindow test;
        test.drawWalls();
        test.canvas().zoomTo(1000);
        test.canvas().fitLevel();
        const Aabb visible = test.canvas().view().visible();
        QVERIFY(visible.contains(boundsOf(test.level())));
        QVERIFY((visible.center() - boundsOf(test.level()).center()).norm() < 1e-9);
        test.trigger(Act::SelectAll);
        const double scale = test.canvas().view().scale;
        test.canvas().zoomTo(scale / 7);
        test.canvas().centerSelection();
        QVERIFY((test.canvas().view().center - visible.center()).norm() < 1e-9);
        QVERIFY(std::abs(test.canvas().view().scale - scale / 7) < 1e-9);
    }

    void thePointerIsReportedInMetres() {
        TestWindow test;
        QSignalSpy moved(&test.canvas(), &Canvas::pointerMoved);
        QTest::mouseMove(&test.canvas(), QPoint(120, 80));
        QVERIFY(moved.count() > 0);
        const Vec2 expected = worldAt(test.canvas(), QPoint(120, 80));
        QCOMPARE(moved.back()[0].toDouble(), expected.x());
        QCOMPARE(moved.back()[1].toDouble(), expected.y());
        QVERIFY((test.canvas().pointerPosition() - expected).norm() < 1e-12);
    }

    void switchesAreRememberedFromOneRunToTheNext() {
        TestWindow test;
        Preferences& preferences = test.window->files().preferences;
        test.trigger(Act::OverlayNormals);
        test.trigger(Act::Grid);
        test.trigger(Act::Snap);
        QVERIFY(preferences.overlays() == OverlayFlags{.normals = true});
        QVERIFY(!preferences.grid());
        const bool snaps = preferences.snap().grid;
        test.trigger(Act::Snap);
        QCOMPARE(preferences.snap().grid, !snaps);
        MainWindow next;
        QVERIFY(next.actions()[Act::OverlayNormals].isChecked());
        QVERIFY(!next.actions()[Act::Grid].isChecked());
        test.trigger(Act::OverlaysOff);
        QVERIFY(preferences.overlays() == OverlayFlags{.ways = false});
    }
};

SPACETOW_TEST(CanvasTest)
#include "canvas_test.moc"
