// A drag ends by its release, by Escape or by the loss of the mouse; nothing else acts meanwhile. All drags are tried
// with all commands.
#include "core/level/edits.h"
#include "tests/support/drive.h"
#include "tests/support/test_main.h"
#include "tests/support/window.h"

#include <QFocusEvent>
#include <QTimer>

#include <array>

using namespace spacetow;
using spacetow::test::bodyWith;
using spacetow::test::TestWindow;

namespace {

/// What a mouse can be in the middle of.
struct Drag {
    QByteArray name;
    ToolId tool;
    Qt::MouseButton button;
    Vec2 from, to; // m
};

const Vec2 ballPlace(-3, 2);
const Vec2 nowhere(3, -2);

std::vector<Drag> allDrags() {
    std::vector<Drag> drags{{"move", ToolId::Select, Qt::LeftButton, ballPlace, {-1, 1}},
                            {"band", ToolId::Select, Qt::LeftButton, nowhere, {-4, 3}},
                            {"middle button", ToolId::Select, Qt::MiddleButton, nowhere, {1, 1}},
                            {"right button", ToolId::Select, Qt::RightButton, nowhere, {1, 1}}};
    for (const ToolRow& row : toolRows()) {
        drags.push_back(
            {"tool " + QByteArray::number(static_cast<int>(row.id)), row.id, Qt::LeftButton, nowhere, {1, 1}});
    }
    return drags;
}

Level ballAndBlock() {
    Level level;
    level.objects.append(bodyWith(1, Circle{{0, 0}, 0.5}, ballPlace));
    level.objects.append(bodyWith(2, Circle{{0, 0}, 0.5}, {3, 2}));
    return level;
}

/// A window with something to undo, something to redo and the block selected, while the mouse drags elsewhere.
struct Dragging : TestWindow {
    void begin(const Drag& drag) {
        unsaved = Unsaved::Discard; // so that a command that acts is not held up by a question
        canvas().loseMouse();
        document().reset(ballAndBlock());
        for (const double step : {1.0, 2.0}) {
            Level level = document().level();
            level.gravity.x() = step;
            document().commit({"change-level", 1}, {std::make_shared<const Level>(level), Selection({2})});
        }
        document().undo();
        document().select(Selection({2}));
        window->toolbox().choose(drag.tool);
        Viewport view;
        view.center = Vec2(0, 0);
        canvas().setView(view);
        QTest::mousePress(&canvas(), drag.button, {}, at(drag.from.x(), drag.from.y()));
        moveTo(0.5 * (drag.from + drag.to));
    }
    void moveTo(const Vec2& point) { QTest::mouseMove(&canvas(), at(point.x(), point.y())); }
    void release(const Drag& drag) {
        moveTo(drag.to);
        QTest::mouseRelease(&canvas(), drag.button, {}, at(drag.to.x(), drag.to.y()));
    }
};

/// What there is to see of a window while something is dragged.
struct Sight {
    std::shared_ptr<const Level> level, current;
    Selection selection;
    std::vector<Label> history;
    int position;
    ToolId tool;
    double scale;
    bool grid, snap, playing, dragging;
    OverlayFlags overlays;

    bool operator==(const Sight& other) const = default;
};

Sight sightOf(TestWindow& test) {
    const Document& document = test.document();
    return {document.shown().level,
            document.current().level,
            document.selection(),
            document.history(),
            document.position(),
            test.window->toolbox().current(),
            test.canvas().view().scale,
            test.canvas().isGridVisible(),
            test.window->toolbox().snap.grid,
            test.window->isPlaying(),
            test.window->toolbox().isDragging(),
            test.window->overlays()};
}

/// Dialogs that a command opens are closed, and counted.
template <class Do>
int dialogsOpenedBy(const Do& act) {
    int dialogs = 0;
    QTimer watch;
    QObject::connect(&watch, &QTimer::timeout, [&dialogs] {
        if (QWidget* dialog = QApplication::activeModalWidget()) {
            ++dialogs;
            dialog->close();
        }
    });
    watch.start(0);
    act();
    return dialogs;
}

} // namespace

class DragsTest : public QObject {
    Q_OBJECT

  private slots:
    void noCommandActsDuringADrag() {
        Dragging test;
        for (const Drag& drag : allDrags()) {
            for (const ActionRow& row : actionRows()) {
                test.begin(drag);
                const Sight before = sightOf(test);
                const int dialogs = dialogsOpenedBy([&] { test.trigger(row.id); });
                const QByteArray what = drag.name + ", " + row.text;
                QVERIFY2(sightOf(test) == before, what);
                QCOMPARE(dialogs, 0);
                QVERIFY2(test.window->isVisible(), what);
                QVERIFY2(test.canvas().isDragging(), what);
                for (const ActionRow& other : actionRows()) {
                    QVERIFY2(other.isOn == nullptr ||
                                 test.window->actions()[other.id].isChecked() == other.isOn(*test.window),
                             what);
                }
            }
        }
    }

    void aDragGoesOnAfterACommandThatDidNotAct() {
        Dragging test;
        for (const Drag& drag : allDrags()) {
            test.begin(drag);
            test.release(drag);
            const Level alone = test.level();
            const int entries = test.document().position();
            for (const Act act : {Act::Delete, Act::Undo, Act::Play, Act::Cut, Act::Duplicate, Act::SelectAll}) {
                test.begin(drag);
                test.trigger(act);
                test.release(drag);
                QVERIFY2(test.level().objects.size() == alone.objects.size(), drag.name);
                QVERIFY2(test.document().position() == entries, drag.name);
                QVERIFY2(!test.document().hasPreview(), drag.name);
            }
        }
    }

    void whatADragDrawsMayBeGoneAgainWhileItGoesOn() {
        Dragging test;
        for (const Drag& drag : allDrags()) {
            test.begin(drag);
            const std::array places{drag.to, drag.from, drag.to, Vec2(drag.to.x(), drag.from.y()), drag.to};
            for (const Vec2& place : places) {
                test.moveTo(place);
                test.canvas().grab();
            }
            QVERIFY2(test.canvas().isDragging(), drag.name);
            test.release(drag);
        }
    }

    void keysOfTheCanvasRestDuringADrag() {
        Dragging test;
        for (const Drag& drag : allDrags()) {
            for (const Qt::Key key : {Qt::Key_Delete, Qt::Key_Backspace, Qt::Key_Left, Qt::Key_Up, Qt::Key_Return}) {
                test.begin(drag);
                const Sight before = sightOf(test);
                QTest::keyClick(&test.canvas(), key);
                QVERIFY2(sightOf(test) == before, drag.name);
            }
        }
    }

    void whoLosesTheMouseLosesTheDrag_data() {
        QTest::addColumn<int>("way");
        QTest::newRow("the window is no longer active") << 0;
        QTest::newRow("the focus goes elsewhere") << 1;
        QTest::newRow("a menu opens") << 2;
        QTest::newRow("the canvas is hidden") << 3;
        QTest::newRow("somebody grabs the mouse") << 4;
        QTest::newRow("the release went elsewhere") << 5;
    }
    void whoLosesTheMouseLosesTheDrag() {
        QFETCH(int, way);
        Dragging test;
        for (const Drag& drag : allDrags()) {
            test.begin(drag);
            const Level before = *test.document().current().level;
            lose(test, way);
            QVERIFY2(!test.canvas().isDragging() && !test.window->toolbox().isDragging(), drag.name);
            QVERIFY2(!test.document().hasPreview() && test.level() == before, drag.name);
            test.release(drag); // late, as some window managers send it
            QVERIFY2(test.level() == before, drag.name);
        }
        // The first click afterwards counts.
        test.window->toolbox().choose(ToolId::Select);
        test.click(ballPlace.x(), ballPlace.y());
        QVERIFY(test.document().selection() == Selection({1}));
    }

    void theFirstClickAfterAGameCounts() {
        Dragging test;
        test.begin(allDrags().front());
        test.canvas().loseMouse();
        test.trigger(Act::Play);
        test.trigger(Act::Stop);
        test.click(ballPlace.x(), ballPlace.y());
        QVERIFY(test.document().selection() == Selection({1}));
        QTest::mouseRelease(&test.canvas(), Qt::LeftButton);
    }

    void aHalfDrawnShapeOutlivesTheLossOfTheMouse() {
        TestWindow test;
        test.trigger(ToolId::Edge);
        test.click(-2, -2);
        test.click(2, -2);
        lose(test, 0);
        QVERIFY(test.window->toolbox().isBusy());
        test.click(2, 2);
        test.key(Qt::Key_Return);
        QCOMPARE(test.level().objects.size(), 1);
    }

    void deleteWhileDrawingLeavesOtherObjectsAlone() {
        TestWindow test;
        test.document().reset(ballAndBlock());
        test.document().select(Selection({2}));
        test.trigger(ToolId::Edge);
        test.click(-2, -2);
        test.click(2, -2);
        test.trigger(Act::Delete);
        QCOMPARE(test.level().objects.size(), 2);
    }

  private:
    static void lose(TestWindow& test, int way) {
        if (way == 0) {
            QEvent deactivate(QEvent::WindowDeactivate);
            QApplication::sendEvent(&test.canvas(), &deactivate);
        } else if (way == 1 || way == 2) {
            QFocusEvent out(QEvent::FocusOut, way == 1 ? Qt::OtherFocusReason : Qt::PopupFocusReason);
            QApplication::sendEvent(&test.canvas(), &out);
        } else if (way == 3) {
            test.canvas().hide();
            test.canvas().show();
        } else if (way == 4) {
            QEvent ungrab(QEvent::UngrabMouse);
            QApplication::sendEvent(&test.canvas(), &ungrab);
        } else {
            QMouseEvent move(QEvent::MouseMove, QPointF(40, 40), QPointF(40, 40), Qt::NoButton, Qt::NoButton, {});
            QApplication::sendEvent(&test.canvas(), &move);
        }
    }
};

SPACETOW_TEST(DragsTest)
#include "drags_test.moc"
