// Numbers typed while something is drawn: what they are read as, and what they do in each tool.

#include "editor/editing/typed_entry.h"

#include "core/math/affine.h"
#include "tests/support/drive.h"
#include "tests/support/test_main.h"

#include <numbers>

using namespace spacetow;
using namespace spacetow::test;

namespace {

constexpr double typedDegree = std::numbers::pi / 180;

struct Typist : Drive {
    explicit Typist(ToolId tool) { toolbox.choose(tool); }
    void type(const char* first, const char* second = "") { toolbox.type({first, second}); }
    bool enter(const char* first, const char* second = "") {
        type(first, second);
        return toolbox.enterTyped();
    }
    std::string hintCode() const { return toolbox.hint().code; }
    const BodyObject& body() const { return std::get<BodyObject>(newest().data); }
};

using TypedPoints = std::vector<Vec2>;

/// Without the noise of adding up where the body is and where its nodes are in it.
TypedPoints spelledPoints(const Object& object) {
    TypedPoints points = worldPoints(object);
    for (Vec2& point : points) {
        point = tidied(point);
    }
    return points;
}

} // namespace

class TypedEntryTest : public QObject {
    Q_OBJECT

  private slots:
    void numbersAreRead_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<double>("metres");
        QTest::newRow("point") << "2.5" << 2.5;
        QTest::newRow("comma") << "2,5" << 2.5;
        QTest::newRow("no leading digit") << ".5" << 0.5;
        QTest::newRow("expression") << "3*0.25" << 0.75;
        QTest::newRow("unit") << "80 cm" << 0.8;
    }
    void numbersAreRead() {
        QFETCH(QString, text);
        QFETCH(double, metres);
        const TypedEntry entry = typedEntry(TypedKind::LengthAngle, {text.toStdString(), ""});
        QCOMPARE(entry.faulty, -1);
        QVERIFY(entry.values.first);
        QCOMPARE(*entry.values.first, metres);
        QVERIFY(!entry.values.second);
    }

    void anglesAreDegrees() {
        QCOMPARE(*typedEntry(TypedKind::LengthAngle, {"", "90"}).values.second, 90 * typedDegree);
        QCOMPARE(*typedEntry(TypedKind::SpeedAngle, {"", "-45"}).values.second, -45 * typedDegree);
        QCOMPARE(*typedEntry(TypedKind::WidthHeight, {"", "2"}).values.second, 2.0); // a height
    }

    void whatIsNoNumberIsSaidAndPlacesNothing_data() {
        QTest::addColumn<QString>("first");
        QTest::addColumn<QString>("second");
        QTest::addColumn<QString>("code");
        QTest::addColumn<QString>("argument");
        QTest::newRow("length") << "2x"
                                << ""
                                << "typing.no-number"
                                << "2x";
        QTest::newRow("angle") << "2"
                               << "north"
                               << "typing.no-angle"
                               << "north";
        QTest::newRow("nothing") << "0"
                                 << ""
                                 << "typing.too-small"
                                 << "0";
        QTest::newRow("less than nothing") << "-1"
                                           << ""
                                           << "typing.too-small"
                                           << "-1";
        QTest::newRow("unfinished") << "2*"
                                    << ""
                                    << "typing.no-number"
                                    << "2*";
        QTest::newRow("a mass") << "2 kg"
                                << ""
                                << "typing.no-number"
                                << "2 kg";
    }
    void whatIsNoNumberIsSaidAndPlacesNothing() {
        QFETCH(QString, first);
        QFETCH(QString, second);
        QFETCH(QString, code);
        QFETCH(QString, argument);
        Typist drive(ToolId::Edge);
        drive.click({0, 0});
        drive.move({3, 0});
        QVERIFY(!drive.enter(qPrintable(first), qPrintable(second)));
        QCOMPARE(drive.toolbox.hint(), (Hint{code.toStdString(), {argument.toStdString()}}));
        QVERIFY(drive.toolbox.typing()); // still open
        drive.click({3, 0});             // a click places nothing either
        QVERIFY(drive.toolbox.typing());
        drive.key(ToolKey::Escape);
        drive.click({3, 0});
        drive.key(ToolKey::Enter);
        QVERIFY(spelledPoints(drive.newest()) == (TypedPoints{{0, 0}, {3, 0}}));
    }

    void lengthAndAnglePlaceThePoint() {
        Typist drive(ToolId::Edge);
        drive.click({1, 1});
        drive.move({4, 2});
        QVERIFY(drive.enter("2.5", "90"));
        QVERIFY(!drive.toolbox.typing());
        QVERIFY(drive.enter("1.3", "180"));
        drive.key(ToolKey::Enter);
        QVERIFY(spelledPoints(drive.newest()) == (TypedPoints{{1, 1}, {1, 3.5}, {-0.3, 3.5}}));
    }

    void aLengthAloneGoesWhereThePointerIs() {
        Typist drive(ToolId::Line);
        drive.click({0, 0});
        drive.move({0, 3});
        QVERIFY(drive.enter("2.2"));
        drive.key(ToolKey::Enter);
        QVERIFY(spelledPoints(drive.newest()) == (TypedPoints{{0, 0}, {0, 2.2}}));
    }

    void anAngleAloneLeavesTheLengthToThePointer() {
        Typist drive(ToolId::Line);
        drive.click({0, 0});
        drive.move({2.1, 3});
        drive.type("", "0");
        QCOMPARE(drive.toolbox.measures(), (TypedMeasures{TypedKind::LengthAngle, 2, 0}));
        drive.move({3.6, 5}); // the preview follows
        QCOMPARE(drive.toolbox.measures(), (TypedMeasures{TypedKind::LengthAngle, 3.5, 0}));
        drive.click({3.6, 5}); // a click places it as Enter does
        QVERIFY(!drive.toolbox.typing());
        drive.key(ToolKey::Enter);
        QVERIFY(spelledPoints(drive.newest()) == (TypedPoints{{0, 0}, {3.5, 0}}));
    }

    void thePreviewIsHeldByWhatIsTyped() {
        Typist drive(ToolId::Polygon);
        drive.click({0, 0});
        drive.move({3, 1});
        drive.type("2", "90");
        const Overlay overlay = drive.toolbox.overlay();
        QVERIFY(overlay.lines.front().points.back() == Vec2(0, 2));
        QVERIFY(overlay.texts.empty()); // the fields say it
        QCOMPARE(drive.hintCode(), std::string("typing.length-angle"));
        drive.toolbox.stopTyping();
        QVERIFY(drive.toolbox.overlay().lines.front().points.back() == Vec2(3, 1));
        QCOMPARE(drive.hintCode(), std::string("draw-polygon.next"));
    }

    void whatIsTypedNearTheFirstPointDoesNotClose() {
        Typist drive(ToolId::Edge);
        drive.click({{0, 0}, {2, 0}, {2, 2}});
        drive.move({0, 0}); // would close
        QVERIFY(drive.enter("1", "180"));
        QVERIFY(drive.toolbox.isBusy());
        drive.move({0, 0});
        QVERIFY(drive.enter("1", "180")); // (0, 2)
        QVERIFY(drive.enter("2", "-90")); // exactly on the first point
        QVERIFY(!drive.toolbox.isBusy());
        QVERIFY(spelledPoints(drive.newest()) == (TypedPoints{{0, 0}, {2, 0}, {2, 2}, {1, 2}, {0, 2}}));
    }

    void emptyFieldsPlaceNothing() {
        Typist drive(ToolId::Edge);
        drive.click({0, 0});
        drive.move({3, 0});
        QVERIFY(drive.enter("", " "));
        QVERIFY(!drive.toolbox.typing());
        drive.key(ToolKey::Backspace);
        QVERIFY(!drive.toolbox.isBusy()); // there was but the first point
    }

    void nothingCanBeTypedWhereNothingIsDrawn_data() {
        QTest::addColumn<ToolId>("tool");
        for (const ToolRow& row : toolRows()) {
            QTest::addRow("%s", row.make()->code().c_str()) << row.id;
        }
    }
    void nothingCanBeTypedWhereNothingIsDrawn() {
        QFETCH(ToolId, tool);
        Typist drive(tool);
        drive.move({1, 1});
        QVERIFY(!drive.toolbox.measures());
        drive.type("2");
        QVERIFY(!drive.toolbox.typing());
        QVERIFY(!drive.toolbox.enterTyped());
        drive.press({1, 1});
        QVERIFY(!drive.toolbox.measures());
        drive.release({1, 1});
    }

    void aRectangleHasWidthAndHeight_data() {
        QTest::addColumn<bool>("shift");
        QTest::addColumn<bool>("ctrl");
        QTest::addColumn<QString>("height");
        QTest::addColumn<double>("left");
        QTest::addColumn<double>("bottom");
        QTest::addColumn<double>("right");
        QTest::addColumn<double>("top");
        QTest::newRow("both") << false << false << "0.4" << 1.0 << 1.0 << 3.0 << 1.4;
        QTest::newRow("width alone") << false << false << "" << 1.0 << 1.0 << 3.0 << 2.0;
        QTest::newRow("from the middle") << true << false << "0.4" << 0.0 << 0.8 << 2.0 << 1.2;
        QTest::newRow("square") << false << true << "" << 1.0 << 1.0 << 3.0 << 3.0;
    }
    void aRectangleHasWidthAndHeight() {
        QFETCH(bool, shift);
        QFETCH(bool, ctrl);
        QFETCH(QString, height);
        QFETCH(double, left);
        QFETCH(double, bottom);
        QFETCH(double, right);
        QFETCH(double, top);
        Typist drive(ToolId::Rectangle);
        drive.click({1, 1});
        drive.held = {shift, ctrl, false};
        drive.move({5, 2});
        QCOMPARE(drive.toolbox.measures()->kind, TypedKind::WidthHeight);
        QVERIFY(drive.enter("2", qPrintable(height)));
        QVERIFY(spelledPoints(drive.newest()) ==
                (TypedPoints{{left, bottom}, {right, bottom}, {right, top}, {left, top}}));
    }

    void aRectangleGrowsToTheSideOfThePointer() {
        Typist drive(ToolId::Rectangle);
        drive.click({1, 1});
        drive.move({0, 0});
        QVERIFY(drive.enter("2", "3"));
        QVERIFY(spelledPoints(drive.newest()).front() == Vec2(-1, -2));
    }

    void aCircleHasARadius() {
        Typist drive(ToolId::Circle);
        drive.click({1, 1});
        drive.move({3, 1});
        QCOMPARE(*drive.toolbox.measures(), (TypedMeasures{TypedKind::Radius, 2, 0}));
        QVERIFY(drive.enter("0.33"));
        QCOMPARE(std::get<Circle>(drive.body().shapes.front()).radius, 0.33);
    }

    void aFinishHasLengthAndAngle() {
        Typist drive(ToolId::Finish);
        drive.click({1, 1});
        drive.move({3, 1});
        QVERIFY(drive.enter("1.5", "90"));
        QVERIFY(std::get<FinishObject>(drive.newest().data) == (FinishObject{{1, 1}, {1, 2.5}}));
    }

    void aMovingBodyHasSpeedAndDirection_data() {
        QTest::addColumn<bool>("drags");
        QTest::newRow("enter") << false;
        QTest::newRow("drag") << true;
    }
    void aMovingBodyHasSpeedAndDirection() {
        QFETCH(bool, drags);
        Typist drive(ToolId::Kinematic);
        drive.drag({0, 0}, {2, 1});
        drive.move({4, 4});
        QCOMPARE(drive.toolbox.measures()->kind, TypedKind::SpeedAngle);
        drive.type("0.7", "180");
        if (drags) {
            drive.drag({4, 4}, {5, 5});
        } else {
            QVERIFY(drive.toolbox.enterTyped());
        }
        QVERIFY(drive.body().velocity == Vec2(-0.7, 0));
        QVERIFY(!drive.toolbox.typing());
    }

    void savingLeavesWhatIsBeingTyped() {
        Typist drive(ToolId::Edge);
        drive.document.commit({"change-level"}, {std::make_shared<const Level>(Level{.name = "cave"}), {}});
        drive.click({{0, 0}, {2, 0}});
        drive.type("2", "45");
        drive.document.markSaved();
        QVERIFY(drive.toolbox.typing());
        QVERIFY(drive.toolbox.enterTyped());
        drive.type("1");
        drive.document.undo(); // which is another level
        QVERIFY(!drive.toolbox.typing());
    }

    void typingEndsWithTheShape_data() {
        QTest::addColumn<int>("how");
        QTest::newRow("secondary") << 0;
        QTest::newRow("another tool") << 1;
        QTest::newRow("backspace") << 2;
        QTest::newRow("undo of the body") << 3;
    }
    void typingEndsWithTheShape() {
        QFETCH(int, how);
        Typist drive(how == 3 ? ToolId::Kinematic : ToolId::Edge);
        if (how == 3) {
            drive.drag({0, 0}, {2, 1});
        } else {
            drive.click({{0, 0}, {2, 0}});
        }
        drive.move({3, 3});
        drive.type("2");
        QVERIFY(drive.toolbox.typing());
        switch (how) {
        case 0:
            drive.secondaryClick({3, 3});
            break;
        case 1:
            drive.toolbox.choose(ToolId::Select);
            break;
        case 2:
            drive.key(ToolKey::Backspace);
            break;
        default:
            drive.document.undo();
        }
        QVERIFY(!drive.toolbox.typing());
    }
};

SPACETOW_TEST(TypedEntryTest)
#include "typed_entry_test.moc"
