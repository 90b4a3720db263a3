// Number fields by wheel and by drags on their labels.
#include "tests/support/number_fixture.h"
#include "tests/support/test_main.h"

using namespace spacetow;
using namespace spacetow::test;

class NumberDragTest : public QObject {
    Q_OBJECT

  private slots:
    void theWheelStepsOnlyWithTheFocus() {
        NumberFixture test({1}, metres());
        test.wheel(120);
        QCOMPARE(test.entries, 0);
        test.field->setFocus();
        test.wheel(120);
        QCOMPARE(test.values.front(), 1.1);
        for (int i = 0; i < 3; ++i) {
            test.wheel(-40); // a touchpad's parts of a notch
        }
        QCOMPARE(test.values.front(), 1.0);
        QCOMPARE(test.entries, 2);
    }

    void draggingTheLabelChangesTheNumberAndIsOneEntry() {
        NumberFixture test({1}, metres());
        test.drag(*test.label, {5, 10, 25});
        QCOMPARE(test.values.front(), 1.5);
        QVERIFY(test.last.phase == NumberEntry::Phase::Preview);
        QCOMPARE(test.field->text(), QString("1.5"));
        test.drop(*test.label);
        QVERIFY(test.last.phase == NumberEntry::Phase::Final);
        QCOMPARE(test.values.front(), 1.5);
    }

    void shiftDragsATenthAsFastAndCtrlInWholeSteps() {
        NumberFixture test({1.234}, metres());
        test.drag(*test.label, {50}, Qt::ShiftModifier);
        QCOMPARE(test.values.front(), 1.334);
        test.drop(*test.label);
        test.drag(*test.label, {7}, Qt::ControlModifier);
        QCOMPARE(test.values.front(), 1.5);
        test.drop(*test.label);
    }

    void escapeTakesADragBack() {
        NumberFixture test({1}, metres());
        test.drag(*test.label, {25});
        QTest::keyClick(test.field, Qt::Key_Escape);
        QCOMPARE(test.values.front(), 1.0);
        test.move(*test.label, QPoint(80, 5), {});
        test.drop(*test.label);
        QCOMPARE(test.values.front(), 1.0);
        QVERIFY(test.last.phase == NumberEntry::Phase::Cancelled);
        QCOMPARE(test.field->text(), QString("1"));
    }

    void aDragOverSeveralNumbersMovesEach() {
        NumberFixture test({1, 5}, metres());
        test.drag(*test.label, {10, 20});
        test.drop(*test.label);
        QCOMPARE(test.values, (std::vector<double>{1.4, 5.4}));
    }

    void aDragStopsAtTheEndOfTheRange() {
        NumberFixture test({999.9}, metres());
        test.drag(*test.label, {500});
        test.drop(*test.label);
        QCOMPARE(test.values.front(), 1000.0);
    }

    void aClickOnTheLabelSelectsTheNumber() {
        NumberFixture test({1.5}, metres());
        QTest::mouseClick(test.label, Qt::LeftButton);
        QVERIFY(test.field->hasFocus());
        QCOMPARE(test.field->selectedText(), QString("1.5"));
        QCOMPARE(test.entries, 0);
    }

    void theLetterOfAPairIsDraggedToo() {
        NumberFixture test({1}, metres());
        test.field->setAxis("x");
        auto* axis = test.field->findChild<ScrubLabel*>();
        QVERIFY(axis != nullptr && axis->isVisible());
        test.drag(*axis, {5});
        test.drop(*axis);
        QCOMPARE(test.values.front(), 1.1);
    }

    void wholeNumbersStayWhole() {
        NumberSpec spec;
        spec.min = 1;
        spec.max = 99;
        spec.whole = true;
        spec.step = 1;
        NumberFixture test({3}, spec);
        test.enter("3*2");
        QCOMPARE(test.values.front(), 6.0);
        test.enter("2.5");
        QVERIFY(!test.field->fault().isEmpty());
        QCOMPARE(test.values.front(), 6.0);
        QTest::keyClick(test.field, Qt::Key_Escape);
        QTest::keyClick(test.field, Qt::Key_Up, Qt::ShiftModifier);
        QCOMPARE(test.values.front(), 7.0);
        QTest::keyClick(test.field, Qt::Key_Up, Qt::ControlModifier);
        QCOMPARE(test.values.front(), 17.0);
        test.drag(*test.label, {-15});
        test.drop(*test.label);
        QCOMPARE(test.values.front(), 14.0);
    }
};

SPACETOW_TEST(NumberDragTest)
#include "number_drag_test.moc"
