// A shape that is half drawn while something else is done in the window.
#include "tests/support/test_main.h"
#include "tests/support/window.h"

#include <QFileInfo>

using namespace spacetow;
using namespace spacetow::test;

namespace {

/// Two walls are there; of a polygon three points have been clicked.
struct HalfDrawn : TestWindow {
    HalfDrawn() {
        drawWalls();
        document().markSaved();
        trigger(ToolId::Polygon);
        click(-1, -1);
        click(1, -1);
        click(0, 1);
    }
};

} // namespace

class UnfinishedDrawingTest : public QObject {
    Q_OBJECT

  private slots:
    void undoTakesBackItsLastPointAndNoEditBefore() {
        HalfDrawn test;
        test.trigger(Act::Undo);
        QCOMPARE(test.level().objects.size(), 1);
        QVERIFY(test.window->toolbox().isBusy());
        test.click(2, 1);
        test.key(Qt::Key_Return);
        QCOMPARE(test.level().objects.size(), 2);
        const auto& body = std::get<BodyObject>(test.level().objects[1].data);
        QCOMPARE(std::get<Polygon>(body.shapes[0]).vertices.size(), std::size_t{3});
        test.trigger(Act::Undo);
        QCOMPARE(test.level().objects.size(), 1);
    }

    void undoTakesBackPointsBeforeThereIsAnyEdit() {
        TestWindow test;
        test.trigger(ToolId::Polygon);
        test.click(-1, -1);
        test.click(1, -1);
        QVERIFY(!test.document().canUndo());
        test.trigger(Act::Undo);
        QVERIFY(test.window->toolbox().isBusy());
        test.trigger(Act::Undo);
        QVERIFY(!test.window->toolbox().isBusy());
    }

    void redoLeavesItAlone() {
        HalfDrawn test;
        test.trigger(Act::Redo);
        QVERIFY(test.window->toolbox().isBusy());
        QCOMPARE(test.level().objects.size(), 1);
    }

    void savingLeavesItAndWhatIsBeingTyped() {
        HalfDrawn test;
        test.toSave = test.file("half.json");
        QTest::keyClick(&test.canvas(), Qt::Key_2);
        QVERIFY(test.window->toolbox().typing());
        test.trigger(Act::SaveAs);
        QVERIFY(QFileInfo::exists(test.toSave));
        QVERIFY(test.window->toolbox().typing() && test.window->toolbox().isBusy());
    }

    void closingTheWindowFinishesItAndAsks() {
        HalfDrawn test;
        test.unsaved = Unsaved::Cancel;
        test.window->close();
        QCOMPARE(test.asked, 1);
        QVERIFY(test.window->isVisible());
        QCOMPARE(test.level().objects.size(), 2);
    }

    void playingFinishesIt() {
        HalfDrawn test;
        test.trigger(Act::Play);
        QVERIFY(test.window->isPlaying());
        QCOMPARE(test.level().objects.size(), 2);
        QVERIFY(!test.window->toolbox().isBusy());
    }

    void marksThatFollowThePointerGoWithIt() {
        TestWindow test;
        test.document().reset(test.twoBallsAtOneSpot());
        QTest::mouseMove(&test.canvas(), test.at(0, 0));
        QVERIFY(test.window->toolbox().overlay().hovered != 0);
        QEvent leave(QEvent::Leave);
        QApplication::sendEvent(&test.canvas(), &leave);
        QVERIFY(test.window->toolbox().overlay().hovered == 0);
    }
};

SPACETOW_TEST(UnfinishedDrawingTest)
#include "unfinished_drawing_test.moc"
