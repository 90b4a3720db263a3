// Length and angle typed on the canvas, with keys as a user presses them.

#include "editor/canvas/entry_box.h"

#include "tests/support/drive.h"
#include "tests/support/test_main.h"
#include "tests/support/window.h"

using namespace spacetow;
using spacetow::test::TestWindow;

namespace {

struct EntryWindow : TestWindow {
    EntryWindow() {
        window->toolbox().snap.grid = true;
        trigger(ToolId::Edge);
        click(0, 0);
        hover(2, 0);
    }
    void hover(double x, double y) { QTest::mouseMove(&canvas(), at(x, y)); }
    void typeText(const char* text) {
        for (const char* letter = text; *letter != '\0'; ++letter) {
            QTest::keyClick(QApplication::focusWidget(), *letter);
        }
    }
    EntryBox& box() { return *canvas().findChild<EntryBox*>(); }
    QList<QLineEdit*> fields() { return box().findChildren<QLineEdit*>(); }
    QString hint() { return window->statusLine().findChild<QLabel*>(QStringLiteral("hint"))->toolTip(); }
    std::vector<Vec2> drawn() { return test::worldPoints(level().objects[level().objects.size() - 1]); }
};

} // namespace

class EntryBoxTest : public QObject {
    Q_OBJECT

  private slots:
    void digitsOpenTheFieldsAndEnterPlacesThePoint() {
        EntryWindow test;
        QVERIFY(!test.box().isVisible());
        const double scale = test.canvas().view().scale;
        test.typeText("1"); // that is a key for the zoom otherwise
        QVERIFY(test.box().isVisible());
        QCOMPARE(test.canvas().view().scale, scale);
        QCOMPARE(test.fields()[0]->text(), QStringLiteral("1"));
        QVERIFY(test.fields()[0]->hasFocus());
        test.typeText(",5");
        test.key(Qt::Key_Tab);
        QVERIFY(test.fields()[1]->hasFocus());
        test.typeText("90");
        test.key(Qt::Key_Return);
        QVERIFY(!test.box().isVisible());
        QVERIFY(test.canvas().hasFocus());
        test.key(Qt::Key_Return); // ends the chain
        QVERIFY(test.drawn() == (std::vector<Vec2>{{0, 0}, {0, 1.5}}));
    }

    void theOtherFieldShowsWhatThePointerSays() {
        EntryWindow test;
        test.typeText("3");
        QCOMPARE(test.fields()[1]->placeholderText(), QStringLiteral("0"));
        test.hover(0, 2);
        QCOMPARE(test.fields()[1]->placeholderText(), QStringLiteral("90"));
        QCOMPARE(test.fields()[0]->text(), QStringLiteral("3"));
    }

    void tabGoesRoundAndEscapeGoesBackToThePointer() {
        EntryWindow test;
        test.typeText("3");
        test.key(Qt::Key_Tab);
        test.key(Qt::Key_Tab);
        QVERIFY(test.fields()[0]->hasFocus());
        test.key(Qt::Key_Escape);
        QVERIFY(!test.box().isVisible());
        QVERIFY(test.canvas().hasFocus());
        QVERIFY(test.window->toolbox().isBusy()); // the chain is still being drawn
        test.click(2, 0);
        test.key(Qt::Key_Return);
        QVERIFY(test.drawn() == (std::vector<Vec2>{{0, 0}, {2, 0}}));
    }

    void backspaceInEmptyFieldsCloses() {
        EntryWindow test;
        test.typeText("3");
        test.key(Qt::Key_Backspace);
        QVERIFY(test.box().isVisible());
        test.key(Qt::Key_Backspace);
        QVERIFY(!test.box().isVisible());
        QVERIFY(test.window->toolbox().isBusy());
    }

    void aClickPlacesThePointToo() {
        EntryWindow test;
        test.typeText("3");
        test.click(0, 1);
        QVERIFY(!test.box().isVisible());
        test.key(Qt::Key_Return);
        QVERIFY(test.drawn() == (std::vector<Vec2>{{0, 0}, {0, 3}}));
    }

    void nonsenseIsSaidWhereTheUserLooksAndMarked() {
        EntryWindow test;
        const QColor usual = test.fields()[0]->palette().color(QPalette::Text);
        test.typeText("3x");
        QVERIFY2(test.hint().contains(QStringLiteral("“3x”")), qPrintable(test.hint()));
        QVERIFY(test.fields()[0]->palette().color(QPalette::Text) != usual);
        test.key(Qt::Key_Return);
        QVERIFY(test.box().isVisible());
        test.key(Qt::Key_Backspace);
        QCOMPARE(test.fields()[0]->palette().color(QPalette::Text), usual);
        test.key(Qt::Key_Return);
        QVERIFY(!test.box().isVisible());
    }

    void digitsOfAnyScriptAreRead() {
        EntryWindow test;
        test.typeText("1");
        test.fields()[0]->setText(QString());
        for (const QChar letter : QStringLiteral("۲٫۵")) {
            QTest::sendKeyEvent(QTest::Click, test.fields()[0], Qt::Key_unknown, QString(letter), Qt::NoModifier);
        }
        test.key(Qt::Key_Return);
        test.key(Qt::Key_Return);
        QVERIFY(test.drawn() == (std::vector<Vec2>{{0, 0}, {2.5, 0}}));
    }

    void aRadiusIsOneField() {
        EntryWindow test;
        test.key(Qt::Key_Escape);
        test.trigger(ToolId::Circle);
        test.click(0, 0);
        test.hover(2, 0);
        test.typeText("4");
        QVERIFY(test.fields()[0]->isVisible());
        QVERIFY(!test.fields()[1]->isVisible());
        test.key(Qt::Key_Tab);
        QVERIFY(test.fields()[0]->hasFocus());
    }

    void theBoxStaysInTheCanvasAndOffThePointer() {
        EntryWindow test;
        test.typeText("3");
        for (const QPoint at : {QPoint(1, 1), QPoint(test.canvas().width() - 2, 1),
                                QPoint(test.canvas().width() - 2, test.canvas().height() - 2)}) {
            QTest::mouseMove(&test.canvas(), at);
            QVERIFY(test.canvas().rect().contains(test.box().geometry()));
            QVERIFY(!test.box().geometry().contains(at));
        }
        QVERIFY(test::cutOffTexts(test.box()).isEmpty());
    }

    void withoutADrawingDigitsKeepTheirMeaning() {
        EntryWindow test;
        test.key(Qt::Key_Escape);
        test.typeText("2");
        QVERIFY(!test.box().isVisible());
    }
};

SPACETOW_TEST(EntryBoxTest)
#include "entry_box_test.moc"
