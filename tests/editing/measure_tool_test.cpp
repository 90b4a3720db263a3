#include "editor/editing/measure_tool.h"

#include "tests/support/drive.h"
#include "tests/support/test_main.h"

#include <algorithm>
#include <numbers>

using namespace spacetow;
using namespace spacetow::test;

namespace {

QStringList textsOf(const Drive& drive) {
    QStringList texts;
    for (const OverlayText& text : drive.toolbox.overlay().texts) {
        texts << QString::fromStdString(text.text);
    }
    return texts;
}

QString numbersOf(const Drive& drive) {
    return QString::fromStdString(drive.toolbox.numbers());
}

QString hintOf(const Drive& drive) {
    return QString::fromStdString(drive.toolbox.hint().code);
}

const QString threeFour = QString::fromUtf8("Δx 3.00  Δy 4.00 m\n5.00 m  53.1°");

} // namespace

class MeasureToolTest : public QObject {
    Q_OBJECT

  private slots:
    void aDragMeasures();
    void twoClicksMeasure();
    void theMeasureFollowsThePointer();
    void aThirdClickGivesTheAngle();
    void whatWasMeasuredStaysUntilTheNext();
    void escapeClearsItAndThenLeavesTheTool();
    void backspaceTakesBackAPoint();
    void itMeasuresFromThingToThing();
    void shiftKeepsToDirections();
    void theLevelStaysAsItIs();
    void anglesAreThoseOfTheCorner();
};

void MeasureToolTest::aDragMeasures() {
    Drive drive;
    drive.toolbox.choose(ToolId::Measure);
    QCOMPARE(hintOf(drive), QString("measure.start"));
    drive.press({1, 1});
    drive.move({2, 3});
    drive.move({4, 5});
    QCOMPARE(textsOf(drive), QStringList{threeFour});
    QCOMPARE(hintOf(drive), QString("measure.first"));
    drive.release({4, 5});
    QCOMPARE(numbersOf(drive), QString::fromUtf8("5 m  Δx 3 m  Δy 4 m  53.130102°\n"));
}

void MeasureToolTest::twoClicksMeasure() {
    Drive drive;
    drive.toolbox.choose(ToolId::Measure);
    drive.click({1, 1});
    QVERIFY(drive.toolbox.numbers().empty());
    QCOMPARE(hintOf(drive), QString("measure.same-point"));
    drive.click({4, 5});
    QCOMPARE(textsOf(drive), QStringList{threeFour});
    QCOMPARE(hintOf(drive), QString("measure.done"));
}

void MeasureToolTest::theMeasureFollowsThePointer() {
    Drive drive;
    drive.toolbox.choose(ToolId::Measure);
    drive.click({0, 0});
    drive.move({3, 4});
    QCOMPARE(textsOf(drive), QStringList{threeFour});
    drive.move({-2, 0});
    QCOMPARE(textsOf(drive), QStringList{QString::fromUtf8("Δx -2.00  Δy 0.00 m\n2.00 m  180°")});
}

void MeasureToolTest::aThirdClickGivesTheAngle() {
    Drive drive;
    drive.toolbox.choose(ToolId::Measure);
    drive.click({{0, 0}, {3, 0}});
    drive.move({1, 2});
    QCOMPARE(hintOf(drive), QString("measure.second"));
    drive.click({1, 2});
    QCOMPARE(hintOf(drive), QString("measure.angle"));
    QVERIFY(textsOf(drive).contains(QString::fromUtf8("45°")));
    QVERIFY(numbersOf(drive).endsWith(QString::fromUtf8("∠ 45°\n")));
    // No number hides another: each stands where nothing else does.
    const std::vector<OverlayText> texts = drive.toolbox.overlay().texts;
    QCOMPARE(texts.size(), std::size_t{3});
    QVERIFY(texts[0].at == Vec2(1.5, 0));
    QVERIFY(texts[1].at == Vec2(1, 2));
}

void MeasureToolTest::whatWasMeasuredStaysUntilTheNext() {
    Drive drive;
    drive.toolbox.choose(ToolId::Measure);
    drive.click({{0, 0}, {3, 0}, {3, 3}});
    const QString before = numbersOf(drive);
    drive.move({9, 9});
    drive.toolbox.leave();
    QCOMPARE(numbersOf(drive), before);
    QCOMPARE(textsOf(drive).size(), 3);
    drive.drag({1, 1}, {4, 5});
    QCOMPARE(numbersOf(drive), QString::fromUtf8("5 m  Δx 3 m  Δy 4 m  53.130102°\n"));
    drive.click({4, 0});
    drive.click({7, 7}); // a fourth begins anew
    QVERIFY(numbersOf(drive).isEmpty());
}

void MeasureToolTest::escapeClearsItAndThenLeavesTheTool() {
    Drive drive;
    drive.toolbox.choose(ToolId::Measure);
    drive.click({{0, 0}, {3, 0}});
    drive.key(ToolKey::Escape);
    QVERIFY(drive.toolbox.numbers().empty() && drive.toolbox.current() == ToolId::Measure);
    drive.key(ToolKey::Escape);
    QVERIFY(drive.toolbox.current() == ToolId::Select);
}

void MeasureToolTest::backspaceTakesBackAPoint() {
    Drive drive;
    drive.toolbox.choose(ToolId::Measure);
    drive.click({{0, 0}, {3, 0}, {3, 3}});
    drive.key(ToolKey::Backspace);
    QCOMPARE(numbersOf(drive), QString::fromUtf8("3 m  Δx 3 m  Δy 0 m  0°\n"));
    QVERIFY(drive.secondaryClick({0, 0})); // no menu: it clears
    QVERIFY(numbersOf(drive).isEmpty());
}

void MeasureToolTest::itMeasuresFromThingToThing() {
    Level level;
    level.objects.append(bodyWith(1, LineChain{{{0, 0}, {3, 4}}}, {0.1, 0.1}));
    Drive drive(level);
    drive.toolbox.choose(ToolId::Measure);
    drive.drag({0.13, 0.07}, {3.07, 4.12});
    QVERIFY(drive.toolbox.overlay().snap && drive.toolbox.overlay().snap->kind == SnapKind::Vertex);
    QVERIFY(numbersOf(drive).startsWith("5 m"));
}

void MeasureToolTest::shiftKeepsToDirections() {
    Drive drive;
    drive.toolbox.choose(ToolId::Measure);
    drive.click({0, 0});
    drive.held = shift;
    drive.click({3, 2.9});
    QVERIFY(numbersOf(drive).contains(QString::fromUtf8("45°")));
}

void MeasureToolTest::theLevelStaysAsItIs() {
    Level level;
    level.objects.append(bodyWith(1, LineChain{{{0, 0}, {3, 4}}}, {0, 0}));
    Drive drive(level);
    drive.document.select(Selection({1}));
    drive.toolbox.choose(ToolId::Measure);
    drive.drag({0, 0}, {3, 4});
    drive.click({{1, 1}, {2, 2}, {5, 5}});
    drive.key(ToolKey::Delete);
    QVERIFY(drive.level() == level && !drive.document.canUndo());
    QCOMPARE(drive.document.selection().size(), 1);
}

void MeasureToolTest::anglesAreThoseOfTheCorner() {
    const double right = std::numbers::pi / 2;
    QVERIFY(std::abs(angleBetween({1, 0}, {0, 0}, {0, 5}) - right) < 1e-12);
    QVERIFY(std::abs(angleBetween({0, 5}, {0, 0}, {1, 0}) - right) < 1e-12);
    QVERIFY(std::abs(angleBetween({1, 0}, {0, 0}, {-1, 0}) - 2 * right) < 1e-12);
    QVERIFY(angleBetween({1, 1}, {0, 0}, {2, 2}) < 1e-12);
}

SPACETOW_TEST(MeasureToolTest)
#include "measure_tool_test.moc"
