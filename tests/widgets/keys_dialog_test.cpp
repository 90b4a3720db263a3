#include "editor/window/keys_dialog.h"

#include "tests/support/test_main.h"
#include "tests/support/window.h"

using namespace spacetow;
using spacetow::test::TestWindow;

class KeysDialogTest : public QObject {
    Q_OBJECT

  private slots:
    void aSearchLeavesTheLinesThatHoldItsWords() {
        const QString all = KeysDialog::overview({});
        QVERIFY(all.contains("Rotate Left 15°") && all.contains("Save"));
        const QString some = KeysDialog::overview({}, "rotate left");
        QVERIFY(some.contains("Rotate Left 15°") && some.contains("Rotate Left 90°"));
        QVERIFY(!some.contains("Rotate Right 15°") && !some.contains("Save"));
        QCOMPARE(some.count("<h3>"), 1);
        QVERIFY(KeysDialog::overview({}, "ctrl+shift+s").contains("Save As"));
        QVERIFY(!KeysDialog::overview({}, "nothing of the kind").contains("<h3>"));
    }

    void theSearchIsReadyToBeTypedInto() {
        TestWindow test;
        KeysDialog dialog({}, test.window.get());
        dialog.show();
        dialog.activateWindow();
        QApplication::processEvents();
        QVERIFY(dialog.search().hasFocus());
        QTest::keyClicks(&dialog.search(), "flip");
        QVERIFY(dialog.text().toPlainText().contains("Flip Horizontally"));
        QVERIFY(!dialog.text().toPlainText().contains("Rotate"));
        QTest::keyClicks(&dialog.search(), "xyz");
        QVERIFY(dialog.text().toPlainText().contains("No key"));
    }
};

SPACETOW_TEST(KeysDialogTest)
#include "keys_dialog_test.moc"
