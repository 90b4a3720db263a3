// Keys that change what the mouse does, pressed and released while it rests.
#include "tests/support/test_main.h"
#include "tests/support/window.h"

using namespace spacetow;
using spacetow::test::TestWindow;

class HeldKeysTest : public QObject {
    Q_OBJECT

  private slots:
    void thePreviewFollowsKeysThatAreHeldWhileThePointerRests_data() {
        QTest::addColumn<int>("key");
        QTest::addColumn<int>("modifier");
        QTest::addColumn<bool>("counted");
        for (const bool counted : {false, true}) { // by the event that tells of the key itself
            const char* when = counted ? "counted at once" : "counted later";
            QTest::addRow("Ctrl, %s", when) << int(Qt::Key_Control) << int(Qt::ControlModifier) << counted;
            QTest::addRow("Shift, %s", when) << int(Qt::Key_Shift) << int(Qt::ShiftModifier) << counted;
        }
    }
    void thePreviewFollowsKeysThatAreHeldWhileThePointerRests() {
        QFETCH(int, key);
        QFETCH(int, modifier);
        QFETCH(bool, counted);
        TestWindow test;
        test.window->setSnap({});
        test.trigger(ToolId::Edge);
        test.click(-2, 1);
        const QPoint rest = test.at(0.06, 0.07);
        QTest::mouseMove(&test.canvas(), rest);
        const auto previewed = [&] { return test.window->toolbox().overlay().lines.back().points.back(); };
        const auto tell = [&](QEvent::Type type, bool held) {
            QKeyEvent event(type, key, held ? Qt::KeyboardModifiers(modifier) : Qt::NoModifier);
            QApplication::sendEvent(&test.canvas(), &event);
        };
        const Vec2 free = previewed();
        tell(QEvent::KeyPress, counted);
        const Vec2 held = previewed();
        QVERIFY(held != free);
        tell(QEvent::KeyRelease, !counted);
        QVERIFY(previewed() == free);
        tell(QEvent::KeyPress, counted);
        QVERIFY(previewed() == held);
        QTest::mouseClick(&test.canvas(), Qt::LeftButton, Qt::KeyboardModifiers(modifier), rest);
        tell(QEvent::KeyRelease, !counted);
        test.key(Qt::Key_Return);
        const auto& wall = std::get<BodyObject>(test.level().objects[0].data);
        const Vec2 end = wall.position + std::get<EdgeChain>(wall.shapes.front()).vertices.back();
        QVERIFY((end - held).norm() < 1e-9);
    }

    void whoLosesTheKeyboardHoldsNoKeys() {
        TestWindow test;
        test.window->setSnap({});
        test.trigger(ToolId::Edge);
        test.click(-2, 1);
        QTest::mouseMove(&test.canvas(), test.at(0.06, 0.07));
        const auto previewed = [&] { return test.window->toolbox().overlay().lines.back().points.back(); };
        const Vec2 free = previewed();
        QTest::keyPress(&test.canvas(), Qt::Key_Control);
        QVERIFY(previewed() != free);
        QFocusEvent away(QEvent::FocusOut, Qt::ActiveWindowFocusReason);
        QApplication::sendEvent(&test.canvas(), &away);
        QVERIFY(previewed() == free);
    }

    void keysThatAreHeldBringNoMarksBackOnceThePointerHasLeft() {
        TestWindow test;
        test.window->setSnap({});
        test.trigger(ToolId::Payload);
        QTest::mouseMove(&test.canvas(), test.at(1, 1));
        QVERIFY(!test.window->toolbox().overlay().circles.empty());
        QEvent leave(QEvent::Leave);
        QApplication::sendEvent(&test.canvas(), &leave);
        QVERIFY(test.window->toolbox().overlay().circles.empty());
        QTest::keyPress(&test.canvas(), Qt::Key_Control);
        QVERIFY(test.window->toolbox().overlay().circles.empty());
        QTest::keyRelease(&test.canvas(), Qt::Key_Control);
        QVERIFY(test.window->toolbox().overlay().circles.empty());
    }
};

SPACETOW_TEST(HeldKeysTest)
#include "held_keys_test.moc"
